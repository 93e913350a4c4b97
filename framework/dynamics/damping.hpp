// SPDX-License-Identifier: Apache-2.0
//
// Damping of linear and angular motion, as the environment of a lesson sets it (thesis 4.1.10):
//
//   f = -k_d v   (4.15)        t = -k_t w   (4.16)
//
// Both are linear, so their flow over a step is an exponential. The forces here lead exactly to its end: under a constant F the speed
// becomes v + (1 - exp(-k_d h / m)) (F / k_d - v), and the same about each principal axis with k_t and the moment of inertia. For a
// body that a contact holds F = 0, as the contact bears its loads: the damping there is that of the speed alone.
// Stable for every step length: damping never reverses the motion. Units SI. Frame W. [rt]
#pragma once

#include <cmath>

#include "scene/world.hpp"
#include "toolkit/math.hpp"

namespace swage::dynamics {

/// One component: the damping [N] of the speed v [m/s] of the mass m [kg] beside the force F [N], over a step h [s].
inline double damping(double k, double m, double v, double F, double h) {
  const double lost = -std::expm1(-k / m * h);
  return m / h * lost * (F / k - v) - F;
}

/// Adds the damping of one DYNAMIC body to the forces of its object. `held`: contacts bore it in the last step. [rt]
inline void damp(scene::World& world, uint32_t body, bool held) noexcept {
  using toolkit::Vec3;
  const swage_environment& e = world.environment;
  const scene::BodyInfo& info = world.body[body];
  swage_wrench& F = world.F_B_W[body];
  Vec3 f = Vec3::Zero(), t = Vec3::Zero();
  const Vec3 force = held ? Vec3::Zero() : Vec3(toolkit::vec(F.f) + info.mass * toolkit::vec(world.gravity));
  const Vec3 v = toolkit::vec(world.V_WB[body].v);
  for (int i = 0; e.linear_damping > 0 && i < 3; ++i)
    f[i] = damping(e.linear_damping, info.mass, v[i], force[i], world.dt);
  const toolkit::Quat q_WB = toolkit::Pose(world.X_WB[body]).q;
  const Vec3 torque = held ? Vec3::Zero() : Vec3(q_WB.conjugate() * toolkit::vec(F.t));
  const Vec3 w = q_WB.conjugate() * toolkit::vec(world.V_WB[body].w);
  for (int i = 0; e.angular_damping > 0 && i < 3; ++i)
    t[i] = damping(e.angular_damping, info.inertia[i], w[i], torque[i], world.dt);
  F.f = toolkit::raw(Vec3(toolkit::vec(F.f) + f));
  F.t = toolkit::raw(Vec3(toolkit::vec(F.t) + q_WB * t));
}

}  // namespace swage::dynamics
