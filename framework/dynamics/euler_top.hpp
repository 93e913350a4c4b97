// SPDX-License-Identifier: Apache-2.0
//
// The torque-free top in closed form (Jacobi 1849; Whittaker, Analytical Dynamics, section 69). In the body's axes,
// renamed so that y is the one of the middle moment, Euler's equations are
//
//     x' = alpha y z,   y' = beta z x,   z' = gamma x y      alpha + beta + gamma = 0
//
// which cn, sn and dn solve. Their addition theorem carries x, y, z over h without knowing phase, modulus or axis of
// the motion, since all three enter through lambda^2 and mu^2 alone, which are constants of it:
//
//     lambda^2 = alpha gamma y^2 - alpha beta z^2        mu^2 = alpha gamma y^2 - beta gamma x^2
//     p = sn(lambda h) / lambda     c = cn = sqrt(1 - lambda^2 p^2)     d = dn = sqrt(1 - mu^2 p^2)
//
//     x(h) = (x c + p d x') / D     y(h) = (y c d + p y') / D     z(h) = (z d + p c z') / D
//     D = 1 - alpha gamma y^2 p^2
//
// Energy and |L| are exact to rounding whatever p is. Attitude: with a and b the momentum in the body at the start and
// at the end, it turns about L by psi and then by the least rotation that takes b to a, so L is constant in the world
// to rounding. Only psi is approximate, the integral of |L| (2 E + w . a) / (a . a + L . a), as a series to h^5: with
// v = w at the start, f = 2 E / (a . a), g = v - f a, which is normal to a and to a', and a'' = A a by components,
//
//     psi / |L| = f h + (h^3 s2 + h^4 s3 / 4 + h^5 (s4 + 3 s2 a'.a' / a.a) / 20) / (12 a.a)
//     s2 = g . A a     s3 = g . A a'     s4 = g . A A a
//
// Written for a short chain of dependent operations, which determines its run time. Header-only, pure functions, [rt].
#pragma once

#include <algorithm>
#include <cmath>

#include "dynamics/rotation.hpp"

namespace swage::dynamics {

/// Moments of a body by its renamed axes.
struct EulerTop {
  int i = 0, j = 1, k = 2;           // x, y, z are these axes of the body; cyclic, j has the middle moment
  double w_x = 1, w_y = 1, w_z = 1;  // 1/I
  double I_x = 1, I_y = 1, I_z = 1;  // kg m2
  double alpha = 0, beta = 0, gamma = 0;  // 1 / (kg m2)
  double alpha_beta = 0, beta_gamma = 0, gamma_alpha = 0;

  EulerTop() = default;
  explicit EulerTop(const Vec3& I) {
    const Vec3 inv_I = I.cwiseInverse();
    for (j = 0; j < 2; ++j)
      if ((inv_I[j] - inv_I[(j + 1) % 3]) * (inv_I[j] - inv_I[(j + 2) % 3]) <= 0) break;
    i = (j + 2) % 3, k = (j + 1) % 3;
    w_x = inv_I[i], w_y = inv_I[j], w_z = inv_I[k];
    I_x = I[i], I_y = I[j], I_z = I[k];
    alpha = w_z - w_y, beta = w_x - w_z, gamma = w_y - w_x;
    alpha_beta = alpha * beta, beta_gamma = beta * gamma, gamma_alpha = gamma * alpha;
  }
};

/// Components along the renamed axes.
struct Triple {
  double x, y, z;
  double dot(const Triple& b) const { return x * b.x + y * b.y + z * b.z; }
  Triple cross(const Triple& b) const { return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x}; }
};

/// Attitude of the renamed axes in W (whose own are renamed alike), and momentum along them.
struct TopState {
  double w, x, y, z;  // quaternion
  double norm2 = 1;  // its squared length: it is normalised last, beside other operations
  Triple L;          // N m s

  void normalise() {
    const double unit = 1 / std::sqrt(norm2);
    w *= unit, x *= unit, y *= unit, z *= unit, norm2 = 1;
  }
  /// v in W, along the axes of the body. For norm2 = 1.
  Triple turned_back(const Triple& v) const {
    const Triple q{-x, -y, -z}, half = q.cross(v), whole{half.x + half.x, half.y + half.y, half.z + half.z};
    const Triple turn = q.cross(whole);
    return {v.x + w * whole.x + turn.x, v.y + w * whole.y + turn.y, v.z + w * whole.z + turn.z};
  }
  /// v along the axes of the body, in W.
  Triple turned(const Triple& v) const {
    const Triple q{x, y, z}, half = q.cross(v);
    const Triple turn = q.cross({half.x + w * v.x, half.y + w * v.y, half.z + w * v.z});
    const double twice = 2 / norm2;
    return {v.x + twice * turn.x, v.y + twice * turn.y, v.z + twice * turn.z};
  }
};

