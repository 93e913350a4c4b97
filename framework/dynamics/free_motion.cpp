// SPDX-License-Identifier: Apache-2.0
#include "dynamics/free_motion.hpp"

#include <cmath>

#include "dynamics/rotation.hpp"

namespace swage::dynamics {
namespace {

/// Attitude and angular momentum in the body's frame.
struct Spin {
  Quat q;
  Vec3 L;
};

/// The same with the body's axes renamed i, j, k -> 0, 1, 2 (a cyclic change, so still right-handed): the flows below then know
/// their axes when they are compiled.
struct Top {
  double w, x, y, z;
  double L0, L1, L2;
};

/// cos and sin of half the angle, for a quaternion, and of the whole, for a vector.
struct Turn {
  double c, s, c2, s2;
  explicit Turn(double angle) {
    const double a2 = angle * angle;
    circle(a2, c, s);
    circle(0.25 * a2, c2, s2);
    s *= angle;
    s2 *= 0.5 * angle;
  }
};

/// Exact flow of the symmetric top L0^2 / 2 I_i + (L1^2 + L2^2) / 2 I_j: q <- q exp(h L / I_j) exp(e0 a), L <- R0(-a) L,
/// a = h (1/I_i - 1/I_j) L0.
inline void flow_top(const RigidMass& m, double h, Top& t) {
  const Turn r(h * m.top * t.L0);
  const double g = h * m.inv_I[m.j];
  double c, s;
  circle(0.25 * g * g * (t.L0 * t.L0 + t.L1 * t.L1 + t.L2 * t.L2), c, s);
  const double a = 0.5 * g * s * t.L0, b = 0.5 * g * s * t.L1, d = 0.5 * g * s * t.L2;

  // the two turns as one quaternion, then the attitude
  const double w = c * r.c2 - a * r.s2, x = c * r.s2 + a * r.c2, y = b * r.c2 + d * r.s2,
               z = d * r.c2 - b * r.s2;
  t = {t.w * w - t.x * x - t.y * y - t.z * z,
       t.w * x + t.x * w + t.y * z - t.z * y,
       t.w * y - t.x * z + t.y * w + t.z * x,
       t.w * z + t.x * y - t.y * x + t.z * w,
       t.L0,
       r.c * t.L1 + r.s * t.L2,
       r.c * t.L2 - r.s * t.L1};
}

/// Exact flow of the remainder, L2^2 (1/I_k - 1/I_j) / 2: a rotation about axis 2.
inline void flow_rest(const RigidMass& m, double h, Top& t) {
  const Turn r(h * m.rest * t.L2);
  t = {t.w * r.c2 - t.z * r.s2,
       t.x * r.c2 + t.y * r.s2,
       t.y * r.c2 - t.x * r.s2,
       t.z * r.c2 + t.w * r.s2,
       r.c * t.L0 + r.s * t.L1,
       r.c * t.L1 - r.s * t.L0,
       t.L2};
}

void split2(const RigidMass& m, double h, Top& x) {
  flow_rest(m, 0.5 * h, x);
  flow_top(m, h, x);
  flow_rest(m, 0.5 * h, x);
}

/// Order 4 with four stages, "position extended Forest-Ruth like" (Omelyan, Mryglod, Folk, Comput. Phys. Commun. 146 (2002) 188,
/// eq. 20): error constant 1/26 of Forest-Ruth's.
void split4(const RigidMass& m, double h, Top& x) {
  constexpr double xi = 0.1786178958448091, lambda = -0.2123418310626054, chi = -0.06626458266981849;
  flow_rest(m, xi * h, x);
  flow_top(m, (0.5 - lambda) * h, x);
  flow_rest(m, chi * h, x);
  flow_top(m, lambda * h, x);
  flow_rest(m, (1 - 2 * (chi + xi)) * h, x);
  flow_top(m, lambda * h, x);
  flow_rest(m, chi * h, x);
  flow_top(m, (0.5 - lambda) * h, x);
  flow_rest(m, xi * h, x);
}

/// Taylor series in time of Euler's equations, to order 8, and Magnus series of the attitude, to order 5. L' = L x w:
/// (n + 1) L_(n+1) = sum over m of L_m x w_(n-m). Attitude q exp(W), W' = w + W x w / 2 + W x (W x w) / 12 + ...
void taylor(const RigidMass& m, double h, Spin& x) {
  constexpr int kOrder = 8;
  // L' written out: L0' = (1/I2 - 1/I1) L1 L2, and so on round; time counted in steps, so that the terms shrink
  const double d0 = h * (m.inv_I[2] - m.inv_I[1]), d1 = h * (m.inv_I[0] - m.inv_I[2]),
               d2 = h * (m.inv_I[1] - m.inv_I[0]);
  double L0[kOrder + 1] = {x.L[0]}, L1[kOrder + 1] = {x.L[1]}, L2[kOrder + 1] = {x.L[2]};
  for (int n = 0; n < kOrder; ++n) {
    double p0 = 0, p1 = 0, p2 = 0;
    for (int k = 0; k <= n; ++k) {
      p0 += L1[k] * L2[n - k];
      p1 += L2[k] * L0[n - k];
      p2 += L0[k] * L1[n - k];
    }
    constexpr double kInverse[kOrder] = {1, 1.0 / 2, 1.0 / 3, 1.0 / 4, 1.0 / 5, 1.0 / 6, 1.0 / 7, 1.0 / 8};
    L0[n + 1] = kInverse[n] * d0 * p0;
    L1[n + 1] = kInverse[n] * d1 * p1;
    L2[n + 1] = kInverse[n] * d2 * p2;
  }
  auto term = [&](int n) { return Vec3(L0[n], L1[n], L2[n]); };

  // W: the integral of w, exact, and the commutators up to h^5
  const Vec3 mean = term(0) + term(1) / 2 + term(2) / 3 + term(3) / 4 + term(4) / 5 + term(5) / 6 +
                    term(6) / 7 + term(7) / 8 + term(8) / 9;
  const Vec3 inv_I = h * m.inv_I;
  const Vec3 w0 = inv_I.cwiseProduct(term(0)), w1 = inv_I.cwiseProduct(term(1)),
             w2 = inv_I.cwiseProduct(term(2)), w3 = inv_I.cwiseProduct(term(3));
  const Vec3 w01 = w0.cross(w1), w02 = w0.cross(w2);
  const Vec3 W = inv_I.cwiseProduct(mean) + (w01 + w02) / 12 +
                 w0.cross(3.0 / 40 * w3 + w02 / 360 - w0.cross(w01) / 720) + w1.cross(w2 / 60 - w01 / 240);
  x.q = x.q * turn(W);
  x.L = term(0) + term(1) + term(2) + term(3) + term(4) + term(5) + term(6) + term(7) + term(8);
}

/// Half the torque before, half after the free flow: symmetric, so order and energy behaviour survive.
void taylor_kicked(const RigidMass& m, const Vec3& t_W, double h, Spin& x) {
  x.L += x.q.conjugate() * (0.5 * h * t_W);
  taylor(m, h, x);
  renormalise(x.q);
  x.L += x.q.conjugate() * (0.5 * h * t_W);
}

/// Half the torque before, half after. The angular velocity is computed before the quaternion is normalised (euler_top.hpp).
void elliptic(const RigidMass& m, const Vec3& t_W, double h, RigidState& s) {
  const EulerTop& e = m.euler;
  const bool torque = !t_W.isZero(0);
  TopState t{s.q_WB.w(), s.q_WB.vec()[e.i], s.q_WB.vec()[e.j], s.q_WB.vec()[e.k], 1, {}};
  const Triple w0 = t.turned_back({s.w_W[e.i], s.w_W[e.j], s.w_W[e.k]});
  t.L = {e.I_x * w0.x, e.I_y * w0.y, e.I_z * w0.z};
  if (torque) {
    const Vec3 half = 0.5 * h * t_W;
    const Triple kick = t.turned_back({half[e.i], half[e.j], half[e.k]});
    t.L = {t.L.x + kick.x, t.L.y + kick.y, t.L.z + kick.z};
  }
  euler_top(e, h, t);
  const Triple w = t.turned({e.w_x * t.L.x, e.w_y * t.L.y, e.w_z * t.L.z});
  s.w_W[e.i] = w.x, s.w_W[e.j] = w.y, s.w_W[e.k] = w.z;
  t.normalise();
  s.q_WB.w() = t.w;
  s.q_WB.vec()[e.i] = t.x, s.q_WB.vec()[e.j] = t.y, s.q_WB.vec()[e.k] = t.z;
  if (torque) s.w_W += s.q_WB * m.inv_I.cwiseProduct(s.q_WB.conjugate() * (0.5 * h * t_W));
}

void split(FreeMotion method, const RigidMass& m, const Vec3& t_W, double h, Spin& x) {
  x.L += x.q.conjugate() * (0.5 * h * t_W);
  Top t{x.q.w(), x.q.vec()[m.i], x.q.vec()[m.j], x.q.vec()[m.k], x.L[m.i], x.L[m.j], x.L[m.k]};
  if (method == FreeMotion::kSplitting2) {
    split2(m, h, t);
  } else {
    split4(m, h, t);
  }
  x.q.w() = t.w;
  x.q.vec()[m.i] = t.x, x.q.vec()[m.j] = t.y, x.q.vec()[m.k] = t.z;
  x.L[m.i] = t.L0, x.L[m.j] = t.L1, x.L[m.k] = t.L2;
  renormalise(x.q);
  x.L += x.q.conjugate() * (0.5 * h * t_W);
}

/// Derivative of attitude and body momentum: q' = q w / 2, L' = L x w + t.
struct SpinRate {
  Eigen::Vector4d q;  // x y z w, as Eigen stores it
  Vec3 L;
};

inline SpinRate rate(const RigidMass& m, const Vec3& t_W, const Spin& x) {
  const Vec3 w = m.inv_I.cwiseProduct(x.L);
  const Quat half = x.q * Quat(0, 0.5 * w.x(), 0.5 * w.y(), 0.5 * w.z());
  return {half.coeffs(), x.L.cross(w) + x.q.conjugate() * t_W};
}

inline Spin ahead(const Spin& x, const SpinRate& r, double h) {
  Spin y = x;
  y.q.coeffs() += h * r.q;
  y.L += h * r.L;
  return y;
}

void runge_kutta4(const RigidMass& m, const Vec3& t_W, double h, Spin& x) {
  const SpinRate k1 = rate(m, t_W, x);
  const SpinRate k2 = rate(m, t_W, ahead(x, k1, 0.5 * h));
  const SpinRate k3 = rate(m, t_W, ahead(x, k2, 0.5 * h));
  const SpinRate k4 = rate(m, t_W, ahead(x, k3, h));
  x.q.coeffs() += h / 6 * (k1.q + 2 * (k2.q + k3.q) + k4.q);
  x.L += h / 6 * (k1.L + 2 * (k2.L + k3.L) + k4.L);
  x.q.normalize();
}

// exact for a constant force; the two Euler methods keep their own order
void translate(FreeMotion method, const RigidMass& m, const Vec3& f_W, double h, RigidState& s) noexcept {
  const Vec3 v0 = s.v_W;
  s.v_W += h / m.mass * f_W;
  switch (method) {
    case FreeMotion::kThesis:
      s.p_W += h * v0;
      break;
    case FreeMotion::kSymplecticEuler:
      s.p_W += h * s.v_W;
      break;
    default:
      s.p_W += 0.5 * h * (v0 + s.v_W);
  }
}

// L(t + h) = L + h t in W; R(t + h) = R + h [w]x R, back to a rotation
void turn_thesis(const Vec3& t_W, double h, const Vec3& w_W, Spin& x) noexcept {
  const Vec3 L_W = x.q * x.L + h * t_W;
  const Quat dq = Quat(0, 0.5 * h * w_W.x(), 0.5 * h * w_W.y(), 0.5 * h * w_W.z()) * x.q;
  x.q.coeffs() += dq.coeffs();
  x.q.normalize();
  x.L = x.q.conjugate() * L_W;
}

void turn_symplectic_euler(const RigidMass& m, const Vec3& t_W, double h, Spin& x) noexcept {
  const Vec3 L_W = x.q * x.L + h * t_W;
  x.L = x.q.conjugate() * L_W;
  x.q = x.q * turn(h * m.inv_I.cwiseProduct(x.L));
  renormalise(x.q);
  x.L = x.q.conjugate() * L_W;
}

}  // namespace

RigidMass::RigidMass(double mass_kg, const Vec3& principal)
    : mass(mass_kg), I(principal), inv_I(principal.cwiseInverse()), euler(principal) {
  // pair the two axes whose 1/I differ least: j, k; i is the axis of the top
  double closest = HUGE_VAL;
  for (int a = 0; a < 3; ++a) {
    const int b = (a + 1) % 3, c = (a + 2) % 3;
    const double apart = std::abs(inv_I[b] - inv_I[c]);
    if (apart < closest) {
      closest = apart;
      i = a, j = b, k = c;
    }
  }
  top = inv_I[i] - inv_I[j];
  rest = inv_I[k] - inv_I[j];
}

void move_free(FreeMotion method, const RigidMass& m, const Vec3& f_W, const Vec3& t_W, double h,
               RigidState& s) noexcept {
  translate(method, m, f_W, h, s);
  if (method == FreeMotion::kElliptic) return elliptic(m, t_W, h, s);
  Spin x{s.q_WB, m.I.cwiseProduct(s.q_WB.conjugate() * s.w_W)};
  switch (method) {
    case FreeMotion::kThesis:
      turn_thesis(t_W, h, s.w_W, x);
      break;
    case FreeMotion::kSymplecticEuler:
      turn_symplectic_euler(m, t_W, h, x);
      break;
    case FreeMotion::kRungeKutta4:
      runge_kutta4(m, t_W, h, x);
      break;
    case FreeMotion::kSplitting2:
    case FreeMotion::kSplitting4:
      split(method, m, t_W, h, x);
      break;
    case FreeMotion::kTaylor:
      taylor_kicked(m, t_W, h, x);
      break;
    case FreeMotion::kElliptic:
      break;
  }
  s.q_WB = x.q;
  s.w_W = x.q * m.inv_I.cwiseProduct(x.L);
}

}  // namespace swage::dynamics
