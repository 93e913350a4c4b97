// SPDX-License-Identifier: Apache-2.0
//
// Whether a thread swings to and fro from one step to the next, which no thread does: what is seen then is the solve, that goes from one of two
// places to the other and back. It was so where a vertex lay beside the edge of a jaw (contact/wire_convex.cpp, length_over_region()).
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "scene/world.hpp"

namespace swage::stage {

class Swinging {
 public:
  static constexpr double kLeast = 5e-6;   // m, displacement of a vertex in a step; in 133 one of 2.4 um is left, for 0.7 s
  static constexpr double kBack = -0.5;    // cosine of the displacements of all vertices in two steps, below which they go back

  /// After each step.
  void look(const scene::World& world) {
    if (world.chain.empty()) return;
    const scene::ChainInfo& chain = world.chain[0];
    const double* now = world.plugin_state.data() + chain.state;
    const size_t n = 3 * chain.start.size();
    if (at_.size() != n) at_.assign(now, now + n), went_.assign(n, 0.0);
    double along = 0, square = 0, before = 0, most = 0;
    for (size_t i = 0; i < n; ++i) {
      const double d = now[i] - at_[i];
      along += d * went_[i], square += d * d, before += went_[i] * went_[i], most = std::max(most, std::abs(d));
      at_[i] = now[i], went_[i] = d;
    }
    const bool back = most > kLeast && along < kBack * std::sqrt(square * before);
    steps_ = back ? steps_ + 1 : 0;
    longest_ = std::max(longest_, steps_);
  }
  /// The most steps in a row in each of which the first chain went back to where it had come from.
  int longest() const { return longest_; }

 private:
  std::vector<double> at_, went_;  // m, vertices and their last displacements
  int steps_ = 0, longest_ = 0;
};

}  // namespace swage::stage
