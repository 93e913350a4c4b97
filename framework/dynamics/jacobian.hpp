// SPDX-License-Identifier: Apache-2.0
//
// What one constraint adds to the system of its island. Header-only, pure functions, [rt].
#pragma once

#include <Eigen/Core>
#include <algorithm>

#include "dynamics/island.hpp"

namespace swage::dynamics {

/// n as an Eigen::Index.
inline Eigen::Index index(size_t n) noexcept { return static_cast<Eigen::Index>(n); }

/// A vector given in the axes of a constraint, in W.
inline Vec3 in_world(const Constraint& constraint, double n, double t1, double t2) {
  return n * constraint.n + t1 * constraint.t1 + t2 * constraint.t2;
}
inline void put(const Vec3& a, double* to) { to[0] = a[0], to[1] = a[1], to[2] = a[2]; }

/// u + J d.
inline Displacement displaced(const Constraint& constraint, const double* d) {
  const uint32_t columns = constraint.size_a + constraint.size_b;
  const double *J0 = constraint.J, *J1 = J0 + columns, *J2 = J1 + columns;
  const double *da = d + constraint.offset_a, *db = d + constraint.offset_b;
  Displacement u = constraint.at;
  for (uint32_t i = 0; i < constraint.size_a; ++i) {
    u.g += J0[i] * da[i];
    u.s1 += J1[i] * da[i];
    u.s2 += J2[i] * da[i];
  }
  for (uint32_t i = 0; i < constraint.size_b; ++i) {
    u.g += J0[constraint.size_a + i] * db[i];
    u.s1 += J1[constraint.size_a + i] * db[i];
    u.s2 += J2[constraint.size_a + i] * db[i];
  }
  return u;
}

/// F -= J' f.
inline void add_force(const Constraint& constraint, double* F) {
  const uint32_t columns = constraint.size_a + constraint.size_b;
  const double *J0 = constraint.J, *J1 = J0 + columns, *J2 = J1 + columns;
  double *Fa = F + constraint.offset_a, *Fb = F + constraint.offset_b;
  for (uint32_t i = 0; i < constraint.size_a; ++i)
    Fa[i] -= J0[i] * constraint.f.fn + J1[i] * constraint.f.f1 + J2[i] * constraint.f.f2;
  for (uint32_t j = 0, i = constraint.size_a; i < columns; ++i, ++j)
    Fb[j] -= J0[i] * constraint.f.fn + J1[i] * constraint.f.f1 + J2[i] * constraint.f.f2;
}

/// H += J' D J, row by row of H and some columns at a time, so that memory is written contiguously.
inline void add_stiffness(const Constraint& constraint, const Tangent& D, size_t n, double* H) {
  constexpr uint32_t kBlock = 64;
  double k0[kBlock], k1[kBlock], k2[kBlock];
  const uint32_t columns = constraint.size_a + constraint.size_b;
  const double *J0 = constraint.J, *J1 = J0 + columns, *J2 = J1 + columns;
  for (const bool of_a : {true, false}) {
    const uint32_t begin = of_a ? 0 : constraint.size_a, end = of_a ? constraint.size_a : columns;
    for (uint32_t first = begin; first < end; first += kBlock) {
      const uint32_t m = std::min(kBlock, end - first);
      for (uint32_t j = 0; j < m; ++j) {
        const double j0 = J0[first + j], j1 = J1[first + j], j2 = J2[first + j];
        k0[j] = D.nn * j0;
        k1[j] = D.n1 * j0 + D.t11 * j1 + D.t12 * j2;
        k2[j] = D.n2 * j0 + D.t12 * j1 + D.t22 * j2;
      }
      double* const at = H + (of_a ? constraint.offset_a : constraint.offset_b) + first - begin;
      const Eigen::Map<const Eigen::VectorXd> K0(k0, m), K1(k1, m), K2(k2, m);
      for (uint32_t i = 0; i < columns; ++i) {
        const uint32_t line =
            i < constraint.size_a ? constraint.offset_a + i : constraint.offset_b + i - constraint.size_a;
        Eigen::Map<Eigen::VectorXd>(at + line * n, m) += J0[i] * K0 + J1[i] * K1 + J2[i] * K2;
      }
    }
  }
}

}  // namespace swage::dynamics
