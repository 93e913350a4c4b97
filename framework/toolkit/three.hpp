// SPDX-License-Identifier: Apache-2.0
//
// Several vectors at once, component by component: each gets the bits of Eigen's operations on it alone. Header-only.
#pragma once

#include "toolkit/wide.hpp"

namespace swage::toolkit {

template <class V>
struct Three {
  V x, y, z;

  [[gnu::always_inline]] V& operator[](int i) { return i == 0 ? x : i == 1 ? y : z; }
  [[gnu::always_inline]] const V& operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  [[gnu::always_inline]] Three operator-() const { return {-x, -y, -z}; }
  [[gnu::always_inline]] Three operator-(const Three& b) const { return {x - b.x, y - b.y, z - b.z}; }
  [[gnu::always_inline]] Three operator+(const Three& b) const { return {x + b.x, y + b.y, z + b.z}; }
  [[gnu::always_inline]] Three operator/(V s) const { return {x / s, y / s, z / s}; }
  [[gnu::always_inline]] V dot(const Three& b) const { return (x * b.x + y * b.y) + z * b.z; }
  [[gnu::always_inline]] Three cross(const Three& b) const {
    return {y * b.z - z * b.y, z * b.x - x * b.z, x * b.y - y * b.x};
  }
  [[gnu::always_inline]] V norm() const {
    V n = dot(*this);
    n.root();
    return n;
  }
};
template <class V>
[[gnu::always_inline]] inline Three<V> operator*(V s, const Three<V>& a) {
  return {s * a.x, s * a.y, s * a.z};
}

/// Loads consecutive vectors, 3 numbers each.
template <class V>
[[gnu::always_inline]] inline Three<V> vectors(V v, const double* x) {
  Three<V> a{v, v, v};
  a.x.load(x, 3), a.y.load(x + 1, 3), a.z.load(x + 2, 3);
  return a;
}

}  // namespace swage::toolkit
