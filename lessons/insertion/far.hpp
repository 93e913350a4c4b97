// SPDX-License-Identifier: Apache-2.0
//
// The far edge of a wound in a bite through both edges: in at its inner face, out at its surface. Pure arithmetic on the signals of the
// coupling that pierces this edge. Units m, rad. [rt]
#pragma once

#include <algorithm>
#include <cmath>

#include "stitch.hpp"

namespace swage::lesson_insertion {

/// Requirements on a bite through two edges.
struct FarRules {
  bool there = false;
  // m, allowed difference of the depths at which the point left the near edge and entered the far one; 0.2 mm for walls of 0.4 mm: with
  // a step of more than half a wall the edges do not heal together. 0: not required
  double step = 0;
};

/// Observations of the far edge in one step.
struct FarLook {
  bool in_tissue = false;
  bool entered = false, exited = false, passed = false, deflected = false;  // events of this step
  double angle = 0, cosine = 0, s = 0;                                      // rad, 1, 1: as Look has for the near edge
  double exit_angle = 0;                                                    // rad, with `exited`
  Vec3 entry_W = Vec3::Zero();                                              // m
  double arc_error = 0, pull = 0;                                           // m, N
  double wound = 0;                                                         // 1, wound of its inner face, as Look::wound
  double exit_wound = 0;                                                    // 1, wound of its outer surface; 0 before
  Hole hole;                                                                // with `entered` and `exited`
  bool needle_astray = false, jaws_astray = false;
};

/// Doubles only.
struct FarState {
  double near_out = 0, near_passed = 0;   // 0 or 1: the point has left the near edge; the blunt end is in it
  double in = 0, passed = 0;              // 0 or 1: this bite reached the far edge through the near one; the blunt end is in the far edge
  double first = 0;                       // number of entries into the far edge without the near one
  double near_edge = 0, far_edge = 0;     // m, distance of the inner holes from their edges
  double entry_angle = 0;                 // rad, of the last entry into the far edge
  double worst_step = 0, worst_wound = 0;  // m, 1: of finished stitches
  double tracked = 0, last_s = 0;         // as Memory has for the near edge
};

class FarEdge {
 public:
  /// Notes an entry into the far edge; true if the point did not come through the near edge.
  static bool enter(FarState& s, const FarLook& look, bool in_near) noexcept {
    s.tracked = 0;
    s.in = in_near && s.near_out != 0 ? 1 : 0;
    if (s.in == 0) s.first += 1;
    s.entry_angle = look.angle;
    s.far_edge = look.hole.edge;
    return s.in == 0;
  }
  static bool uneven(const FarRules& rules, const FarState& s) noexcept { return rules.step > 0 && step(s) > rules.step; }
  /// Difference of the depths at which the two inner faces were pierced, m; 0 until the point has crossed the gap.
  static double step(const FarState& s) noexcept { return s.in != 0 ? std::abs(s.near_edge - s.far_edge) : 0; }
  static void finish(FarState& s, double wound) noexcept {
    const double worst_step = std::max(s.worst_step, step(s)), worst_wound = std::max(s.worst_wound, wound);
    s = {.first = s.first, .worst_step = worst_step, .worst_wound = worst_wound};
  }
  /// Points deducted, of 15; none up to half of the allowed step.
  static double points(const FarRules& rules, const FarState& s) noexcept {
    if (!(rules.step > 0)) return 0;
    return 15 * std::clamp(2 * std::max(s.worst_step, step(s)) / rules.step - 1, 0.0, 1.0);
  }
};

}  // namespace swage::lesson_insertion
