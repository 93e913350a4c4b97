// SPDX-License-Identifier: Apache-2.0
//
// The law of one compliant contact with exact Coulomb friction, as a function of gap and tangential
// displacement.
//
//     f_n = k max(0, d + T d')                          overlap d = -g; T: retardation time of the surfaces
//     f_t = -k_t s            while k_t |s| <= mu f_n      (stick: an elastic bristle, no creep)
//           -mu f_n s / |s|   beyond                       (slip: the bristle returns radially to the cone)
//
// Header-only, pure functions, [rt].
#pragma once

#include <cmath>
#include <cstdint>

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

/// Retardation time T of a contact [s]: at the overlap d the surfaces push with k (d + T d'). T is 1 - e of that of the scene
/// (scales.hpp), so that surfaces with the restitution e = 1 have none.
inline double retardation(double restitution, double of_scene) { return (1 - restitution) * of_scene; }

/// Implicit over the step h [s], d' = (d - d0) / h: a contact stiffer by 1 + T / h whose overlap counts from T / (h + T) d0.
inline Surface surface(double stiffness, double friction, double T, double h) {
  return {stiffness * (1 + T / h), kTangentRatio * stiffness, friction};
}
inline double relaxed_gap(double T, double h, double gap_before) {
  return T / (h + T) * std::fmin(gap_before, 0.0);
}

/// How the friction limit of a contact depends on its normal force; that of a tie is a constant of its law.
enum class Friction {
  kCoulomb,  // mu f_n
  kTresca,   // a given constant
};

/// Friction limited by a given `limit` [N].
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

/// Tangent of the piece of the law that `f` is on; `limit_grows`: the limit is mu f_n (Coulomb), not a constant (Tresca).
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

/// A force of an earlier step or pass, in the present axes. Within 0.1 % of its limit it counts as slipping: the axes may have turned.
inline Force force_before(const Surface& s, double fn, double f1, double f2) {
  return {fn, f1, f2, f1 * f1 + f2 * f2 >= 0.998 * s.mu * s.mu * fn * fn};
}

/// The law linearised at the displacement u(f) that gives the force f, on the piece of f: f(u) = f - D (u - u(f)).
struct LinearLaw {
  Force f;  // at u
  Tangent D;
};
inline LinearLaw law_before(const Surface& s, const Force& f, const Displacement& u) {
  const Displacement then{-f.fn / s.k, -f.f1 / s.kt, -f.f2 / s.kt};
  const Tangent D = tangent(s, then, f, s.mu * f.fn, true);
  const double g = u.g - then.g, s1 = u.s1 - then.s1, s2 = u.s2 - then.s2;
  return {{f.fn - D.nn * g, f.f1 - D.n1 * g - D.t11 * s1 - D.t12 * s2, f.f2 - D.n2 * g - D.t12 * s1 - D.t22 * s2, f.slips},
          D};
}

/// The law as a projection (Alart and Curnier, Comput. Methods Appl. Mech. Eng. 92 (1991) 353): f = P(f - r w), w = s + f / k_t the slip,
/// P to the disc of radius mu f_n; linearised about a force f and a displacement u that need not belong together. For any
/// r > 0 [N/m] it has the solutions of the law. A slip that reverses within a step sticks at once where r times its reverse displacement is
/// below its limit; the law itself throws it across a friction cone that is a thousand times smaller than that displacement.
inline LinearLaw law_projected(const Surface& s, const Force& f, const Displacement& u, double r) {
  LinearLaw law;
  if (!(f.fn - r * (u.g + f.fn / s.k) > 0)) return law;
  const double fn = -s.k * u.g, limit = s.mu * (f.fn > 0 ? f.fn : fn), rest = 1 - r / s.kt;
  const double size = std::sqrt(f.f1 * f.f1 + f.f2 * f.f2), back = rest * (size > limit ? limit / size : 1);
  const double a1 = back * f.f1 - r * u.s1, a2 = back * f.f2 - r * u.s2, a = std::sqrt(a1 * a1 + a2 * a2);
  law.D.nn = s.k;
  if (a <= limit && limit > 0) {
    law.f = {fn, -s.kt * u.s1, -s.kt * u.s2, false};
    law.D.t11 = law.D.t22 = s.kt;
    return law;
  }
  law.f = {fn, 0, 0, true};
  if (!(limit > 0)) return law;
  // along the force mu f_n, across it a stiffness that turns the force
  const double e1 = a1 / a, e2 = a2 / a, share = limit / a, c = share * r / (1 - share * rest);
  const double across = c * (e1 * u.s2 - e2 * u.s1);
  law.f.f1 = s.mu * fn * e1 + across * e2, law.f.f2 = s.mu * fn * e2 - across * e1;
  law.D.t11 = c * e2 * e2, law.D.t12 = -c * e1 * e2, law.D.t22 = c * e1 * e1;
  law.D.n1 = s.mu * s.k * e1, law.D.n2 = s.mu * s.k * e2;
  return law;
}

