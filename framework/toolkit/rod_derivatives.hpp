// SPDX-License-Identifier: Apache-2.0
//
// Rod: the gradient and the Hessian of its elastic energy. Part of rod.hpp.
#pragma once

#include "toolkit/rod.hpp"

namespace swage::toolkit {

/// V::n inner joints from i on, into the places from `at` on. now_ must hold their edges.
template <class V>
[[gnu::always_inline]] inline void Rod::take_inner_joints(const RodState& s, int i, int place, bool second) const {
  RodJoint<V> j;
  V before, after;
  j.te = now_.t(V{}, at(i - 1)), j.tf = now_.t(V{}, at(i));
  j.inv_e = now_.inverse(V{}, at(i - 1)), j.inv_f = now_.inverse(V{}, at(i));
  before.load(&rest_[at(i - 1)]), after.load(&rest_[at(i)]);
  const V l = 0.5 * (before + after);
  j.bend = section_.bending / l, j.turn = section_.twisting / l;
  j.twist.load(s.twist + i);
  const bool curved = this->curved();
  if (curved) {
    const Three<V> de = vectors(V{}, s.director + 3 * (i - 1)), df = vectors(V{}, s.director + 3 * i);
    V a, b;
    if (set_ == nullptr) {
      a.load(&remembered_[at(i)]);
      j.Ke = a * de, j.Kf = a * df;
    } else {
      a.load(set_ + 2 * i, 2), b.load(set_ + 2 * i + 1, 2);
      j.Ke = a * de + b * j.te.cross(de), j.Kf = a * df + b * j.tf.cross(df);
    }
  }
  JointDerivatives<V> d;
  j.differentiate(curved, second, d);
  RodAssembly::set(d, place, second, parts_.joint);
}

/// One joint: e = x_i - x_(i-1), f = x_(i+1) - x_i. A clamped end has only one of the two edges, and an edge's rotation goes with it.
inline void Rod::take_joint(const RodState& s, int i, int place, bool second) const {
  Derivatives d{};
  if (i >= 0 && i < n_ && has_joint(i)) {
    joint(s, i, i == 0 ? Edge{clamp_[0].tangent, 0} : found(i - 1), i == n_ - 1 ? Edge{clamp_[1].tangent, 0} : found(i))
        .differentiate(curved(), second, d);
    if (i == 0) d.e = {}, d.te = {}, d.ee = {}, d.e_te = {}, d.te_te = {};
    if (i == n_ - 1) d.f = {}, d.tf = {}, d.ff = {}, d.f_tf = {}, d.tf_tf = {};
    if (i == 0 || i == n_ - 1) d.ef = {}, d.e_tf = {}, d.f_te = {}, d.te_tf = {};
  }
  RodAssembly::set(d, place, second, parts_.joint);
}

/// V::n edges from j on. Across itself an edge is stiffened by tension_, the tension of the linear model.
template <class V>
[[gnu::always_inline]] inline void Rod::take_edges(int j, int place, bool second) const {
  V L, tension;
  L.load(&rest_[at(j)]), tension.load(&tension_[at(j)]);
  EdgeDerivatives<V> d;
  d.differentiate(now_.t(V{}, at(j)), now_.inverse(V{}, at(j)), L, section_.stretching / L, tension, second);
  RodAssembly::set(d, place, second, parts_.edge);
}

inline void Rod::take_edge(int j, int place, bool second) const {
  if (j >= 0 && j < edges() && !cut_[at(j)]) return take_edges<Ones>(j, place, second);
  RodAssembly::set(EdgeDerivatives<Ones>{}, place, second, parts_.edge);
}

/// The joints and edges i to i + 3.
template <class V>
[[gnu::always_inline]] inline void Rod::take_four(const RodState& s, int i, bool second) const {
  constexpr int kFour = Eight::group;
  const bool inner = i > 0 && i + kFour < n_;  // and so all edges are there
  bool whole = inner;
  for (int j = i - 1; whole && j < i + kFour; ++j) whole = !cut_[at(j)];
  for (int k = 0; k < kFour && section_.bending > 0; k += whole ? V::n : 1)
    whole ? take_inner_joints<V>(s, i + k, k, second) : take_joint(s, i + k, k, second);
  for (int k = 0; k < kFour; k += whole ? V::n : 1) whole ? take_edges<V>(i + k, k, second) : take_edge(i + k, k, second);
}

/// Goes along the rod by four joints and edges, and adds up the four nodes i - 3 to i whose last parts these are.
template <class V>
[[gnu::always_inline]] inline void Rod::differentiate_with(const RodState& s, double* gradient, double* hessian) const {
  constexpr std::ptrdiff_t kStride = Matrix::kStride;
  constexpr int kFour = Eight::group;
  const bool second = hessian != nullptr;
  const auto add_up = [&](auto v, int node, int place) __attribute__((always_inline)) {
    using N = decltype(v);
    Three<N> x;
    N turn;
    parts_.gradient(place, x, turn);
    if (node < n_ - 1)
      store_fours(x.x, x.y, x.z, turn, gradient + 4 * node, 4);
    else
      for (int r = 0; r < 3; ++r) x[r].store(gradient + 4 * node + r, 1);
    if (second) parts_.template columns<N>(place, hessian + 4 * node * kStride, kStride);
  };
  parts_.clear();
  for (int i = 1 - kFour; i < n_ + kFour - 1; i += kFour) {
    parts_.shift(second);
    take_four<V>(s, i, second);
    const int first = i - kFour + 1;
    if (first >= 0 && i < n_ - 1) {
      for (int k = 0; k < kFour; k += V::n) add_up(V{}, first + k, k);
    } else {
      for (int k = std::max(0, -first); k < kFour && first + k < n_; ++k) add_up(Ones{}, first + k, k);
    }
  }
}

inline void Rod::differentiate(const RodState& s, double* gradient, Matrix* hessian) const {
  if (hessian != nullptr) hessian->clear_beyond();
  differentiate_into(s, gradient, hessian != nullptr ? hessian->column(0) : nullptr);
}
inline void Rod::differentiate_into(const RodState& s, double* gradient, double* hessian) const {
  now_.find(s.x);
  has_fours() ? differentiate_by_fours(s, gradient, hessian) : differentiate_by_twos(s, gradient, hessian);
}

}  // namespace swage::toolkit
