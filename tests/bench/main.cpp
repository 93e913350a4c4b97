// SPDX-License-Identifier: Apache-2.0
//
// swage-bench charts|stability|bar|knots|count: what Swage reaches, what its peers reach in the same run, and where both break.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bar.hpp"
#include "charts.hpp"
#include "counted.hpp"
#include "knots.hpp"
#include "stability.hpp"
#include "thesis_tables.hpp"
#include "test_places.hpp"

namespace swage::bench {
namespace {

/// The line under every chart's title.
std::string machine_note() {
  const Hiccups h = hiccups(2);
  char text[200];
  std::snprintf(text, sizeof text,
                "medians of one run, methods interleaved; this machine meanwhile lost %.2g %% of the time in "
                "gaps over 50 us, worst %.2g ms",
                100 * h.lost_share, h.worst_us * 1e-3);
  return text;
}

/// Tables 6-1 and 6-2 of the thesis: three charts and a page.
void draw_tables(const std::string& out, bool quick) {
  const std::vector<TreeRow> tree = table_61(quick ? 1 : 5);
  const std::vector<LoopRow> loop = table_62();
  const std::string note = machine_note();
  for (auto& [name, chart] : {std::pair{"table_6_1", chart_tree(tree)}, {"table_6_1_share", chart_tree_share(tree)}, {"table_6_2", chart_loop(loop)}}) {
    Sweep c = chart;
    c.note = note;
    write(out, name, c);
    std::printf("%s/%s.svg\n", out.c_str(), name);
  }
  const std::string page = out + "/thesis_tables.md";
  std::ofstream file(page);
  file << thesis_page(tree, loop, note);
  if (!file.flush()) throw std::runtime_error("cannot write " + page);
  std::printf("%s\n", page.c_str());
}

int run_charts(const std::string& out, bool quick, const std::string& only) {
  std::filesystem::create_directories(out);
  int drawn = 0;
  if (std::string("tables").starts_with(only)) draw_tables(out, quick), ++drawn;
  if (std::string("directions").starts_with(only) && !ode_methods().empty()) {
    Sweep c = chart_directions(quick);
    c.note = machine_note();
    write(out, "thread_directions", c);
    std::printf("%s/thread_directions.svg\n", out.c_str());
    ++drawn;
  }
  for (const ChartOf& chart : kCharts) {
    if (!std::string(chart.name).starts_with(only)) continue;
    Scatter c = chart.draw(quick);
    c.note = machine_note();
    const std::string name = std::string("work_precision_") + chart.name;
    write(out, name, c);
    std::printf("%s/%s.svg\n", out.c_str(), name.c_str());
    std::fflush(stdout);
    ++drawn;
  }
  if (drawn == 0)
    throw std::runtime_error("no chart \"" + only +
                             "\"; there are query, free, grasp, slip, bend, keep, dent, thread, directions (with ODE), tables");
  return 0;
}

int run_stability(const std::string& scenes, const std::string& out, bool quick, const std::string& only) {
  if (!out.empty()) std::filesystem::create_directories(out);
  std::vector<std::string> files;
  for (const auto& entry : std::filesystem::directory_iterator(scenes))
    if (entry.path().extension() == ".json") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  int broken = 0, ran = 0;
  const std::string note = quick ? "quick subset" : machine_note();
  for (const std::string& file : files) {
    const StabilityScene scene = read_scene(file, quick);
    if (!only.empty() && scene.id.rfind(only, 0) != 0) continue;
    StabilityResult r = run_scene(scene);
    ++ran;
    r.chart.note = note;
    std::printf("%-5s %-62s %s\n", scene.id.c_str(), scene.title.c_str(),
                !r.remarks.empty()   ? "NOT HELD"
                : scene.open.empty() ? "held"
                                     : ("open: " + scene.open).c_str());
    for (const auto& line : r.chart.lines) {
      std::printf("        %-38s", line.name.c_str());
      for (const auto& [x, y] : line.points) std::printf(" %.3g:%.3g", x, y);
      std::printf("%s\n", line.broke ? "  broke" : "");
    }
    for (const std::string& remark : r.remarks) std::printf("      ! %s\n", remark.c_str());
    std::fflush(stdout);
    broken += !r.remarks.empty();
    if (!out.empty()) write(out, "stability_" + std::filesystem::path(file).stem().string(), r.chart);
  }
  std::printf("%d scenes, %d not held\n", ran, broken);
  return ran == 0 || broken ? 1 : 0;
}

void print(const Line& l) {
  char bound[64];
  if (!std::isfinite(l.high))
    std::snprintf(bound, sizeof bound, "at least %.4g", l.low);
  else if (std::isfinite(l.low) && l.low < l.high)
    std::snprintf(bound, sizeof bound, "%.4g to %.4g", l.low, l.high);
  else
    std::snprintf(bound, sizeof bound, "%s %.4g", std::isfinite(l.low) ? "exactly" : "at most", l.high);
  std::printf("%-4s %-66s %10.4g %-4s %-18s %s%s%s\n", l.goal.c_str(), l.name.c_str(), l.measured,
              l.unit.c_str(), bound,
              !l.available ? "NOT MEASURED"
              : l.held()   ? "held"
                           : "NOT HELD",
              l.note.empty() ? "" : "  ", l.note.c_str());
  std::fflush(stdout);
}

nlohmann::json as_object(const Line& l) {
  return {{"goal", l.goal},           {"name", l.name},   {"unit", l.unit},
          {"measured", l.measured},   {"low", l.low},     {"high", l.high},
          {"available", l.available}, {"held", l.held()}, {"note", l.note}};
}

std::string goal_names() {
  std::string all;
  for (const Goal& g : goals()) all += (all.empty() ? "" : ", ") + std::string(g.name);
  return all;
}

int run_bar(bool quick, bool as_json, const std::string& only) {
  const Effort effort = quick ? Effort::quick() : Effort{};
  nlohmann::json all = nlohmann::json::array();
  int missed = 0;
  for (const Goal& goal : goals()) {
    if (!std::string(goal.name).starts_with(only)) continue;
    for (const Line& line : goal.measure(effort)) {
      missed += !line.held();
      all.push_back(as_object(line));
      if (!as_json) print(line);
    }
  }
  if (all.empty()) throw std::runtime_error("no goal \"" + only + "\"; there are " + goal_names());
  if (as_json)
    std::printf("%s\n", all.dump(2).c_str());
  else
    std::printf("%zu lines, %d not held\n", all.size(), missed);
  return missed ? 1 : 0;
}

}  // namespace
}  // namespace swage::bench