// --- Coulomb's law piece by piece: each piece continued beyond its own range, and where it ends

enum class Piece : uint8_t { kOpen, kStick, kSlip };

inline Piece piece(const Surface& s, const Displacement& d) {
  if (!(d.g < 0)) return Piece::kOpen;
  return s.kt * std::sqrt(d.s1 * d.s1 + d.s2 * d.s2) <= s.mu * s.k * -d.g ? Piece::kStick : Piece::kSlip;
}

inline Force force_on(Piece piece, const Surface& s, const Displacement& d) {
  if (piece == Piece::kOpen) return {};
  const double fn = -s.k * d.g;
  if (piece == Piece::kStick) return {fn, -s.kt * d.s1, -s.kt * d.s2, false};
  const double length = std::sqrt(d.s1 * d.s1 + d.s2 * d.s2), back = length > 0 ? s.mu * fn / length : 0.0;
  return {fn, -back * d.s1, -back * d.s2, true};
}

inline Tangent tangent_on(Piece piece, const Surface& s, const Displacement& d) {
  Tangent t;
  if (piece == Piece::kOpen) return t;
  t.nn = s.k;
  if (piece == Piece::kStick) {
    t.t11 = t.t22 = s.kt;
    return t;
  }
  const double length = std::sqrt(d.s1 * d.s1 + d.s2 * d.s2);
  if (!(length > 0)) return t;
  const double e1 = d.s1 / length, e2 = d.s2 / length, across = s.mu * s.k * -d.g / length;
  t.t11 = across * e2 * e2, t.t12 = -across * e1 * e2, t.t22 = across * e1 * e1;
  t.n1 = -s.mu * s.k * e1, t.n2 = -s.mu * s.k * e2;
  return t;
}

/// The t > 0 at which d + t e leaves a piece; infinite where it never does.
struct Kink {
  double t = HUGE_VAL;
  Piece next = Piece::kOpen;
};

/// The t at which a t^2 + 2 b t + c passes 0, from below (`rising`) or from above; t > -1e-12 counts as 0. Infinite: nowhere.
inline double zero_of(bool rising, double a, double b, double c) {
  const double square = b * b - a * c;
  if (!(square > 0)) return HUGE_VAL;
  const double root = rising ? std::sqrt(square) : -std::sqrt(square);
  // the root with slope a t + b = root, without cancellation
  const double t = b * root > 0 ? -c / (b + root) : (root - b) / a;
  return t > -1e-12 ? std::fmax(0.0, t) : HUGE_VAL;
}

/// The t at which a slip along e comes nearest to s = 0, the anchor of its bristle, if that is less than half as far as now. The stick
/// cone there is a thousand times smaller than the displacement of a step: Newton's steps would jump across it again and again.
inline double turns_back(const Displacement& d, const Displacement& e) {
  const double se = d.s1 * e.s1 + d.s2 * e.s2, ee = e.s1 * e.s1 + e.s2 * e.s2, ss = d.s1 * d.s1 + d.s2 * d.s2;
  return se < 0 && ss * ee - se * se < 0.25 * ss * ee ? -se / ee : HUGE_VAL;
}

inline Kink kink(Piece piece, const Surface& s, const Displacement& d, const Displacement& e) {
  Kink kink;
  if (piece == Piece::kOpen) {
    if (e.g < 0) kink = {std::fmax(0.0, -d.g / e.g), Piece::kSlip};
    return kink;
  }
  if (e.g > 0) kink = {std::fmax(0.0, -d.g / e.g), Piece::kOpen};

  // (k_t |s|)^2 = (mu k g)^2, a quadratic a t^2 + 2 b t + c = 0; stick ends where it rises through 0, slip where
  // it falls
  const double kt2 = s.kt * s.kt, cone = s.mu * s.mu * s.k * s.k;
  const double a = kt2 * (e.s1 * e.s1 + e.s2 * e.s2) - cone * e.g * e.g;
  const double b = kt2 * (d.s1 * e.s1 + d.s2 * e.s2) - cone * d.g * e.g;
  const double c = kt2 * (d.s1 * d.s1 + d.s2 * d.s2) - cone * d.g * d.g;
  const double t = zero_of(piece == Piece::kStick, a, b, c);
  if (t < kink.t) kink = {t, piece == Piece::kStick ? Piece::kSlip : Piece::kStick};
  return kink;
}

/// Energy of the same contact with a constant limit [J]: convex and once differentiable, its gradient is -force.
inline double tresca_energy(const Surface& s, const Displacement& d, double limit) {
  const double normal = d.g < 0 ? 0.5 * s.k * d.g * d.g : 0.0;
  const double length = std::sqrt(d.s1 * d.s1 + d.s2 * d.s2);
  if (s.kt * length <= limit) return normal + 0.5 * s.kt * length * length;
  return normal + limit * (length - 0.5 * limit / s.kt);
}

}  // namespace swage::dynamics
