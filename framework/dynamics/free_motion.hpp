// SPDX-License-Identifier: Apache-2.0
//
// One rigid body that nothing touches, over one step: a ladder of methods, cheapest first. Equations: README.md.
//
// Units SI. Frames: W world, B body, at the centre of mass along the principal axes. Threads: any; pure functions.
#pragma once

#include "dynamics/euler_top.hpp"
#include "dynamics/options.hpp"
#include "toolkit/math.hpp"

namespace swage::dynamics {

using toolkit::Quat;
using toolkit::Vec3;

/// Pose and motion of one body.
struct RigidState {
  Vec3 p_W;  // m
  Quat q_WB;
  Vec3 v_W;  // m/s
  Vec3 w_W;  // rad/s
};

/// Constants of a rigid body, prepared on [main].
struct RigidMass {
  double mass = 1;        // kg
  Vec3 I = Vec3::Ones();  // kg m2, principal
  Vec3 inv_I = Vec3::Ones();

  // the nearest symmetric top: axis i, equal moments I[j] across; axis k carries the remainder
  int i = 0, j = 1, k = 2;
  double top = 0;   // 1/I[i] - 1/I[j]
  double rest = 0;  // 1/I[k] - 1/I[j]

  EulerTop euler;

  RigidMass() = default;
  RigidMass(double mass_kg, const Vec3& principal);
};

/// Moves `s` by h [s] under the force f_W [N] at the centre of mass and the torque t_W [N m], both constant
/// in W. Translation is exact except for kThesis (explicit Euler) and kSymplecticEuler.
void move_free(FreeMotion method, const RigidMass& m, const Vec3& f_W, const Vec3& t_W, double h,
               RigidState& s) noexcept;

}  // namespace swage::dynamics
