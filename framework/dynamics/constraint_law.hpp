// SPDX-License-Identifier: Apache-2.0
//
// The law of a constraint, a contact or a tie: force, tangent (minus the derivative of the force) and, with the friction limit held,
// a convex energy whose gradient is minus the force. One test checks all (tests/unit/dynamics/constraint_law.cpp); a hinge drive
// (hinge_drive.hpp) has the same three. Header-only, pure functions, [rt].
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

// --- piece by piece

inline Pieces pieces(const Constraint& c, const Displacement& u) {
  return c.tie ? Pieces{Piece::kOpen, tie_pieces(*c.tie, u)} : Pieces{piece(c.surface, u), {}};
}
inline Force force_on(const Constraint& c, const Displacement& u) {
  return c.tie ? tie_force_on(c.on.tie, *c.tie, u) : force_on(c.on.contact, c.surface, u);
}
inline Tangent tangent_on(const Constraint& c, const Displacement& u) {
  return c.tie ? tie_tangent_on(c.on.tie, *c.tie, u) : tangent_on(c.on.contact, c.surface, u);
}
/// The t at which u + t e leaves the present pieces, and the pieces beyond; infinite where it never does.
inline double kink(const Constraint& c, const Displacement& u, const Displacement& e, Pieces& next) {
  next = c.on;
  if (c.tie) {
    const TieKink k = tie_kink(c.on.tie, *c.tie, u, e);
    next.tie = k.next;
    return k.t;
  }
  const Kink k = kink(c.on.contact, c.surface, u, e);
  next.contact = k.next;
  return k.t;
}

/// Energy with the friction limit held [J].
inline double constraint_energy(const Constraint& c, const Displacement& u, double limit) {
  return c.tie ? tie_energy(*c.tie, u) : tresca_energy(c.surface, u, limit);
}

}  // namespace swage::dynamics
