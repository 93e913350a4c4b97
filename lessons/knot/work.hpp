// SPDX-License-Identifier: Apache-2.0
//
// What is told of a knot and its two hands beside what is judged: the air gap below the knot, idle time, grasps of the thread. Header-only,
// pure, [rt]. Derivation: knot.md.
#pragma once

#include <algorithm>
#include <cmath>

#include "common/measures.hpp"
#include "toolkit/math.hpp"

namespace swage::lesson_knot {

using toolkit::Vec3;

/// The loop of a stitch: lengths of thread [m] from its first end, which is the long one, so that `exit` is less than `entry`.
struct Loop {
  double exit = 0, entry = 0;  // the holes from which the two legs rise to the knot
  double length = 0;           // m, of thread from one strand of the first throw to the other, through the tissue
  double diameter = 0;         // m, of the thread
  Vec3 out_W = Vec3::UnitZ();  // unit, out of the tissue
};

/// m: how high the first throw stands over the straight way from hole to hole, less one diameter of the thread, which a knot that lies on
/// the tissue has as well. `place(s)`: the thread's centre line in W. Both legs together are what of the loop is not in the tissue; the
/// throw is where they come nearest to each other.
template <class Place>
double air_gap(const Loop& loop, const Place& place) noexcept {
  const double legs = loop.length - (loop.entry - loop.exit);
  if (!(legs > 0)) return 0;
  constexpr int kTries = 32;
  double nearest = HUGE_VAL;
  Vec3 knot = Vec3::Zero();
  for (int i = 0; i <= kTries; ++i) {
    const double x = legs * i / kTries;
    const Vec3 a = place(loop.exit - x), b = place(loop.entry + legs - x);
    if ((a - b).norm() >= nearest) continue;
    nearest = (a - b).norm();
    knot = 0.5 * (a + b);
  }
  const Vec3 from = place(loop.exit), way = place(loop.entry) - from;
  const double share = way.squaredNorm() > 0 ? std::clamp((knot - from).dot(way) / way.squaredNorm(), 0.0, 1.0) : 0;
  return std::max(0.0, (knot - from - share * way).dot(loop.out_W) - loop.diameter);
}

/// Doubles only.
struct WorkState {
  lessons::IdleState idle[2];  // winder, holder
  double had[2] = {0, 0}, grasps[2] = {0, 0};
  double gap = -1;  // m; negative: no knot yet
};

struct WorkWatch {
  /// Of one hand: `has` the thread, its tips, jaws and force; `counts`: it has set off and the knot is not being kept.
  static void look(WorkState& s, int hand, bool has, const Vec3& voluntary_W, double opening, double force, double dt, bool counts) noexcept {
    if (has && s.had[hand] == 0) s.grasps[hand] += 1;
    s.had[hand] = has ? 1 : 0;
    lessons::IdleWatch::look(s.idle[hand], voluntary_W, opening, force, dt, counts);
  }
  /// Grasps of the thread after the first of each hand.
  static double regrasps(const WorkState& s) noexcept { return std::max(0.0, s.grasps[0] - 1) + std::max(0.0, s.grasps[1] - 1); }
  /// Share of the time at work in which an instrument did nothing, mean of both.
  static double idle(const WorkState& s) noexcept {
    return 0.5 * (lessons::IdleWatch::share(s.idle[0]) + lessons::IdleWatch::share(s.idle[1]));
  }
};

}  // namespace swage::lesson_knot
