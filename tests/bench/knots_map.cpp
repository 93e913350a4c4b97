// SPDX-License-Identifier: Apache-2.0
#include "knots_map.hpp"

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <utility>

#include "chart_frame.hpp"

namespace swage::bench {
namespace {

using draw::text;

constexpr double kLeft = 290, kTop = 96, kCell = 92, kHigh = 40;  // pixels

/// Colours of Okabe and Ito; each cell says its verdict in words too.
struct Look {
  const char *verdict, *fill, *ink;
};
constexpr Look kLooks[] = {{"holds", "#0072b2", "white"}, {"breaks", "#222222", "white"}, {"slips", "#f6d5b5", "#222"}, {"not tight", "#dddddd", "#222"}};

const Look& look(const std::string& verdict) {
  const auto found = std::find_if(std::begin(kLooks), std::end(kLooks), [&](const Look& l) { return verdict == l.verdict; });
  return found == std::end(kLooks) ? kLooks[3] : *found;
}

template <class T>
size_t index_in(std::vector<T>& all, const T& one) {
  const auto found = std::find(all.begin(), all.end(), one);
  if (found != all.end()) return static_cast<size_t>(found - all.begin());
  all.push_back(one);
  return all.size() - 1;
}

void draw_cell(std::ostringstream& o, double x, double y, const KnotCell& cell) {
  const Look& l = look(cell.verdict);
  o << "<rect x='" << x << "' y='" << y << "' width='" << kCell - 4 << "' height='" << kHigh - 4 << "' fill='" << l.fill << "'/>\n";
  const std::string ink = std::string("text-anchor='middle' fill='") + l.ink + "'";
  char force[40];
  std::snprintf(force, sizeof force, "%.1f mN", 1e3 * cell.most);
  text(o, x + kCell / 2 - 2, y + 15, cell.doubtful ? cell.verdict + " ?" : cell.verdict, (ink + " font-weight='bold'").c_str());
  text(o, x + kCell / 2 - 2, y + 30, force, ink.c_str());
}

}  // namespace

std::string knot_map(const std::string& title, const std::string& note, const std::vector<KnotCell>& cells) {
  std::vector<std::pair<double, std::string>> rows;  // pretension, knot
  std::vector<double> columns;                       // friction
  for (const KnotCell& c : cells) index_in(rows, {c.pretension, c.knot}), index_in(columns, c.friction);
  std::sort(columns.begin(), columns.end());
  const double width = std::max(760.0, kLeft + kCell * static_cast<double>(columns.size()) + 20);
  const double bottom = kTop + kHigh * static_cast<double>(rows.size());
  std::ostringstream o;
  o << "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 " << width << ' ' << bottom + 50
    << "' font-family='DejaVu Sans, Arial, sans-serif' font-size='12' fill='#222'>\n<rect width='100%' height='100%' fill='white'/>\n";
  text(o, 20, 28, title, "font-size='17' font-weight='bold'");
  text(o, 20, 48, note, "font-size='11' fill='#666'");
  text(o, kLeft, 70, "friction of thread on thread", "font-size='13'");
  for (size_t i = 0; i < columns.size(); ++i)
    text(o, kLeft + kCell * (static_cast<double>(i) + 0.5) - 2, kTop - 8, draw::number(columns[i]), "text-anchor='middle'");
  for (size_t i = 0; i < rows.size(); ++i) {
    char name[80];
    std::snprintf(name, sizeof name, "%s, tied with %.0f mN", rows[i].second.c_str(), 1e3 * rows[i].first);
    text(o, kLeft - 10, kTop + kHigh * (static_cast<double>(i) + 0.5) + 2, name, "text-anchor='end'");
  }
  for (const KnotCell& c : cells)
    draw_cell(o, kLeft + kCell * static_cast<double>(index_in(columns, c.friction)),
              kTop + kHigh * static_cast<double>(index_in(rows, {c.pretension, c.knot})), c);
  text(o, 20, bottom + 24, "Below the verdict: the greatest tension that a leg bore. A question mark: the thread passed through itself, or a tenth of the steps", "font-size='11' fill='#666'");
  text(o, 20, bottom + 40, "did not converge.", "font-size='11' fill='#666'");
  o << "</svg>\n";
  return o.str();
}

}  // namespace swage::bench
