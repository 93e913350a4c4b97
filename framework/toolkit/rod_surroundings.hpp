// SPDX-License-Identifier: Apache-2.0
//
// Rod: the fluid around it, and springs on its nodes. Part of rod.hpp.
#pragma once

#include "toolkit/rod.hpp"

namespace swage::toolkit {

/// Adds half an edge's drag to each of its nodes: c (1 - t t' / 2), as xx yx zx yy zy zz. The added mass of a cylinder that moves across
/// its axis is that of the displaced fluid (Lamb 1932, art. 68): it is in the same matrix, and its momentum in pushed_. V::n edges from j on.
template <class V>
[[gnu::always_inline]] inline void Rod::add_drag_of(V v, const RodState& s, const RodFluid& fluid, int j) {
  constexpr int kOf = 6, kApart = 8;
  constexpr int kRow[kOf] = {0, 1, 2, 1, 2, 2}, kColumn[kOf] = {0, 0, 0, 1, 1, 2};
  const double carried = fluid.carried * std::numbers::pi * section_.radius * section_.radius;  // kg/m
  const Three<V> t = now_.t(v, at(j)), half = every<V>(0.5) * t;
  double across[2][V::n], drags[V::n * kApart] = {}, carries[V::n * kApart] = {};  // m/s; the matrices of either
  for (int end = 0; end < 2; ++end) {
    const Three<V> u = vectors(v, s.v + 3 * (j + end));
    (u - u.dot(t) * t).norm().store(across[end]);
  }
  for (int k = 0; k < kOf; ++k) {
    const V one = every<V>(kRow[k] == kColumn[k] ? 1 : 0);
    (one - half[kRow[k]] * t[kColumn[k]]).store(drags + k, kApart);
    if (carried > 0) (one - t[kRow[k]] * t[kColumn[k]]).store(carries + k, kApart);
  }
  for (int e = 0; e < V::n; ++e)
    for (int end = 0; end < 2; ++end) {
      const double rest = rest_[at(j + e)], inertia = 0.5 * rest * carried * m_hh_;
      const double c = 0.5 * rest * rod_drag(fluid, 2 * section_.radius, across[end][e]);
      double* to = drag_.data() + kOf * (j + e + end);
      Line<Twos, kOf> D;
      D.load(to);
      D.add(c / g_, drags + kApart * e);
      if (inertia > 0) D.add(inertia, carries + kApart * e);
      D.store(to);
    }
}

/// The momentum of the fluid that goes along.
inline void Rod::add_pushed(const RodFluid& fluid) {
  const double carried = fluid.carried * std::numbers::pi * section_.radius * section_.radius;
  for (int j = 0; carried > 0 && j < edges(); ++j) {
    const Vec3 t = now_.t(at(j));
    const double inertia = 0.5 * rest_[at(j)] * carried * m_hh_;
    for (const int i : {j, j + 1}) {
      const Vec3 goes = Eigen::Map<const Vec3>(hat_.data() + 3 * i) - Eigen::Map<const Vec3>(x0_.data() + 3 * i);
      Eigen::Map<Vec3>(pushed_.data() + 3 * i) += inertia * (goes - goes.dot(t) * t);
    }
  }
}

inline void Rod::add_drag(const RodState& s, const RodLoad& load) {
  std::fill(drag_.begin(), drag_.end(), 0.0);
  std::fill(pushed_.begin(), pushed_.end(), 0.0);
  add_springs(load);
  if (!(load.fluid.viscosity > 0) || load.h == 0) return;
  now_.find(s.x);
  has_fours() ? add_drag_by_fours(s, load.fluid) : add_drag_by_twos(s, load.fluid);
  add_pushed(load.fluid);
}

inline void Rod::add_springs(const RodLoad& load) {
  for (size_t k = 0; load.h > 0 && k < load.spring.size(); ++k) drag_[k] += load.spring[k];
}

}  // namespace swage::toolkit
