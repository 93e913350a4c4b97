// SPDX-License-Identifier: Apache-2.0
#include "knots.hpp"

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <vector>

#include "../knots/pull.hpp"
#include "chart.hpp"
#include "knots_map.hpp"

namespace swage::bench {
namespace {

using namespace swage::test;

struct NamedKnot {
  const char* name;
  Word word;
  bool slides = false;  // one strand runs straight through each throw, in the next the other
};
const NamedKnot kKnots[] = {{"half", {1}}, {"granny", {1, 1}}, {"square", {1, -1}}, {"surgeon", {2, -1, 1}}, {"sliding", {1, -1}, true}};

// The promise on a tight knot of three throws: ms of processor time, of 99.9 % of its steps.
constexpr double kMostOfAStep = 0.7;

struct Row {
  const char* knot = "";
  PullTest test;
  PullResult result;
};

int passages(const PullResult& r) { return r.tighten.passages + r.rest.passages + r.pull.passages; }
uint64_t unconverged(const PullResult& r) { return r.tighten.not_converged + r.rest.not_converged + r.pull.not_converged; }
int steps(const PullResult& r) { return r.tighten.steps + r.rest.steps + r.pull.steps; }
size_t bearing(const PullResult& r) { return std::max({r.tighten.bearing, r.rest.bearing, r.pull.bearing}); }
/// What such a pull says is not to be trusted.
bool doubtful(const PullResult& r) { return passages(r) > 0 || unconverged(r) * 10 > static_cast<uint64_t>(steps(r)); }

std::vector<std::string> cells(const Row& row) {
  const PullResult& r = row.result;
  const auto number = [](const char* format, double v) {
    char cell[40];
    std::snprintf(cell, sizeof cell, format, v);
    return std::string(cell);
  };
  return {row.knot,
          text(row.test.word),
          number("%.0f", 1e3 * row.test.pretension),
          number("%.2f", row.test.friction),
          text(r.end),
          number("%.1f", 1e3 * r.most),
          number("%.3f", 1e3 * r.sprung),
          number("%.3f", 1e3 * r.slip[0]),
          number("%.3f", 1e3 * r.slip[1]),
          number("%.0f", static_cast<double>(bearing(r))),
          number("%.0f", passages(r)),
          number("%.0f", static_cast<double>(unconverged(r))),
          number("%.0f", steps(r)),
          number("%.1f", 1e6 * r.overlap),
          number("%.2f", 1e-3 * r.pull.median_us),
          r.same_word ? "same" : "(" + text(r.word) + (r.certain ? ")" : ")?")};
}

constexpr const char* kColumns[] = {"knot",          "word",     "pretension, mN", "friction", "verdict",       "greatest tension, mN",
                                    "sprung, mm",    "slip of tail 1, mm", "slip of tail 2, mm", "contacts that bear", "passages",
                                    "unconverged",   "steps",    "overlap, um",    "a step, ms", "word after"};

void print(const Row& row) {
  for (const std::string& cell : cells(row)) std::printf("%-12s ", cell.c_str());
  std::printf("\n");
  std::fflush(stdout);
}

void write_table(const std::string& out, const std::vector<Row>& rows, const std::string& command) {
  std::ofstream page(out + "/knots.md"), table(out + "/knots.csv");
  page << "# Pull tests of knots\n\nMade by `" << command << "`; what is done and measured is in `tests/knots/pull.hpp`.\n\n|";
  for (const char* c : kColumns) page << ' ' << c << " |", table << (c == kColumns[0] ? "" : ",") << '"' << c << '"';
  page << "\n|";
  for (size_t i = 0; i < std::size(kColumns); ++i) page << " --- |";
  page << '\n', table << '\n';
  for (const Row& row : rows) {
    page << '|';
    bool first = true;
    for (const std::string& cell : cells(row)) page << ' ' << cell << " |", table << (first ? "" : ",") << '"' << cell << '"', first = false;
    page << '\n', table << '\n';
  }
  if (!page.flush() || !table.flush()) throw std::runtime_error("cannot write " + out + "/knots.md");
}

std::string material(const PullTest& test) {
  if (!(test.yield > 0)) return "elastic";
  char text[80];
  std::snprintf(text, sizeof text, "yield %.2g %%", 100 * test.yield);
  return text;
}

/// The tension that each knot bore before it slipped, over friction.
void draw(const std::string& out, const std::vector<Row>& rows, double pretension) {
  Sweep chart;
  char title[160];
  std::snprintf(title, sizeof title, "Knots in 10-0 nylon, %s, drawn tight with %.0f mN, tails let go, pulled apart", material(rows.front().test).c_str(),
                1e3 * pretension);
  chart.title = title;
  chart.note = "tails of 1.8 mm; a line ends in a cross where the thread passed through itself or steps did not converge";
  chart.x = {"friction of thread on thread", 0, 1, false, "", ""};
  chart.y = {"greatest tension of a leg, mN", 0.1, 200, true, "none", ""};
  chart.pass = 1e3 * rows.front().test.load;
  for (const NamedKnot& knot : kKnots) {
    Sweep::Line line{knot.name, std::string(knot.name) + " " + text(knot.word), {}, false};
    for (const Row& row : rows)
      if (row.knot == knot.name && row.test.pretension == pretension) {
        line.points.emplace_back(row.test.friction, std::max(0.1, 1e3 * row.result.most));
        line.broke = line.broke || doubtful(row.result);
      }
    if (!line.points.empty()) chart.lines.push_back(line);
  }
  char name[40];
  std::snprintf(name, sizeof name, "knots_%.0f_mN", 1e3 * pretension);
  write(out, name, chart);
}

/// The map of all that has been pulled so far.
void draw_map(const std::string& out, const std::vector<Row>& rows, const std::string& command) {
  std::vector<KnotCell> cells;
  for (const Row& r : rows)
    cells.push_back({std::string(r.knot) + " " + text(r.test.word), r.test.pretension, r.test.friction, text(r.result.end), r.result.most, doubtful(r.result)});
  char title[160];
  std::snprintf(title, sizeof title, "Knots in 10-0 nylon, %s: what holds %.2g N at the legs, tails let go", material(rows.front().test).c_str(), rows.front().test.load);
  std::ofstream file(out + "/knots_map.svg");
  file << knot_map(title, command, cells);
  if (!file.flush()) throw std::runtime_error("cannot write " + out + "/knots_map.svg");
}

/// A tight surgeon's knot that is kept for two seconds: what its steps cost.
void time_tight() {
  PullTest test;
  test.word = {2, -1, 1}, test.friction = 0.3, test.pretension = test.load = 0.1, test.keep = 2;
  const PullResult r = pull(test);
  std::printf("tight knot of three throws, kept for %d steps: %zu contacts that bear (most), %zu looked at; a step median %.2f ms, p99.9 %.2f ms (promised %.1f): %s\n",
              r.pull.steps, r.pull.bearing, r.pull.contacts, 1e-3 * r.pull.median_us, 1e-3 * r.pull.p999_us, kMostOfAStep,
              1e-3 * r.pull.p999_us <= kMostOfAStep ? "held" : "NOT HELD");
}

}  // namespace

int run_knots(const KnotsWanted& wanted) {
  std::vector<double> pretensions{30e-3, 100e-3, 10e-3}, frictions{0.1, 0.2, 0.25, 0.3, 0.4, 0.6, 1};
  if (wanted.quick) pretensions = {30e-3}, frictions = {0.1, 0.3, 0.6};
  if (!wanted.pretensions.empty()) pretensions = wanted.pretensions;
  if (!wanted.frictions.empty()) frictions = wanted.frictions;
  if (!wanted.out.empty()) std::filesystem::create_directories(wanted.out);
  for (const char* c : kColumns) std::printf("%s%s", c == kColumns[0] ? "" : "; ", c);
  std::printf("\n");
  std::vector<Row> rows;
  int doubted = 0;
  for (const double pretension : pretensions) {
    const size_t before = rows.size();
    for (const double friction : frictions) {
      for (const NamedKnot& knot : kKnots) {
        if (!std::string(knot.name).starts_with(wanted.only)) continue;
        Row row{knot.name, {}, {}};
        row.test.word = knot.word, row.test.friction = friction, row.test.pretension = pretension, row.test.load = wanted.load;
        row.test.yield = wanted.yield, row.test.hardening = wanted.hardening;
        if (knot.slides) row.test.shape.core = 1, row.test.shape.core_swaps = true;
        row.result = pull(row.test);
        doubted += doubtful(row.result);
        print(row);
        rows.push_back(row);
      }
      if (rows.size() == before) throw std::runtime_error("no knot \"" + wanted.only + "\"; there are half, granny, square, surgeon, sliding");
      if (!wanted.out.empty()) write_table(wanted.out, rows, wanted.command), draw(wanted.out, rows, pretension), draw_map(wanted.out, rows, wanted.command);
    }
  }
  if (wanted.only.empty() && !(wanted.yield > 0)) time_tight();
  std::printf("%zu pulls, %d of them not to be trusted (passages, or a tenth of the steps unconverged)\n", rows.size(), doubted);
  return doubted;
}

}  // namespace swage::bench
