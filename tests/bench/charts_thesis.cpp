// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cstdio>

#include "thesis_tables.hpp"
#include "timing.hpp"

namespace swage::bench {
namespace {

template <class... Numbers>
std::string line(const char* format, Numbers... numbers) {
  char text[300];
  std::snprintf(text, sizeof text, format, numbers...);
  return text;
}

std::string levels(const TreeRow& r) { return r.levels == 0 ? "none" : std::to_string(r.levels) + " levels"; }

/// A horizontal line across all levels.
Sweep::Line across(const std::string& name, double y) { return {"", name, {{0, y}, {5, y}}, false}; }

}  // namespace

Sweep chart_tree(const std::vector<TreeRow>& rows) {
  Sweep c;
  c.title = "Table 6-1: one collision query, needle of 100 spheres against 8 planes and 12 edges";
  c.x = {"levels of the sphere tree (0: none)", 0, 5, false, "", ""};
  c.y = {"mean of 10,000 queries, us", 0.1, 1e4, true, "", ""};
  Sweep::Line thesis{"thesis", "thesis, Pentium 4, 2.6 GHz", {}, false}, ours{"swage", "swage, the same tree here", {}, false};
  for (const TreeRow& r : rows) {
    thesis.points.push_back({r.levels, r.thesis.mean_us});
    ours.points.push_back({r.levels, r.ours.mean_us});
  }
  c.lines = {thesis, ours};
  return c;
}

Sweep chart_tree_share(const std::vector<TreeRow>& rows) {
  Sweep c;
  c.title = "Table 6-1: what the sphere tree leaves of the time of a query";
  c.x = {"levels of the sphere tree (0: none)", 0, 5, false, "", ""};
  c.y = {"mean over the mean without a tree", 0, 1, false, "", ""};
  Sweep::Line thesis{"thesis", "thesis, Pentium 4, 2.6 GHz", {}, false}, ours{"swage", "swage, the same tree here", {}, false};
  for (const TreeRow& r : rows) {
    thesis.points.push_back({r.levels, r.thesis.mean_us / rows[0].thesis.mean_us});
    ours.points.push_back({r.levels, r.ours.mean_us / rows[0].ours.mean_us});
  }
  c.lines = {thesis, ours, across("\"cuts down by 50 %\" (6.1.1)", 0.5)};
  return c;
}

Sweep chart_loop(const std::vector<LoopRow>& rows) {
  Sweep c;
  c.title = "Table 6-2: loops of approach, grasp and carry that take longer than";
  c.x = {"time of a loop, us", 0.1, 1e4, true, "", ""};
  c.y = {"share of 10,000 loops that take longer", 1e-4, 1, true, "", ""};
  for (const LoopRow& r : rows) {
    std::vector<double> ns = r.ns;
    std::sort(ns.begin(), ns.end());
    Sweep::Line l{r.family, r.name, {}, false};
    for (const double share : {1.0, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01, 5e-3, 2e-3, 1e-3, 5e-4, 2e-4, 1e-4}) {
      const auto n = static_cast<double>(ns.size());
      l.points.push_back({ns[static_cast<size_t>(std::min(n - 1, (1 - share) * n))] * 1e-3, share});
    }
    c.lines.push_back(l);
  }
  c.lines.push_back({"thesis", "thesis, mean of the dynamics", {{kThesisLoop_us, 1e-4}, {kThesisLoop_us, 1}}, false});
  c.lines.push_back({"", "deadline of 1 kHz", {{1000, 1e-4}, {1000, 1}}, false});
  c.lines.push_back({"thesis", "thesis, mean of the graphics", {{kThesisPicture_us, 1e-4}, {kThesisPicture_us, 1}}, false});
  return c;
}

std::string thesis_page(const std::vector<TreeRow>& tree, const std::vector<LoopRow>& loop, const std::string& note) {
  std::string o =
      "# Tables 6-1 and 6-2 of the thesis, and ours\n\nMade by `swage bench charts --only tables` (" + note +
      "). The thesis's figures are those it prints, of a Pentium 4 of 2.6 GHz: across machines only the\nratios compare. "
      "Its needle of 100 spheres, two tetrahedral jaws of 8 planes and 12 edges, 10,000 poses or loops.\n\n"
      "## Table 6-1: a collision query by depth of the sphere tree\n\n"
      "| tree | thesis: mean (range), us | over no tree | build, ms | ours: mean (range), us | over no tree | build, ms | poses that differ |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  for (const TreeRow& r : tree) {
    const auto build = [&](double ms) { return r.levels == 0 ? std::string("-") : line("%.3g", ms); };
    const auto side = [&](const TreeFigures& f, const TreeFigures& none) {
      return line("%.4g (%.4g to %.4g) | %.2f | ", f.mean_us, f.low_us, f.high_us, f.mean_us / none.mean_us) + build(f.build_ms);
    };
    o += "| " + levels(r) + " | " + side(r.thesis, tree[0].thesis) + " | " + side(r.ours, tree[0].ours) + line(" | %d |\n", r.differ);
  }
  double theirs = 0, ours = 0;
  for (size_t k = 1; k < tree.size(); ++k) {
    theirs += tree[k].thesis.mean_us / tree[0].thesis.mean_us / static_cast<double>(tree.size() - 1);
    ours += tree[k].ours.mean_us / tree[0].ours.mean_us / static_cast<double>(tree.size() - 1);
  }
  o += line("\nThe thesis says that a tree cuts the mean time by 50 %%. Its own table has %.0f %% on average over the three trees; here "
            "it is %.0f %%.\n", 100 * (1 - theirs), 100 * (1 - ours));
  o += "\n![Mean of a query](table_6_1.svg)\n![Mean over no tree](table_6_1_share.svg)\n\n"
       "## Table 6-2: one loop\n\nEach loop is one step of one scene: two jaws approach a needle, grasp it and carry it. The row swage is our step there; below it is "
       "the same with the thesis's\ncontacts, impulses and Euler steps.\n\n| loop | mean, us | 99.9 %, us | longest, us |\n| --- | --- | --- | --- |\n";
  o += line("| thesis, virtual dynamics | %.5g | - | - |\n| thesis, graphic rendering | %.5g | - | - |\n", kThesisLoop_us, kThesisPicture_us);
  for (const LoopRow& r : loop) {
    const Times t = times(r.ns);
    o += "| " + r.name + line(" | %.3g | %.3g | %.3g |\n", t.mean * 1e-3, t.p999 * 1e-3, t.max * 1e-3);
  }
  o += "\n![Loops that take longer](table_6_2.svg)\n\nOur pictures are drawn by a graphics card at the rate of the display, apart from "
       "the loop; their cost depends on the card and is not compared.\n";
  return o;
}

}  // namespace swage::bench
