// SPDX-License-Identifier: Apache-2.0
//
// What one row adds to the system of its island. Header-only, pure functions, [rt].
#pragma once

#include <algorithm>

#include "dynamics/island.hpp"

namespace swage::dynamics {

/// From the axes of a row to W.
inline Vec3 in_world(const Row& row, double n, double t1, double t2) {
  return n * row.n + t1 * row.t1 + t2 * row.t2;
}
inline void put(const Vec3& a, double* to) { to[0] = a[0], to[1] = a[1], to[2] = a[2]; }

/// u + J d.
inline Displacement displaced(const Row& row, const double* d) {
  const uint32_t columns = row.size_a + row.size_b;
  const double *J0 = row.J, *J1 = J0 + columns, *J2 = J1 + columns;
  const double *da = d + row.offset_a, *db = d + row.offset_b;
  Displacement u = row.at;
  for (uint32_t i = 0; i < row.size_a; ++i) {
    u.g += J0[i] * da[i];
    u.s1 += J1[i] * da[i];
    u.s2 += J2[i] * da[i];
  }
  for (uint32_t i = 0; i < row.size_b; ++i) {
    u.g += J0[row.size_a + i] * db[i];
    u.s1 += J1[row.size_a + i] * db[i];
    u.s2 += J2[row.size_a + i] * db[i];
  }
  return u;
}

/// F -= J' f.
inline void add_force(const Row& row, double* F) {
  const uint32_t columns = row.size_a + row.size_b;
  const double *J0 = row.J, *J1 = J0 + columns, *J2 = J1 + columns;
  double *Fa = F + row.offset_a, *Fb = F + row.offset_b;
  for (uint32_t i = 0; i < row.size_a; ++i) Fa[i] -= J0[i] * row.f.fn + J1[i] * row.f.f1 + J2[i] * row.f.f2;
  for (uint32_t j = 0, i = row.size_a; i < columns; ++i, ++j)
    Fb[j] -= J0[i] * row.f.fn + J1[i] * row.f.f1 + J2[i] * row.f.f2;
}

/// H += J' D J, row by row of H and some columns at a time: what is written lies side by side.
inline void add_stiffness(const Row& row, const Tangent& D, size_t n, double* H) {
  constexpr uint32_t kBlock = 64;
  double k0[kBlock], k1[kBlock], k2[kBlock];
  const uint32_t columns = row.size_a + row.size_b;
  const double *J0 = row.J, *J1 = J0 + columns, *J2 = J1 + columns;
  for (const bool of_a : {true, false}) {
    const uint32_t begin = of_a ? 0 : row.size_a, end = of_a ? row.size_a : columns;
    for (uint32_t first = begin; first < end; first += kBlock) {
      const uint32_t m = std::min(kBlock, end - first);
      for (uint32_t j = 0; j < m; ++j) {
        const double j0 = J0[first + j], j1 = J1[first + j], j2 = J2[first + j];
        k0[j] = D.nn * j0;
        k1[j] = D.n1 * j0 + D.t11 * j1 + D.t12 * j2;
        k2[j] = D.n2 * j0 + D.t12 * j1 + D.t22 * j2;
      }
      double* const at = H + (of_a ? row.offset_a : row.offset_b) + first - begin;
      const Eigen::Map<const Eigen::VectorXd> K0(k0, m), K1(k1, m), K2(k2, m);
      for (uint32_t i = 0; i < columns; ++i) {
        const uint32_t line = i < row.size_a ? row.offset_a + i : row.offset_b + i - row.size_a;
        Eigen::Map<Eigen::VectorXd>(at + line * n, m) += J0[i] * K0 + J1[i] * K1 + J2[i] * K2;
      }
    }
  }
}

}  // namespace swage::dynamics
