// SPDX-License-Identifier: Apache-2.0
//
// Dense elimination in one fixed order, so that the result has the same bits with every compiler and machine: no library that
// blocks by the size of a cache. [main]
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace swage::tissue {

/// Symmetric matrix, row by row; only its lower triangle is read and written.
struct Symmetric {
  size_t n = 0;
  std::vector<double> a;
  explicit Symmetric(size_t size) : n(size), a(size * size, 0.0) {}
  double* row(size_t i) { return a.data() + i * n; }
  const double* row(size_t i) const { return a.data() + i * n; }
};

/// Eliminates the first `first` unknowns of a positive definite matrix (Cholesky, in panels): the remaining block becomes its
/// Schur complement.
inline void eliminate(Symmetric& m, size_t first) {
  constexpr size_t kPanel = 8;  // columns at a time: those fit beside a row in the level 1 cache
  std::vector<double> column(kPanel * m.n);
  for (size_t k = 0; k < first; k += kPanel) {
    const size_t end = std::min(k + kPanel, first), width = end - k;
    for (size_t j = k; j < end; ++j) {
      const double d = std::sqrt(m.row(j)[j]);
      m.row(j)[j] = d;
      for (size_t i = j + 1; i < m.n; ++i) m.row(i)[j] /= d;
      for (size_t i = j + 1; i < m.n; ++i)
        for (size_t c = j + 1; c < end && c <= i; ++c) m.row(i)[c] -= m.row(i)[j] * m.row(c)[j];
    }
    for (size_t c = 0; c < kPanel; ++c)
      for (size_t i = end; i < m.n; ++i) column[c * m.n + i] = c < width ? m.row(i)[k + c] : 0.0;
    const double* const l = column.data();
    for (size_t i = end; i < m.n; ++i) {
      double* const row = m.row(i);
      double f[kPanel];
      for (size_t c = 0; c < kPanel; ++c) f[c] = l[c * m.n + i];
      for (size_t j = end; j <= i; ++j)
        row[j] -= f[0] * l[j] + f[1] * l[m.n + j] + f[2] * l[2 * m.n + j] + f[3] * l[3 * m.n + j] +
                  f[4] * l[4 * m.n + j] + f[5] * l[5 * m.n + j] + f[6] * l[6 * m.n + j] +
                  f[7] * l[7 * m.n + j];
    }
  }
}

/// The remaining block of a matrix after its first unknowns.
inline Symmetric rest(const Symmetric& m, size_t first) {
  Symmetric out(m.n - first);
  for (size_t i = 0; i < out.n; ++i)
    for (size_t j = 0; j <= i; ++j) out.row(i)[j] = m.row(first + i)[first + j];
  return out;
}

/// Inverse of a positive definite matrix, both triangles.
inline Symmetric inverse(const Symmetric& m) {
  Symmetric both(2 * m.n), out(m.n);
  for (size_t i = 0; i < m.n; ++i) {
    for (size_t j = 0; j <= i; ++j) both.row(i)[j] = m.row(i)[j];
    both.row(m.n + i)[i] = 1;
  }
  eliminate(both, m.n);
  for (size_t i = 0; i < m.n; ++i)
    for (size_t j = 0; j <= i; ++j) out.row(i)[j] = out.row(j)[i] = -both.row(m.n + i)[m.n + j];
  return out;
}

}  // namespace swage::tissue
