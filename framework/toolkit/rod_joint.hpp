// SPDX-License-Identifier: Apache-2.0
//
// The energy of one joint of a discrete elastic rod (Bergou et al. 2008, 2010): two straight edges e and f meet at a node, which
// stands for the length l of the rod around it.
//
//   bending  EI/(2l) |kb|^2 - EI/l kb.K,   kb = 2 te x tf / (1 + te.tf)   K: natural curvature times l, in the material frames
//   twist    GJ/(2l) m^2                   m: angle from the director of e, transported over the node, to that of f
//
// Derivatives are by the vectors e and f and by the rotations theta of the directors about their edges, which else go along with
// their edges by the least rotation. The section is round: without natural curvature the bending depends on te.tf alone.
// Header-only, pure, [rt].
#pragma once

#include "toolkit/math.hpp"

namespace swage::toolkit {

struct RodJoint {
  // Hessian by (e, theta_e, f, theta_f), of which the lower half is symmetric to what is here
  struct Derivatives {
    Vec3 e, f;                    // N, by the two edges
    double te, tf;                // N m, by the two rotations
    Mat3 ee, ff, ef;              // N/m; ef: row by e, column by f
    Vec3 e_te, e_tf, f_te, f_tf;  // N
    double te_te, tf_tf, te_tf;   // N m
  };

  // the configuration
  Vec3 te, tf;                                // unit tangents
  double inv_e = 0, inv_f = 0;                // 1/m, of the lengths of the edges
  double twist = 0;                           // rad
  Vec3 Ke = Vec3::Zero(), Kf = Vec3::Zero();  // natural curvature times l, as a vector in each edge's frame
  double bend = 0;                            // N m, EI / l
  double turn = 0;                            // N m, GJ / l

  Vec3 curvature() const { return te.cross(tf) * (2 / (1 + te.dot(tf))); }

  double energy(bool curved) const {
    const double c = te.dot(tf);
    double E = 2 * bend * (1 - c) / (1 + c) + 0.5 * turn * twist * twist;
    if (curved) E -= bend * (0.5 * curvature().dot(Ke + Kf) - 0.5 * Ke.squaredNorm());
    return E;
  }

  /// Gradient and, where `second`, the Hessian. Flat: some hundred products of three numbers each, whose calls would cost as much as they.
  [[gnu::flatten]] void differentiate(bool curved, bool second, Derivatives& d) const {
    round(second, d);
    if (curved) memory(second, d);
  }

 private:
  static Mat3 both(const Vec3& a, const Vec3& b) { return a * b.transpose() + b * a.transpose(); }
  static Mat3 across(const Vec3& t) { return Mat3::Identity() - t * t.transpose(); }

