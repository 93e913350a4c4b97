// SPDX-License-Identifier: Apache-2.0
//
// Rod: its elastic energy, the derivatives, and displacements by a change of the unknowns. Part of rod.hpp.
#pragma once

#include "toolkit/rod.hpp"

namespace swage::toolkit {

inline Rod::Rod(const RodSection& section, std::span<const double> rest, double memory)
    : n_(static_cast<int>(rest.size()) + 1),
      section_(section),
      memory_(memory),
      rest_(rest.begin(), rest.end()) {
  mass_.assign(at(n_), 0.0);
  for (int j = 0; j < edges(); ++j) {
    length_ += rest_[at(j)];
    mass_[at(j)] += 0.5 * section.mass * rest_[at(j)];
    mass_[at(j + 1)] += 0.5 * section.mass * rest_[at(j)];
  }
  tension_.assign(at(edges()), 0.0);
  for (int i = 0; i < n_; ++i) remembered_.push_back(2 * std::tan(0.5 * memory * joint_length(i)));
  held_.assign(at(n_), 0);
  turn_held_.assign(at(edges()), 0);
  cut_.assign(at(edges()), 0);
  A_ = Matrix(unknowns());
  x0_.resize(3 * at(n_)), hat_.resize(3 * at(n_)), drag_.resize(6 * at(n_)), pushed_.resize(3 * at(n_));
  gradient_.resize(at(unknowns())), change_.resize(at(unknowns())), turned_.resize(at(edges()));
  diagonal_.resize(at(unknowns()));
  now_ = next_ = RodEdges(at(edges()));
  gone_.resize(3 * at(n_)), carried_.resize(3 * at(edges())), sine_.resize(at(edges())), cosine_.resize(at(edges()));
  stored_.resize(RodState::size(n_)), trial_.resize(RodState::size(n_));
}

inline Rod::Edge Rod::along(const Vec3& e) {
  const double inverse = 1 / e.norm();
  return {inverse * e, inverse};
}

/// Length of rod that a joint stands for [m]: half of both edges that meet there, half of one edge at a clamp.
inline double Rod::joint_length(int i) const {
  const double before = i > 0 ? rest_[at(i - 1)] : 0, after = i < n_ - 1 ? rest_[at(i)] : 0;
  return 0.5 * (before + after);
}

/// The director after the least rotation that takes one tangent to the other.
[[gnu::flatten]] inline Vec3 Rod::transported(const Vec3& director, const Vec3& from, const Vec3& to) {
  const Vec3 axis = from.cross(to);
  const double c = from.dot(to), along = axis.dot(director) / (1 + c);
  return c * director + axis.cross(director) + along * axis;
}

/// As transported(), then made normal to `to` and of length 1 again, so that repeated transport adds no error.
[[gnu::flatten]] inline Vec3 Rod::carried(const Vec3& director, const Vec3& from, const Vec3& to) {
  Vec3 d = transported(director, from, to);
  d -= d.dot(to) * to;
  return (1 / d.norm()) * d;
}

[[gnu::flatten]] inline double Rod::angle(const Vec3& te, const Vec3& tf, const Vec3& de, const Vec3& df,
                                          double before) {
  const Vec3 d = transported(de, te, tf);
  return turned_from(before, std::atan2(tf.dot(d.cross(df)), d.dot(df)));
}

/// The twist m [rad] plus the whole turns that bring it nearest to `before`.
inline double Rod::turned_from(double before, double m) {
  constexpr double kTurn = 2 * std::numbers::pi;
  return m + kTurn * std::floor((before - m) / kTurn + 0.5);
}

inline RodJoint<Ones> Rod::joint(const RodState& s, int i) const {
  return joint(s, i, i == 0 ? Edge{clamp_[0].tangent, 0} : edge(s, i - 1),
               i == n_ - 1 ? Edge{clamp_[1].tangent, 0} : edge(s, i));
}

inline RodJoint<Ones> Rod::joint(const RodState& s, int i, const Edge& e, const Edge& f) const {
  const auto three = [](const Vec3& v) { return Three<Ones>{{v[0]}, {v[1]}, {v[2]}}; };
  RodJoint<Ones> j;
  const bool first = i == 0, last = i == n_ - 1;
  j.te = three(e.t), j.tf = three(f.t);
  j.inv_e = {e.inverse}, j.inv_f = {f.inverse};
  const double l = joint_length(i);
  j.bend = {section_.bending / l}, j.turn = {section_.twisting / l};
  j.twist = {s.twist[i]};
  if (memory_ != 0) {
    // the binormal of the circle to which the rod would bend
    j.Ke = three(remembered_[at(i)] * (first ? clamp_[0].director : s.material(i - 1)));
    j.Kf = three(remembered_[at(i)] * (last ? clamp_[1].director : s.material(i)));
  }
  return j;
}

/// Derivatives of the joints at V::n inner nodes from i on. now_ must hold their edges.
template <class V>
[[gnu::always_inline]] inline void Rod::differentiate_joints(const RodState& s, int i, bool second, Derivatives* to) const {
  RodJoint<V> j;
  V before, after;
  j.te = now_.t(V{}, at(i - 1)), j.tf = now_.t(V{}, at(i));
  j.inv_e = now_.inverse(V{}, at(i - 1)), j.inv_f = now_.inverse(V{}, at(i));
  before.load(&rest_[at(i - 1)]), after.load(&rest_[at(i)]);
  const V l = 0.5 * (before + after);
  j.bend = section_.bending / l, j.turn = section_.twisting / l;
  j.twist.load(s.twist + i);
  if (memory_ != 0) {
    V remembered;
    remembered.load(&remembered_[at(i)]);
    j.Ke = remembered * vectors(V{}, s.director + 3 * (i - 1)), j.Kf = remembered * vectors(V{}, s.director + 3 * i);
  }
  JointDerivatives<V> d;
  j.differentiate(memory_ != 0, second, d);
  d.apart(to);
}

inline double Rod::energy(const RodState& s) const {
  double E = 0;
  for (int j = 0; j < edges(); ++j) {
    if (cut_[at(j)]) continue;
    const double strain = s.edge(j).norm() / rest_[at(j)] - 1;
    E += 0.5 * section_.stretching * rest_[at(j)] * strain * strain;
  }
  if (section_.bending > 0)
    for (int i = 0; i < n_; ++i)
      if (has_joint(i)) E += joint(s, i).energy(memory_ != 0).x;
  return E;
}

/// Adds a joint's derivatives to those of the rod: e = x_i - x_(i-1), f = x_(i+1) - x_i. A clamped end has only one of the two edges.
inline void Rod::add(int i, Derivatives& d, double* gradient, Matrix* hessian) const {
  if (i == 0) d.e = {}, d.ee = {}, d.ef = {}, d.e_tf = {};
  if (i == n_ - 1) d.f = {}, d.ff = {}, d.ef = {}, d.e_tf = {}, d.f_te = {};
  const int a = 4 * (i - 1), b = 4 * i, c = 4 * (i + 1);  // first unknowns of the three nodes
  const bool has_e = i > 0, has_f = i < n_ - 1;
#pragma GCC unroll 3
  for (int r = 0; r < 3; ++r) {
    if (has_e) gradient[a + r] -= d.e[r].x;
    gradient[b + r] += d.e[r].x - d.f[r].x;
    if (has_f) gradient[c + r] += d.f[r].x;
  }
  if (has_e) gradient[a + 3] += d.te.x;
  if (has_f) gradient[b + 3] += d.tf.x;
  if (hessian == nullptr) return;
  if (has_e) add_before(a, has_f, d, *hessian);
  add_middle(b, has_f, d, *hessian);
  if (has_f) add_after(c, d, *hessian);
}

/// Adds the columns of the first node, at `a`, and of the rotation of its edge.
inline void Rod::add_before(int a, bool has_f, const Derivatives& d, Matrix& H) {
  double* turn = H.column(a + 3);
  turn[0] += d.te_te.x;
#pragma GCC unroll 3
  for (int col = 0; col < 3; ++col) {
    double* h = H.column(a + col) - col;  // entry of unknown a + k at h[k]
#pragma GCC unroll 3
    for (int r = col; r < 3; ++r) h[r] += d.ee[col][r].x;
    h[3] -= d.e_te[col].x;
#pragma GCC unroll 3
    for (int r = 0; r < 3; ++r) h[4 + r] += d.ef[r][col].x - d.ee[col][r].x;
    turn[1 + col] += d.e_te[col].x - d.f_te[col].x;
    if (!has_f) continue;
    h[7] -= d.e_tf[col].x;
#pragma GCC unroll 3
    for (int r = 0; r < 3; ++r) h[8 + r] -= d.ef[r][col].x;
    turn[5 + col] += d.f_te[col].x;
  }
  if (has_f) turn[4] += d.te_tf.x;
}

inline void Rod::add_middle(int b, bool has_f, const Derivatives& d, Matrix& H) {
#pragma GCC unroll 3
  for (int col = 0; col < 3; ++col) {
    double* h = H.column(b + col) - col;
#pragma GCC unroll 3
    for (int r = col; r < 3; ++r) h[r] += (d.ee[col][r].x + d.ff[col][r].x) - (d.ef[col][r].x + d.ef[r][col].x);
    if (!has_f) continue;
    h[3] += d.e_tf[col].x - d.f_tf[col].x;
#pragma GCC unroll 3
    for (int r = 0; r < 3; ++r) h[4 + r] += d.ef[r][col].x - d.ff[col][r].x;
  }
}

/// Adds the columns of the last node, at `c`, and of the rotation of the edge before it.
inline void Rod::add_after(int c, const Derivatives& d, Matrix& H) {
  double* turn = H.column(c - 1);
  turn[0] += d.tf_tf.x;
#pragma GCC unroll 3
  for (int col = 0; col < 3; ++col) {
    turn[1 + col] += d.f_tf[col].x;
    double* h = H.column(c + col) - col;
#pragma GCC unroll 3
    for (int r = col; r < 3; ++r) h[r] += d.ff[col][r].x;
  }
}

/// Adds the stretching of an edge; across the edge it is stiffened by tension_, the tension of the linear model.
inline void Rod::add_stretch(int j, const Edge& e, double* gradient, Matrix* hessian) const {
  const double L = rest_[at(j)], k = section_.stretching / L;
  const Vec3 f = (k * (1 / e.inverse - L)) * e.t;
  const int a = 4 * j, b = a + 4;
#pragma GCC unroll 3
  for (int r = 0; r < 3; ++r) gradient[a + r] -= f[r], gradient[b + r] += f[r];
  if (hessian == nullptr) return;
  const double side = tension_[at(j)] * e.inverse;
  const Vec3 along = (k - side) * e.t;
#pragma GCC unroll 3
  for (int col = 0; col < 3; ++col) {
    double *Ha = hessian->column(a + col) - col, *Hb = hessian->column(b + col) - col;
#pragma GCC unroll 3
    for (int r = 0; r < 3; ++r) {
      const double K = e.t[r] * along[col] + (r == col ? side : 0);
      if (r >= col) Ha[r] += K, Hb[r] += K;
      Ha[4 + r] -= K;
    }
  }
}

[[gnu::flatten]] inline void Rod::differentiate(const RodState& s, double* gradient, Matrix* hessian) const {
  for (int k = 0; k < unknowns(); ++k) gradient[k] = 0;
  if (hessian != nullptr) hessian->set_zero();
  const bool bends = section_.bending > 0, second = hessian != nullptr, fours = has_fours();
  now_.find(s.x);
  Derivatives d[Fours::n];  // of the nodes from `first` to before `beyond`
  int first = 0, beyond = 0;
  const auto known = [&](int i) -> Derivatives& {
    if (i < beyond) return d[i - first];
    const int wide = fours ? Fours::n : Twos::n;
    first = i, beyond = i + 1;
    if (i == 0 || i + wide > n_ - 1) {
      joint(s, i, i == 0 ? Edge{clamp_[0].tangent, 0} : found(i - 1), i == n_ - 1 ? Edge{clamp_[1].tangent, 0} : found(i))
          .differentiate(memory_ != 0, second, d[0]);
    } else {
      fours ? differentiate_four_joints(s, i, second, d) : differentiate_two_joints(s, i, second, d);
      beyond = i + wide;
    }
    return d[0];
  };
  for (int i = 0; i < n_; ++i) {
    if (bends && has_joint(i)) add(i, known(i), gradient, hessian);
    if (i < n_ - 1 && !cut_[at(i)]) add_stretch(i, found(i), gradient, hessian);
  }
}

[[gnu::flatten]] inline void Rod::move(const RodState& from, const double* change, double share, RodState& to) const {
  // everything is computed before anything is written, as `to` may be `from`
  now_.find(from.x);
  for (int i = 0; i < n_; ++i)
    for (int r = 0; r < 3; ++r) gone_[at(3 * i + r)] = from.x[3 * i + r] + share * change[4 * i + r];
  next_.find(gone_.data());
  now_.carry(next_, from.director, carried_.data());
  for (int j = 0; j < edges(); ++j) {
    const double turn = share * change[4 * j + 3];
    if (turn == 0) continue;
    Eigen::Map<Vec3> d(carried_.data() + 3 * j);
    const Vec3 across = d;
    d = std::cos(turn) * across + std::sin(turn) * next_.t(at(j)).cross(across);
  }
  next_.twists(carried_.data(), sine_.data(), cosine_.data());
  const auto director = [&](int j) { return Vec3(Eigen::Map<const Vec3>(carried_.data() + 3 * j)); };
  const int last = n_ - 1;
  for (int i = 0; i <= last; ++i) {
    double& twist = to.twist[i];
    if (!has_joint(i))
      twist = 0;
    else if (i == 0)
      twist = angle(clamp_[0].tangent, next_.t(0), clamp_[0].director, director(0), from.twist[0]);
    else if (i == last)
      twist = angle(next_.t(at(last - 1)), clamp_[1].tangent, director(last - 1), clamp_[1].director, from.twist[last]);
    else
      twist = turned_from(from.twist[i], std::atan2(sine_[at(i - 1)], cosine_[at(i - 1)]));
  }
  std::copy_n(gone_.data(), 3 * n_, to.x);
  std::copy_n(carried_.data(), 3 * edges(), to.director);
}

inline double Rod::twisted(const RodState& s, int i, double before) const {
  const bool first = i == 0, last = i == n_ - 1;
  return angle(first ? clamp_[0].tangent : edge(s, i - 1).t, last ? clamp_[1].tangent : edge(s, i).t,
               first ? clamp_[0].director : s.material(i - 1), last ? clamp_[1].director : s.material(i), before);
}

inline double Rod::tension(const RodState& s, int j) const {
  return cut_[at(j)] ? 0.0 : section_.stretching * (s.edge(j).norm() / rest_[at(j)] - 1);
}

inline double Rod::curvature(const RodState& s, int i) const {
  return joint(s, i).curvature().norm().x / joint_length(i);
}

inline double Rod::most_curvature(const RodState& s) const {
  now_.find(s.x), now_.bends(sine_.data());
  double most = 0;
  for (int i = 1; i < n_ - 1; ++i) most = std::max(most, sine_[at(i - 1)] / joint_length(i));
  return most;
}

inline double Rod::turns(const RodState& s) const {
  double sum = 0;
  for (int i = 0; i < n_; ++i) sum += s.twist[i];
  return sum / (2 * std::numbers::pi);
}

}  // namespace swage::toolkit
