// SPDX-License-Identifier: Apache-2.0
//
// A compliant link between two bodies and its law: along its axis a bristle that slides beyond a limit, across it a spring that
// gives way beyond its strength. Both limits are constants of the step, so the force is minus the gradient of a convex energy.
//
//     f_along  = clamp(-k_along s, -forward, backward)
//     f_across = -k_across s,  returned radially to `strength`
//
// Header-only, [rt].
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "dynamics/contact_law.hpp"
#include "scene/world.hpp"
#include "toolkit/math.hpp"

namespace swage::dynamics {

using toolkit::Vec3;

struct TieLaw {
  double k_across = 0, k_along = 0;  // N/m
  double strength = HUGE_VAL;        // N
  double forward_limit = HUGE_VAL;   // N, holds a back that moves along +axis
  double backward_limit = HUGE_VAL;  // N, along -axis
};

/// One tie of a step. Frame W, global bodies; kNone: the world.
struct Tie {
  uint32_t body_a = scene::kNone, body_b = scene::kNone;
  Vec3 p_W = Vec3::Zero();       // m, where it acts on both, at the predicted poses
  Vec3 axis_W = Vec3::UnitX();   // unit
  Vec3 offset_W = Vec3::Zero();  // m, of a against b from rest, at the predicted poses
  TieLaw law;
  // --- results of the solve
  Vec3 f_a_W = Vec3::Zero();           // N on a
  Vec3 plastic_slip_W = Vec3::Zero();  // m, plastic part of the displacement
};

/// Force on a. In the axes of the tie, g is along and s1, s2 are across.
inline Force tie_force(const TieLaw& law, const Displacement& d) {
  Force f;
  f.fn = std::clamp(-law.k_along * d.g, -law.forward_limit, law.backward_limit);
  f.f1 = -law.k_across * d.s1, f.f2 = -law.k_across * d.s2;
  const double across = std::sqrt(f.f1 * f.f1 + f.f2 * f.f2);
  f.slips = across > law.strength;
  if (f.slips) f.f1 *= law.strength / across, f.f2 *= law.strength / across;
  return f;
}

/// -d force / d displacement: symmetric, positive semi-definite.
inline Tangent tie_tangent(const TieLaw& law, const Displacement& d) {
  Tangent t;
  const double along = -law.k_along * d.g;
  if (along >= -law.forward_limit && along <= law.backward_limit) t.nn = law.k_along;
  const double length = std::sqrt(d.s1 * d.s1 + d.s2 * d.s2);
  if (law.k_across * length <= law.strength) {
    t.t11 = t.t22 = law.k_across;
    return t;
  }
  const double e1 = d.s1 / length, e2 = d.s2 / length, k = law.strength / length;
  t.t11 = k * e2 * e2, t.t12 = -k * e1 * e2, t.t22 = k * e1 * e1;
  return t;
}

/// The plastic part of the displacement: slip along, yielding across [m].
inline Displacement tie_plastic_slip(const TieLaw& law, const Displacement& d, const Force& f) {
  Displacement slid;
  if (law.k_along > 0) slid.g = d.g + f.fn / law.k_along;
  if (law.k_across > 0) slid.s1 = d.s1 + f.f1 / law.k_across, slid.s2 = d.s2 + f.f2 / law.k_across;
  return slid;
}

/// Energy whose gradient is minus the force [J].
inline double tie_energy(const TieLaw& law, const Displacement& d) {
  const double most = d.g > 0 ? law.forward_limit : law.backward_limit, s = std::abs(d.g);
  const double along =
      law.k_along * s <= most ? 0.5 * law.k_along * s * s : most * (s - 0.5 * most / law.k_along);
  const double r = std::sqrt(d.s1 * d.s1 + d.s2 * d.s2);
  const double across = law.k_across * r <= law.strength
                            ? 0.5 * law.k_across * r * r
                            : law.strength * (r - 0.5 * law.strength / law.k_across);
  return along + across;
}

}  // namespace swage::dynamics
