// SPDX-License-Identifier: Apache-2.0
//
// The law of a constraint, a contact or a tie: force, tangent and energy at a displacement. Each is the derivative of the next,
// which one test checks for all (tests/unit/dynamics/constraint_law.cpp); a hinge drive (hinge_drive.hpp) answers the same three.
// With its friction limit held the force is minus the gradient of a convex energy. Header-only, pure functions, [rt].
#pragma once

#include "dynamics/island.hpp"

namespace swage::dynamics {

/// `limit`: the friction limit [N]; read for a contact whose limit is held, else written by Coulomb's law.
inline Force constraint_force(const Constraint& c, const Displacement& u, Friction friction, double& limit) {
  if (c.tie) return tie_force(*c.tie, u);
  const double fn = normal_force(c.surface, u.g);
  if (friction == Friction::kCoulomb) limit = c.surface.mu * fn;
  return force_with_limit(c.surface, u, fn, limit);
}

/// Tangent of the piece of the law that `f`, the force at u, is on.
inline Tangent constraint_tangent(const Constraint& c, const Displacement& u, const Force& f,
                                  Friction friction, double limit) {
  if (c.tie) return tie_tangent(*c.tie, u);
  if (!(f.fn > 0 || limit > 0)) return {};
  return tangent(c.surface, u, f, limit, friction == Friction::kCoulomb);
}

/// With the limit held [J].
inline double constraint_energy(const Constraint& c, const Displacement& u, double limit) {
  return c.tie ? tie_energy(*c.tie, u) : tresca_energy(c.surface, u, limit);
}

}  // namespace swage::dynamics
