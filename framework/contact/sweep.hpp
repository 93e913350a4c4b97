// SPDX-License-Identifier: Apache-2.0
//
// When two moving solids first touch within a step: conservative advancement. Time is advanced by gap over speed, a step
// that can never jump over a contact, until the gap is closed or the step is over.
//
// Units: m; time as a share of the step. Threads: any; nothing allocates or throws.
#pragma once

#include <algorithm>

#include "contact/narrow_phase.hpp"

namespace swage::contact {

/// Bodies that move less than the thickness of their wires, or than this share of the scene's length (20 um for a 1 mm
/// scene) when they have sharp edges, cannot pass through each other and are not swept.
inline constexpr double kSweepFrom = 0.02;
inline double swept_from(const Solid& a, const Solid& b, double length) {
  return std::max(a.radius + b.radius, kSweepFrom * length);
}

/// Swept bodies touch when their gap is below this share of the scene's length (1 um for a 1 mm scene): the pose only
/// serves to find the features that meet, for which a fiftieth of a wire's radius is near enough.
inline constexpr double kTouchGap = 1e-3;

/// Motion of a body over one step: constant velocity and spin.
struct Motion {
  Pose X0;                   // X_WB at the start
  Vec3 d = Vec3::Zero();     // m, displacement of the body's origin
  Vec3 turn = Vec3::Zero();  // rad, rotation vector

  Pose at(double t) const {
    if (turn.isZero(0)) return {X0.p + t * d, X0.q};
    return t > 0 ? Pose(X0.p + t * d, toolkit::exp_rotation(t * turn) * X0.q) : X0;
  }
};

/// A bound on the displacement of any point of a relative to b over the step, m. Small when both move together.
double relative_motion(const Solid& a, const Motion& motion_a, const Motion& motion_b) noexcept;

struct FirstTouch {
  bool hit = false;
  double t = 1;  // share of the step, 0..1
};

/// First time at which the gap is at most `tolerance`; 0 when a and b overlap at the start. Bodies that slide closely past each
/// other may be reported early, or although they miss; never late.
FirstTouch first_touch(const Solid& a, const Motion& motion_a, const Solid& b, const Motion& motion_b,
                       double tolerance, Separation& memory, Manifold& work) noexcept;

}  // namespace swage::contact
