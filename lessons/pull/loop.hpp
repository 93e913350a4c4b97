// SPDX-License-Identifier: Apache-2.0
//
// The loop of a knot about a pin, read off the places of its thread: where it turns, and how much thread it has.
#pragma once

#include <algorithm>
#include <cmath>
#include <span>

#include "toolkit/segment.hpp"

namespace swage::lesson_pull {

using toolkit::Vec3;

/// Places of a thread at equal arc lengths, both ends included.
struct Places {
  std::span<const double> p_W;  // m, three numbers for each
  double apart = 0;             // m, arc length from one to the next

  int count() const { return static_cast<int>(p_W.size() / 3); }
  Vec3 at(int i) const { return Eigen::Map<const Vec3>(p_W.data() + 3 * i); }
  toolkit::Segment piece(int i) const { return {at(i), at(i + 1)}; }
};

/// The place that is nearest to the line through `p_W` along the unit vector `axis_W`, of those from `low` to `high`.
inline int turn_about(const Places& thread, const Vec3& p_W, const Vec3& axis_W, int low, int high) {
  int best = low;
  double least = HUGE_VAL;  // m^2
  for (int i = low; i <= high; ++i) {
    const double off = (thread.at(i) - p_W).cross(axis_W).squaredNorm();
    if (off < least) least = off, best = i;
  }
  return best;
}

/// Arc length [m] of the loop about place `turn`: from where its two strands first come nearer than `throat` [m], centre to centre, which is
/// where they enter the knot. Infinite where they nowhere do. It is a length of unloaded material, so stretch is not in it.
inline double loop_length(const Places& thread, int turn, double throat) {
  // In throats: neighbours along the thread are near each other, too. A pin is much thicker than the thread, so that half a turn about it is not.
  constexpr double kNeighbours = 4;
  double found = HUGE_VAL;
  const int pieces = thread.count() - 1, first = 1 + static_cast<int>(std::ceil(kNeighbours * throat / thread.apart));
  // pairs of pieces on both sides of the turn, those with the least thread between them first
  for (int between = first; between < pieces && found == HUGE_VAL; ++between)
    for (int i = std::max(0, turn - between); i < turn && i + between < pieces; ++i) {
      const int j = i + between;
      if (j <= turn) continue;
      const toolkit::Segment a = thread.piece(i), b = thread.piece(j);
      const toolkit::SegmentPair near = closest(a, b);
      if ((a.point(near.s) - b.point(near.t)).squaredNorm() > throat * throat) continue;
      found = std::min(found, thread.apart * (between + near.t - near.s));
    }
  return found;
}

}  // namespace swage::lesson_pull
