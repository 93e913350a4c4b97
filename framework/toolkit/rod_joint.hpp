// SPDX-License-Identifier: Apache-2.0
//
// The energy of one joint of a discrete elastic rod (Bergou et al. 2008, 2010): two straight edges e and f meet at a node, which
// stands for the length l of the rod around it.
//
//   bending  EI/(2l) |kb|^2 - EI/l kb.K,   kb = 2 te x tf / (1 + te.tf)   K: natural curvature times l, in the material frames
//   twist    GJ/(2l) m^2                   m: angle from the director of e, transported over the node, to that of f
//
// Derivatives are by the vectors e and f and by the rotations theta of the directors about their edges; otherwise directors follow
// their edges by the least rotation. The section is round: without natural curvature the bending depends on te.tf alone.
// One joint, or as many side by side as V has numbers (wide.hpp): each has the bits that it has alone. Header-only, pure, [rt].
#pragma once

#include "toolkit/math.hpp"
#include "toolkit/three.hpp"

namespace swage::toolkit {

/// Gradient and Hessian by (e, theta_e, f, theta_f); of the symmetric Hessian only the upper half.
template <class V>
struct JointDerivatives {
  using Vec = Three<V>;
  using Mat = Three<Vec>;  // its columns
  static constexpr int kNumbers = 50, kOfGradient = 8;  // the gradient comes first

  Vec e, f;                    // N, by the two edges
  V te, tf;                    // N m, by the two rotations
  Mat ee, ff, ef;              // N/m; ef: row by e, column by f
  Vec e_te, e_tf, f_te, f_tf;  // N
  V te_te, tf_tf, te_tf;       // N m
};

template <class V>
struct RodJoint {
  using Vec = Three<V>;
  using Derivatives = JointDerivatives<V>;

  // the configuration
  Vec te, tf;       // unit tangents
  V inv_e, inv_f;   // 1/m, of the lengths of the edges
  V twist;          // rad
  Vec Ke, Kf;       // natural curvature times l, as a vector in each edge's frame; unset where there is none
  V bend, turn;     // N m, EI / l and GJ / l

  [[gnu::always_inline]] Vec curvature() const { return (2.0 / (1.0 + te.dot(tf))) * te.cross(tf); }

  [[gnu::always_inline]] V energy(bool curved) const {
    const V c = te.dot(tf);
    V E = (2.0 * bend) * (every<V>(1) - c) / (1.0 + c) + (0.5 * turn) * twist * twist;
    if (curved) E = E - bend * (0.5 * curvature().dot(Ke + Kf) - 0.5 * Ke.dot(Ke));
    return E;
  }

  /// Gradient and, where `second`, the Hessian.
  [[gnu::always_inline]] void differentiate(bool curved, bool second, Derivatives& d) const {
    round(second, d);
    if (curved) memory(second, d);
  }

 private:
  /// Energy E(c) = 2 bend (1 - c) / (1 + c), c = te.tf, and twist together: their whole Hessian consists of a few outer products.
  [[gnu::always_inline]] void round(bool second, Derivatives& d) const {
    const V c = te.dot(tf), chi = 1.0 + c, moment = turn * twist;
    const V E1 = (-4.0 * bend) / (chi * chi), E2 = (-2.0 * E1) / chi;
    const Vec a = tf - c * te, b = te - c * tf;  // directions of dc/de, dc/df
    const Vec kb = (2.0 / chi) * te.cross(tf);
    const Vec me = (0.5 * inv_e) * kb, mf = (0.5 * inv_f) * kb;  // dm/de, dm/df
    d.e = (E1 * inv_e) * a + moment * me;
    d.f = (E1 * inv_f) * b + moment * mf;
    d.te = -moment, d.tf = moment;
    if (!second) return;
    const Vec mid = (te + tf) / chi;
    const V wee = inv_e * inv_e, wff = inv_f * inv_f, wef = inv_e * inv_f, kee = (0.25 * moment) * wee,
            kff = (0.25 * moment) * wff;
    square((-wee) * E1, c, te, a, wee * E2, kb, ((0.125 * turn) * wee) * kb - kee * (te + mid), d.ee);
    square((-wff) * E1, c, tf, b, wff * E2, kb, ((0.125 * turn) * wff) * kb - kff * (tf + mid), d.ff);
    const Vec b2 = (wef * E2) * b, e2 = (wef * E1) * (c * tf - te), f2 = (wef * E1) * tf;
    const Vec k2 = ((0.25 * turn) * wef) * kb - ((0.5 * moment) * wef) * mid;
    const Vec s = (moment * wef / chi) * te;
    const auto column = [&](V b2c, V e2c, V k2c, V f2c) __attribute__((always_inline)) {
      const auto entry = [&](V ar, V tr, V kr, V fr) __attribute__((always_inline)) {
        return (ar * b2c + tr * e2c) + (kr * k2c - fr * f2c);
      };
      return Vec{entry(a.x, te.x, kb.x, tf.x), entry(a.y, te.y, kb.y, tf.y), entry(a.z, te.z, kb.z, tf.z)};
    };
    d.ef = {column(b2.x, e2.x, k2.x, f2.x), column(b2.y, e2.y, k2.y, f2.y), column(b2.z, e2.z, k2.z, f2.z)};
    const V more = wef * E1;
    d.ef.x.x = d.ef.x.x + more, d.ef.y.y = d.ef.y.y + more, d.ef.z.z = d.ef.z.z + more;
    d.ef.y.x = d.ef.y.x - s.z, d.ef.x.y = d.ef.x.y + s.z;
    d.ef.z.x = d.ef.z.x + s.y, d.ef.x.z = d.ef.x.z - s.y;
    d.ef.z.y = d.ef.z.y - s.x, d.ef.y.z = d.ef.y.z + s.x;
    d.e_tf = turn * me, d.f_tf = turn * mf;
    d.e_te = -d.e_tf, d.f_te = -d.f_tf;
    d.te_te = d.tf_tf = turn, d.te_tf = -turn;
  }
  /// w (t a' + a t' + c (1 - t t')) + x a a' + k q' + q k'.
  [[gnu::always_inline]] static void square(V w, V c, const Vec& t, const Vec& a, V x, const Vec& k, const Vec& q,
                                            typename Derivatives::Mat& out) {
    const Vec p = w * (a - (0.5 * c) * t), a2 = x * a;
    const auto entry = [&](V tr, V pr, V ar, V kr, V qr, V tc, V pc, V a2c, V kc, V qc) __attribute__((always_inline)) {
      return (tr * pc + pr * tc) + (ar * a2c + (kr * qc + qr * kc));
    };
    const V wc = w * c;
    out.x.x = entry(t.x, p.x, a.x, k.x, q.x, t.x, p.x, a2.x, k.x, q.x) + wc;
    out.x.y = out.y.x = entry(t.y, p.y, a.y, k.y, q.y, t.x, p.x, a2.x, k.x, q.x);
    out.x.z = out.z.x = entry(t.z, p.z, a.z, k.z, q.z, t.x, p.x, a2.x, k.x, q.x);
    out.y.y = entry(t.y, p.y, a.y, k.y, q.y, t.y, p.y, a2.y, k.y, q.y) + wc;
    out.y.z = out.z.y = entry(t.z, p.z, a.z, k.z, q.z, t.y, p.y, a2.y, k.y, q.y);
    out.z.z = entry(t.z, p.z, a.z, k.z, q.z, t.z, p.z, a2.z, k.z, q.z) + wc;
  }

