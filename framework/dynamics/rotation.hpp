// SPDX-License-Identifier: Apache-2.0
//
// Rotations of one step: small, frequent, and the same bits on every machine (no library call on the usual path).
// Header-only, [any].
#pragma once

#include "toolkit/math.hpp"

namespace swage::dynamics {

using toolkit::Mat3;
using toolkit::Quat;
using toolkit::Vec3;

/// cos(a) and sin(a)/a of an angle given by its square, a2 [rad2]. Series up to a quarter radian (next term 2e-18), above
/// by doubling the angle. Even and odd terms apart: a short chain.
inline void circle(double a2, double& c, double& s) {
  int doublings = 0;
  while (a2 > 0.0625 && doublings < 64) {
    a2 *= 0.25;
    ++doublings;
  }
  const double y = -a2, z = a2 * a2;
  c = (1 + y * (1.0 / 2)) + z * ((1.0 / 24 + y * (1.0 / 720)) + z * (1.0 / 40320 + y * (1.0 / 3628800)));
  s = (1 + y * (1.0 / 6)) + z * ((1.0 / 120 + y * (1.0 / 5040)) + z * (1.0 / 362880 + y * (1.0 / 39916800)));
  for (; doublings > 0; --doublings) {
    // sin(2a)/(2a) = cos(a) sin(a)/a
    const double twice = c * c - a2 * s * s;
    s *= c;
    c = twice;
    a2 *= 4;
  }
}

/// exp(a): the unit quaternion of the rotation vector a [rad].
inline Quat turn(const Vec3& a) {
  double c, s;
  circle(0.25 * a.squaredNorm(), c, s);
  s *= 0.5;
  return {c, s * a.x(), s * a.y(), s * a.z()};
}

/// Normalises q, exact to rounding where its length is off by rounding only.
inline void renormalise(Quat& q) { q.coeffs() *= 1.5 - 0.5 * q.squaredNorm(); }

/// log: the rotation vector [rad] of a unit quaternion. Series of the arc sine up to 0.1 rad (next term 4e-18).
inline Vec3 rotation_vector(const Quat& q) {
  const double y = q.vec().squaredNorm();
  if (y > 0.0025 || q.w() < 0) return toolkit::log_rotation(q);
  const double k =
      1 + y * (1.0 / 6 + y * (3.0 / 40 + y * (15.0 / 336 + y * (105.0 / 3456 + y * (945.0 / 42240)))));
  return 2 * k * q.vec();
}

/// A short vector v rotated with its body by the rotation vector `a`: to second order in a, then scaled to its own length, because
/// only its direction may change.
inline Vec3 carried(const Vec3& v, const Vec3& a) {
  const Vec3 once = a.cross(v);
  const Vec3 turned = v + once + 0.5 * a.cross(once);
  const double before = v.squaredNorm(), after = turned.squaredNorm();
  return after > 0 ? Vec3(turned * std::sqrt(before / after)) : turned;
}

}  // namespace swage::dynamics