/// x(h), y(h), z(h) of above from a; da: a'. lambda2, mu2 [1/s2]: lambda h and mu h up to 0.1, where the first term left
/// out of p is 2e-10 of it.
inline Triple momentum_after(const EulerTop& t, const Triple& a, const Triple& da, double lambda2, double mu2,
                             double h) {
  const double h2 = h * h, sum = h2 * (lambda2 + mu2), sum2 = sum * sum;
  const double product = (h2 * lambda2) * (h2 * mu2);
  const double p = h * ((1 - sum * (1.0 / 6)) + ((sum2 * (1.0 / 120) + product * (1.0 / 10)) -
                                                 (sum * (1.0 / 5040)) * (sum2 + 132 * product)));
  const double p2 = p * p, c = std::sqrt(1 - lambda2 * p2), d = std::sqrt(1 - mu2 * p2);
  const double over_D = 1 / (1 - t.gamma_alpha * (a.y * a.y) * p2), pD = p * over_D;
  const double cD = c * over_D, dD = d * over_D;
  return {a.x * cD + d * (pD * da.x), a.y * (c * dD) + pD * da.y, a.z * dD + c * (pD * da.z)};
}

/// psi / |L| of above.
inline double angle_about_momentum(const EulerTop& t, const Triple& a, const Triple& da, double h) {
  const double xx = a.x * a.x, yy = a.y * a.y, zz = a.z * a.z, over_G2 = 1 / (xx + yy + zz), h2 = h * h;
  const double f = (t.w_x * xx + t.w_y * yy + t.w_z * zz) * over_G2;
  const double AB = t.alpha_beta * zz, BC = t.beta_gamma * xx, CA = t.gamma_alpha * yy;
  const Triple A{CA + AB, AB + BC, BC + CA};
  const Triple gA{(t.w_x - f) * a.x * A.x, (t.w_y - f) * a.y * A.y, (t.w_z - f) * a.z * A.z};
  const double s2 = gA.dot(a), s3 = gA.dot(da);
  const double s4 = gA.x * a.x * A.x + gA.y * a.y * A.y + gA.z * a.z * A.z;
  const double bend = (h2 * (1.0 / 20)) * (s4 + (3 * over_G2) * s2 * da.dot(da));
  return h * (f + h2 * over_G2 * (1.0 / 12) * ((s2 + 0.25 * h * s3) + bend));
}

/// Advances the top by h [s] from a unit quaternion.
inline void turn_top(const EulerTop& t, double lambda2, double mu2, double h, TopState& s) {
  const Triple a = s.L;
  const Triple da{t.alpha * a.y * a.z, t.beta * a.z * a.x, t.gamma * a.x * a.y};
  const Triple b = momentum_after(t, a, da, lambda2, mu2, h);
  const double phi = angle_about_momentum(t, a, da, h), G2 = a.dot(a);

  // attitude: q (cos psi/2, sin psi/2 a/|a|), then (a.a + a.b, b x a)
  double C, S;
  circle(0.25 * phi * phi * G2, C, S);
  S *= 0.5 * phi;
  const double qw = C * s.w - S * (s.x * a.x + s.y * a.y + s.z * a.z),
               qx = C * s.x + S * (s.w * a.x + s.y * a.z - s.z * a.y),
               qy = C * s.y + S * (s.w * a.y + s.z * a.x - s.x * a.z),
               qz = C * s.z + S * (s.w * a.z + s.x * a.y - s.y * a.x);
  const double n = G2 + a.dot(b);
  const Triple r = b.cross(a);
  s.norm2 = (s.w * s.w + s.x * s.x + s.y * s.y + s.z * s.z) * (2 * G2 * n);
  s.w = qw * n - (qx * r.x + qy * r.y + qz * r.z);
  s.x = qx * n + (qw * r.x + qy * r.z - qz * r.y);
  s.y = qy * n + (qw * r.y + qz * r.x - qx * r.z);
  s.z = qz * n + (qw * r.z + qx * r.y - qy * r.x);
  s.L = b;
}

/// Advances the top by h [s], in as many equal parts as turn_top needs: one up to 170 rad/s at 1 kHz for moments 1 : 2 : 3.
/// Beyond 64 parts (11 000 rad/s) it turns only as far as they can. The quaternion is not normalised: norm2 is its squared length.
inline void euler_top(const EulerTop& t, double h, TopState& s) {
  const double xx = s.L.x * s.L.x, yy = s.L.y * s.L.y, zz = s.L.z * s.L.z;
  if (!(xx + yy + zz > 1e-140)) return;  // at rest
  const double middle = t.gamma_alpha * yy, lambda2 = middle - t.alpha_beta * zz,
               mu2 = middle - t.beta_gamma * xx;
  constexpr double kMost = 0.1;  // rad
  const double fastest = std::max(lambda2, mu2);
  int parts = 1;
  for (; h * h * fastest > kMost * kMost && parts < 64; h *= 0.5) parts *= 2;
  if (h * h * fastest > kMost * kMost) h = kMost / std::sqrt(fastest);
  for (;;) {
    turn_top(t, lambda2, mu2, h, s);
    if (--parts == 0) return;
    s.normalise();
  }
}

}  // namespace swage::dynamics
