// SPDX-License-Identifier: Apache-2.0
//
// Tables 6-1 and 6-2 of the thesis with our figures beside its own, which a Pentium 4 of 2.6 GHz gave.
#pragma once

#include <string>
#include <vector>

#include "chart.hpp"

namespace swage::bench {

inline constexpr double kThesisLoop_us = 613.44, kThesisPicture_us = 2862.8;  // table 6-2, means

/// Figures of a tree: the mean of a query and its range, and the time that the tree takes to build.
struct TreeFigures {
  double mean_us = 0, low_us = 0, high_us = 0, build_ms = 0;
};
struct TreeRow {
  int levels = 0;  // 0: no tree
  TreeFigures thesis, ours = {};
  int differ = 0;  // poses of 10,000 whose contacts are not those of brute force
};
/// Table 6-1: needle of 100 spheres against 8 planes and 12 edges at 10,000 poses.
std::vector<TreeRow> table_61(int passes);

struct LoopRow {
  std::string name, family;
  std::vector<double> ns;  // 10,000 loops
};
/// Table 6-2: the whole loop of the thesis, and ours.
std::vector<LoopRow> table_62();

Sweep chart_tree(const std::vector<TreeRow>&);        // mean of a query by levels of the tree
Sweep chart_tree_share(const std::vector<TreeRow>&);  // the same over that without a tree
Sweep chart_loop(const std::vector<LoopRow>&);        // share of loops that take longer
/// Both tables as a page (Markdown); `note` says how quiet the machine was.
std::string thesis_page(const std::vector<TreeRow>&, const std::vector<LoopRow>&, const std::string& note);

}  // namespace swage::bench
