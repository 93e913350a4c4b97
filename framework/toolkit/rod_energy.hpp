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
  if (!curved()) return j;
  // the binormal of the circle to which the rod would bend
  const Vec3 de = first ? clamp_[0].director : s.material(i - 1), df = last ? clamp_[1].director : s.material(i);
  if (set_ == nullptr) {
    j.Ke = three(remembered_[at(i)] * de), j.Kf = three(remembered_[at(i)] * df);
  } else {
    const double a = set_[2 * i], b = set_[2 * i + 1];
    j.Ke = three(a * de + b * e.t.cross(de)), j.Kf = three(a * df + b * f.t.cross(df));
  }
  return j;
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
      if (has_joint(i)) E += joint(s, i).energy(curved()).x;
  return E;
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
  std::swap(now_, next_);  // `to` is looked at next
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
