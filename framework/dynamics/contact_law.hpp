// SPDX-License-Identifier: Apache-2.0
//
// The law of one compliant contact with exact Coulomb friction, as a function of gap and tangential displacement.
//
//     f_n = k max(0, -g)
//     f_t = -k_t s            while k_t |s| <= mu f_n      (stick: an elastic bristle, no creep)
//           -mu f_n s / |s|   beyond                       (slip: the bristle returns radially to the cone)
//
// Header-only, pure functions, [rt].
#pragma once

#include <cmath>

namespace swage::dynamics {

/// Tangential over normal stiffness of two elastic bodies of one material, Mindlin: 2 (1 - nu) / (2 - nu), nu = 0.3.
inline constexpr double kTangentRatio = 0.82;

/// Gap and tangential displacement at the end of the step, in the contact's own axes n, t1, t2 [m].
struct Displacement {
  double g = 0, s1 = 0, s2 = 0;
};

/// Force on a in the same axes [N].
struct Force {
  double fn = 0, f1 = 0, f2 = 0;
  bool slips = false;
};

/// -d(fn, f1, f2) / d(g, s1, s2) [N/m]; dfn/ds is zero. Unsymmetric when slipping: friction is not a potential.
struct Tangent {
  double nn = 0, n1 = 0, n2 = 0;  // column g
  double t11 = 0, t12 = 0, t22 = 0;
};

struct Surface {
  double k = 0;   // N/m
  double kt = 0;  // N/m
  double mu = 0;
};

/// Friction limited by `limit` [N], whatever it depends on.
inline Force force_with_limit(const Surface& s, const Displacement& d, double fn, double limit) {
  if (!(limit > 0)) return {fn, 0, 0, true};
  const double f1 = -s.kt * d.s1, f2 = -s.kt * d.s2;
  const double f = std::sqrt(f1 * f1 + f2 * f2);
  if (f <= limit) return {fn, f1, f2, false};
  const double back = limit / f;
  return {fn, back * f1, back * f2, true};
}

inline double normal_force(const Surface& s, double gap) { return gap < 0 ? -s.k * gap : 0.0; }

/// Coulomb's law: the limit is mu f_n.
inline Force coulomb(const Surface& s, const Displacement& d) {
  const double fn = normal_force(s, d.g);
  return fn > 0 ? force_with_limit(s, d, fn, s.mu * fn) : Force{};
}

/// Stiffness of what `f` stands on; `limit_grows`: the limit is mu f_n (Coulomb), not a constant (Tresca).
inline Tangent tangent(const Surface& s, const Displacement& d, const Force& f, double limit,
                       bool limit_grows) {
  Tangent t;
  if (f.fn > 0) t.nn = s.k;
  if (!f.slips) {
    t.t11 = t.t22 = f.fn > 0 || !limit_grows ? s.kt : 0;
    return t;
  }
  if (limit <= 0) return t;  // no friction
  // slip: stiff across the direction of slip only, e = s / |s|
  const double length = std::sqrt(d.s1 * d.s1 + d.s2 * d.s2);
  const double e1 = d.s1 / length, e2 = d.s2 / length, across = limit / length;
  t.t11 = across * e2 * e2;
  t.t12 = -across * e1 * e2;
  t.t22 = across * e1 * e1;
  if (limit_grows) {
    t.n1 = -s.mu * s.k * e1;
    t.n2 = -s.mu * s.k * e2;
  }
  return t;
}

/// Energy of the same contact with a constant limit [J]: convex and once differentiable, its gradient is -force.
inline double tresca_energy(const Surface& s, const Displacement& d, double limit) {
  const double normal = d.g < 0 ? 0.5 * s.k * d.g * d.g : 0.0;
  const double length = std::sqrt(d.s1 * d.s1 + d.s2 * d.s2);
  if (s.kt * length <= limit) return normal + 0.5 * s.kt * length * length;
  return normal + limit * (length - 0.5 * limit / s.kt);
}

}  // namespace swage::dynamics