  /// Energy of the natural curvature: -bend q, q = kb.(Ke + Kf) / 2.
  [[gnu::always_inline]] void memory(bool second, Derivatives& d) const {
    const V chi = 1.0 + te.dot(tf);
    const Vec kb = (2.0 / chi) * te.cross(tf), mid = (te + tf) / chi, K = (Ke + Kf) / chi;
    const Vec De = te.cross(Ke), Df = tf.cross(Kf);  // derivatives of Ke, Kf by theta
    const Vec fK = tf.cross(K), eK = te.cross(K);
    const V q = 0.5 * kb.dot(Ke + Kf), qe = 0.5 * kb.dot(De), qf = 0.5 * kb.dot(Df);
    d.e = d.e - (bend * inv_e) * (fK - q * mid);
    d.f = d.f - (bend * inv_f) * (-eK - q * mid);
    d.te = d.te - bend * qe;
    d.tf = d.tf - bend * qf;
    if (!second) return;
    const Vec two_mid = (2.0 * q) * mid;
    const V share = q / chi, wee = bend * inv_e * inv_e, wff = bend * inv_f * inv_f, wef = bend * inv_e * inv_f;
    const V zero = every<V>(0), one = every<V>(1);
    const Vec skew[3] = {{zero, K.z, -K.y}, {-K.z, zero, K.x}, {K.y, -K.x, zero}};  // its columns
    const auto column = [&](int c) __attribute__((always_inline)) {
      for (int r = 0; r < 3; ++r) {
        const V mm = two_mid[r] * mid[c], same = r == c ? one : zero;
        const auto both = [&](const Vec& a, const Vec& b) __attribute__((always_inline)) { return a[r] * b[c] + b[r] * a[c]; };
        const V ee = ((mm - both(fK, mid)) - share * (same - te[r] * te[c])) + 0.25 * both(kb, Ke);
        const V ff = ((mm + both(eK, mid)) - share * (same - tf[r] * tf[c])) + 0.25 * both(kb, Kf);
        const V ef = (((mm - share * (same + te[r] * tf[c])) - fK[r] * mid[c]) + mid[r] * eK[c]) - skew[c][r];
        d.ee[c][r] = d.ee[c][r] - wee * ee;
        d.ff[c][r] = d.ff[c][r] - wff * ff;
        d.ef[c][r] = d.ef[c][r] - wef * ef;
      }
    };
    column(0), column(1), column(2);
    const V we = bend * inv_e, wf = bend * inv_f;
    d.e_te = d.e_te - we * (tf.cross(De) / chi - qe * mid);
    d.e_tf = d.e_tf - we * (tf.cross(Df) / chi - qf * mid);
    d.f_te = d.f_te - wf * (-te.cross(De) / chi - qe * mid);
    d.f_tf = d.f_tf - wf * (-te.cross(Df) / chi - qf * mid);
    d.te_te = d.te_te + (0.5 * bend) * kb.dot(Ke);
    d.tf_tf = d.tf_tf + (0.5 * bend) * kb.dot(Kf);
  }
};

}  // namespace swage::toolkit
