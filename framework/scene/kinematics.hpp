// SPDX-License-Identifier: Apache-2.0
//
// How poses move: over one step under a twist, and about a hinge. Header-only, [any].
#pragma once

#include "scene/world.hpp"
#include "toolkit/math.hpp"

namespace swage::scene {

/// Pose after time `dt` [s] under the constant twist `V`: p + dt v, exp(dt w) q.
inline toolkit::Pose moved(const toolkit::Pose& X_WB, const swage_twist& V, double dt) {
  return {X_WB.p + dt * toolkit::vec(V.v),
          (toolkit::exp_rotation(dt * toolkit::vec(V.w)) * X_WB.q).normalized()};
}

/// The constant twist that carries X0 to X1 in `dt` [s]; moved(X0, twist_between(X0, X1, dt), dt) = X1.
/// Accurate for slow rotations: no arc cosine.
inline swage_twist twist_between(const toolkit::Pose& X0, const toolkit::Pose& X1, double dt) {
  return {toolkit::raw(toolkit::Vec3((X1.p - X0.p) / dt)),
          toolkit::raw(toolkit::Vec3(toolkit::log_rotation(X1.q * X0.q.conjugate()) / dt))};
}

/// Moves a FOLLOWS or FIXED body to X_WB at the end of this step and gives it the twist that leads there.
/// Contacts take the start of the step from that twist. [rt]
inline void follow(World& world, uint32_t body, const toolkit::Pose& X_WB) {
  world.V_WB[body] = twist_between(toolkit::Pose(world.X_WB[body]), X_WB, world.dt);
  world.X_WB[body] = X_WB.abi();
}

/// Pose of a hinge's child in the world for the pose X_WP of its parent and the angle `angle` [rad].
inline toolkit::Pose hinged(const HingeInfo& hinge, const toolkit::Pose& X_WP, double angle) {
  using namespace toolkit;
  const Vec3 anchor = vec(hinge.anchor);
  const Quat turn = exp_rotation(angle * vec(hinge.axis));
  const Pose X_PC0(hinge.X_PC0);
  return X_WP * Pose(anchor + turn * (X_PC0.p - anchor), turn * X_PC0.q);
}

/// Sets state and inputs of a world to the start: poses of `body`, angles 0, everything else zero; arrays are
/// sized to the fixed part. Private doubles, signals and generators are only cleared. [main]
void reset(World& world);

}  // namespace swage::scene
