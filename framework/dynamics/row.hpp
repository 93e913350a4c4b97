// SPDX-License-Identifier: Apache-2.0
//
// What one row adds to the system of its island. Header-only, pure functions, [rt].
#pragma once

#include "dynamics/island.hpp"

namespace swage::dynamics {

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

/// H += J' D J.
inline void add_stiffness(const Row& row, const Tangent& D, size_t n, double* H) {
  const uint32_t columns = row.size_a + row.size_b;
  const double *J0 = row.J, *J1 = J0 + columns, *J2 = J1 + columns;
  for (uint32_t j = 0; j < columns; ++j) {
    const double k0 = D.nn * J0[j];
    const double k1 = D.n1 * J0[j] + D.t11 * J1[j] + D.t12 * J2[j];
    const double k2 = D.n2 * J0[j] + D.t12 * J1[j] + D.t22 * J2[j];
    double* column = H + (j < row.size_a ? row.offset_a + j : row.offset_b + j - row.size_a);
    double *Ha = column + row.offset_a * n, *Hb = column + row.offset_b * n;
    for (uint32_t i = 0; i < row.size_a; ++i) Ha[i * n] += J0[i] * k0 + J1[i] * k1 + J2[i] * k2;
    for (uint32_t b = 0, i = row.size_a; i < columns; ++i, ++b)
      Hb[b * n] += J0[i] * k0 + J1[i] * k1 + J2[i] * k2;
  }
}

}  // namespace swage::dynamics