  /// E(c) = 2 bend (1 - c) / (1 + c), c = te.tf, and the twist together: all of their Hessian is made of a few outer products.
  void round(bool second, Derivatives& d) const {
    const double c = te.dot(tf), chi = 1 + c, moment = turn * twist;
    const double E1 = -4 * bend / (chi * chi), E2 = -2 * E1 / chi;
    const Vec3 a = tf - c * te, b = te - c * tf;  // of dc/de, dc/df the directions
    const Vec3 kb = te.cross(tf) * (2 / chi);
    const Vec3 me = (0.5 * inv_e) * kb, mf = (0.5 * inv_f) * kb;  // dm/de, dm/df
    d.e = (E1 * inv_e) * a + moment * me;
    d.f = (E1 * inv_f) * b + moment * mf;
    d.te = -moment, d.tf = moment;
    if (!second) return;
    const Vec3 mid = (te + tf) / chi;
    const double wee = inv_e * inv_e, wff = inv_f * inv_f, wef = inv_e * inv_f, kee = 0.25 * moment * wee,
                 kff = 0.25 * moment * wff;
    square(-wee * E1, c, te, a, wee * E2, kb, 0.125 * turn * wee * kb - kee * (te + mid), d.ee);
    square(-wff * E1, c, tf, b, wff * E2, kb, 0.125 * turn * wff * kb - kff * (tf + mid), d.ff);
    const Vec3 b2 = (wef * E2) * b, e2 = (wef * E1) * (c * tf - te), f2 = (wef * E1) * tf;
    const Vec3 k2 = 0.25 * turn * wef * kb - (0.5 * moment * wef) * mid;
    const Vec3 s = (moment * wef / chi) * te;
    for (int col = 0; col < 3; ++col)
      for (int r = 0; r < 3; ++r)
        d.ef(r, col) = (a[r] * b2[col] + te[r] * e2[col]) + (kb[r] * k2[col] - tf[r] * f2[col]);
    for (int r = 0; r < 3; ++r) d.ef(r, r) += wef * E1;
    d.ef(0, 1) -= s[2], d.ef(1, 0) += s[2];
    d.ef(0, 2) += s[1], d.ef(2, 0) -= s[1];
    d.ef(1, 2) -= s[0], d.ef(2, 1) += s[0];
    d.e_tf = turn * me, d.f_tf = turn * mf;
    d.e_te = -d.e_tf, d.f_te = -d.f_tf;
    d.te_te = d.tf_tf = turn, d.te_tf = -turn;
  }
  /// w (t a' + a t' + c (1 - t t')) + x a a' + k q' + q k'.
  static void square(double w, double c, const Vec3& t, const Vec3& a, double x, const Vec3& k, const Vec3& q,
                     Mat3& out) {
    const Vec3 p = w * (a - 0.5 * c * t), a2 = x * a;
    for (int col = 0; col < 3; ++col)
      for (int r = col; r < 3; ++r)
        out(r, col) = out(col, r) =
            (t[r] * p[col] + p[r] * t[col]) + (a[r] * a2[col] + (k[r] * q[col] + q[r] * k[col]));
    for (int r = 0; r < 3; ++r) out(r, r) += w * c;
  }

  /// -bend q, q = kb.(Ke + Kf) / 2.
  void memory(bool second, Derivatives& d) const {
    const double chi = 1 + te.dot(tf);
    const Vec3 kb = te.cross(tf) * (2 / chi), mid = (te + tf) / chi, K = (Ke + Kf) / chi;
    const Vec3 De = te.cross(Ke), Df = tf.cross(Kf);  // how Ke, Kf turn with theta
    const Vec3 fK = tf.cross(K), eK = te.cross(K);
    const double q = 0.5 * kb.dot(Ke + Kf), qe = 0.5 * kb.dot(De), qf = 0.5 * kb.dot(Df);
    d.e -= (bend * inv_e) * (fK - q * mid);
    d.f -= (bend * inv_f) * (-eK - q * mid);
    d.te -= bend * qe;
    d.tf -= bend * qf;
    if (!second) return;
    const Mat3 mm = (2 * q) * (mid * mid.transpose());
    d.ee -= (bend * inv_e * inv_e) * (mm - both(fK, mid) - (q / chi) * across(te) + 0.25 * both(kb, Ke));
    d.ff -= (bend * inv_f * inv_f) * (mm + both(eK, mid) - (q / chi) * across(tf) + 0.25 * both(kb, Kf));
    d.ef -= (bend * inv_e * inv_f) * (mm - (q / chi) * (Mat3::Identity() + te * tf.transpose()) -
                                      fK * mid.transpose() + mid * eK.transpose() - skew(K));
    d.e_te -= (bend * inv_e) * (tf.cross(De) / chi - qe * mid);
    d.e_tf -= (bend * inv_e) * (tf.cross(Df) / chi - qf * mid);
    d.f_te -= (bend * inv_f) * (-te.cross(De) / chi - qe * mid);
    d.f_tf -= (bend * inv_f) * (-te.cross(Df) / chi - qf * mid);
    d.te_te += 0.5 * bend * kb.dot(Ke);
    d.tf_tf += 0.5 * bend * kb.dot(Kf);
  }
};

}  // namespace swage::toolkit