int main(int argc, char** argv) {
  using namespace swage::bench;
  CLI::App app{"Swage against closed forms and against its peers"};
  app.require_subcommand(1);
  bool quick = false, as_json = false;
  std::string charts_out = "resources/charts", out, only, scenes = SWAGE_SOURCE_DIR "/tests/stability";
  auto* charts = app.add_subcommand("charts", "error against cost of every method and peer, as SVG and CSV");
  charts->add_option("--out", charts_out, "folder")->capture_default_str();
  charts->add_option("--only", only, "one of query, free, grasp, slip, bend, keep, dent, thread, tables");
  charts->add_flag("--quick", quick, "fewer poses and shorter runs");
  auto* stability =
      app.add_subcommand("stability", "sweeps every scene of the catalogue to where methods break");
  stability->add_option("--out", out, "folder for the plots; none are written without it");
  stability->add_option("--scenes", scenes, "folder of the scene files");
  stability->add_option("--only", only, "scenes whose id begins so, e.g. S04");
  stability->add_flag("--quick", quick, "the subset that the tests run");
  auto* bar = app.add_subcommand(
      "bar", "every promise: measured, bound, held or not; exits 1 when one does not hold");
  bar->add_flag("--quick", quick, "shorter holds, fewer passes");
  bar->add_flag("--json", as_json, "print JSON");
  bar->add_option("--only", only, "goals whose name begins so: " + goal_names());
  KnotsWanted knots_wanted;
  auto* knots = app.add_subcommand("knots", "pulls knots that are drawn tight: which hold, over friction and pretension; exits 1 when a pull is not to be trusted");
  knots->add_option("--out", knots_wanted.out, "folder for table and charts; none are written without it");
  knots->add_option("--only", knots_wanted.only, "knots whose name begins so: half, granny, square, surgeon, sliding");
  knots->add_option("--yield", knots_wanted.yield, "strain beyond which the thread stays bent; 0: never")->check(CLI::Range(0.0, 1.0));
  knots->add_option("--hardening", knots_wanted.hardening, "share of its stiffness that is left there")->check(CLI::Range(0.0, 0.95));
  knots->add_option("--load", knots_wanted.load, "N; more than 0.19 pulls to breaking")->capture_default_str();
  knots->add_flag("--quick", knots_wanted.quick, "one pretension, three frictions");
  knots->add_option("--pretensions", knots_wanted.pretensions, "N, with which they are drawn tight");
  knots->add_option("--frictions", knots_wanted.frictions, "of thread on thread");
  CountWanted count_wanted;
  auto* count = app.add_subcommand("count", "how much the steps of one scene take, in directions and multiply-adds, and a hash of its steps");
  count->add_option("--scene", count_wanted.scene, "one of " + count_scenes())->required();
  count->add_option("--every", count_wanted.every, "of so many steps one goes through counted_step(), for callgrind")->capture_default_str();
  count->add_option("--most", count_wanted.most, "search directions allowed in a step; more: exits 1");
  count->add_option("--list", count_wanted.list, "file with a line a step");
  CLI11_PARSE(app, argc, argv);
  knots_wanted.command = "swage-bench";
  for (int i = 1; i < argc; ++i) {
    if (std::string(argv[i]) == "--out")
      ++i;
    else
      knots_wanted.command += std::string(" ") + argv[i];
  }
  try {
    if (*charts) return run_charts(charts_out, quick, only);
    if (*stability) return run_stability(scenes, out, quick, only);
    if (*count) return run_count(count_wanted);
    if (*knots) return run_knots(knots_wanted) > 0 ? 1 : 0;
    return run_bar(quick, as_json, only);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "swage-bench: %s\n", e.what());
    return 2;
  }
}
