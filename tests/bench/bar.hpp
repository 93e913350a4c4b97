// SPDX-License-Identifier: Apache-2.0
//
// The bar: what Swage promises to hold, measured against peers in the same run.
#pragma once

#include <string>
#include <vector>

#include "scenario.hpp"

namespace swage::bench {

/// One promise. Ratios are against a peer in the same run; a peer that is not installed leaves the line
/// unmeasured.
struct Line {
  std::string goal;  // "G1"
  std::string name;  // "grasped phase over ODE trimesh"
  std::string unit;  // "x", "um", "deg", "1"
  double measured = 0;
  double low = 0, high = 0;  // inclusive
  bool available = true;
  std::string note;

  bool held() const { return available && measured >= low && measured <= high; }
};

struct Effort {
  double hold_seconds = 60;  // of S04 to S06
  int passes = 5;            // of timing runs, interleaved with the peers
  static Effort quick() { return {2, 2}; }
};

std::vector<Line> bar_queries(const Effort&);  // G1, G7 speed, S01, table 6-1
std::vector<Line> bar_grasp(const Effort&);    // G2, S04 to S06
std::vector<Line> bar_pinch(const Effort&);    // G3
std::vector<Line> bar_free(const Effort&);     // G6
std::vector<Line> bar_tunnel(const Effort&);   // G7

}  // namespace swage::bench
