// SPDX-License-Identifier: Apache-2.0
//
// Small dense systems in buffers of the caller: no allocation, fixed order of operations, so the same bits everywhere.
// Matrices are row-major, n x n, without gaps. Header-only, [rt].
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "dynamics/lines.hpp"

namespace swage::dynamics {

/// Sign of the determinant from the factors of lu_factor: -1, 0 or 1.
inline int determinant_sign(size_t n, const double* LU, const uint32_t* row) noexcept {
  int sign = 1;
  for (size_t i = 0; i < n; ++i) {
    const double pivot = LU[i * n + i];
    if (pivot == 0) return 0;
    if (pivot < 0) sign = -sign;
    for (size_t j = i + 1; j < n; ++j)
      if (row[j] < row[i]) sign = -sign;
  }
  return sign;
}

/// x = A^-1 b with the factors of lu_factor. x and b must not overlap.
inline void lu_solve(size_t n, const double* LU, const uint32_t* row, const double* b, double* x) noexcept {
  for (size_t i = 0; i < n; ++i) {
    double sum = b[row[i]];
    for (size_t j = 0; j < i; ++j) sum -= LU[i * n + j] * x[j];
    x[i] = sum;
  }
  for (size_t i = n; i-- > 0;) {
    double sum = x[i];
    for (size_t j = i + 1; j < n; ++j) sum -= LU[i * n + j] * x[j];
    x[i] = sum / LU[i * n + i];
  }
}

namespace dense {

/// The row of the largest entry of a column from the diagonal on; n where that is zero or not finite.
inline size_t pivot_row(size_t n, size_t k, const double* A) noexcept {
  size_t best = k;
  double largest = std::abs(A[k * n + k]);
  for (size_t i = k + 1; i < n; ++i)
    if (const double candidate = std::abs(A[i * n + k]); candidate > largest) largest = candidate, best = i;
  return largest > 0 && std::isfinite(largest) ? best : n;
}

template <class V>
[[gnu::always_inline]] inline bool lu_factor(size_t n, double* A, uint32_t* row) noexcept {
  for (size_t i = 0; i < n; ++i) row[i] = static_cast<uint32_t>(i);
  for (size_t k = 0; k < n; ++k) {
    const size_t best = pivot_row(n, k, A);
    if (best == n) return false;
    if (best != k) {
      std::swap_ranges(A + k * n, A + (k + 1) * n, A + best * n);
      std::swap(row[k], row[best]);
    }
    const double inverse = 1 / A[k * n + k];
    for (size_t i = k + 1; i < n; ++i) {
      const double l = A[i * n + k] * inverse;
      A[i * n + k] = l;
      if (l != 0) lines::take<V>(n - k - 1, l, A + k * n + k + 1, A + i * n + k + 1);
    }
  }
  return true;
}
SWAGE_FOURS inline bool lu_factor_by_fours(size_t n, double* A, uint32_t* row) noexcept { return lu_factor<toolkit::Fours>(n, A, row); }

/// Eliminates two pivots at a time: the operations on each number and their order are those of one at a time, with half the loads and
/// stores.
template <class V>
[[gnu::always_inline]] inline bool ldl_factor(size_t n, double* A) noexcept {
  const auto pivots = [](double pivot) { return pivot > 0 && std::isfinite(pivot); };
  for (size_t k = 0; k < n; k += 2) {
    double* p = A + k * n;
    if (!pivots(p[k])) return false;
    const double inverse_p = 1 / p[k];
    if (k + 1 == n) return true;
    double* q = A + (k + 1) * n;
    lines::take<V>(n - k - 1, p[k + 1] * inverse_p, p + k + 1, q + k + 1);
    if (!pivots(q[k + 1])) return false;
    const double inverse_q = 1 / q[k + 1];
    for (size_t i = k + 2; i < n; ++i) {
      const double l = p[i] * inverse_p, m = q[i] * inverse_q;
      if (l == 0 && m == 0) continue;
      lines::take<V>(n - i, l, p + i, m, q + i, A + i * n + i);
    }
  }
  return true;
}
SWAGE_FOURS inline bool ldl_factor_by_fours(size_t n, double* A) noexcept { return ldl_factor<toolkit::Fours>(n, A); }

/// Four rows of U at a time: each is subtracted from the rest of x in the order of the rows, so that the bits are those of one at a time,
/// with a quarter of the loads and stores of x.
template <class V>
[[gnu::always_inline]] inline void solve_transposed(size_t n, const double* U, double* x) noexcept {
  size_t k = 0;
  for (; k + 4 <= n; k += 4) {
    const double* const line[4] = {U + k * n, U + (k + 1) * n, U + (k + 2) * n, U + (k + 3) * n};
    const double* rest[4];
    double d[4];
    for (size_t a = 0; a < 4; ++a) {
      d[a] = x[k + a];
      for (size_t b = 0; b < a; ++b) d[a] -= d[b] * line[b][k + a];
      x[k + a] = d[a] /= line[a][k + a];
      rest[a] = line[a] + k + 4;
    }
    lines::take_four<V>(n - k - 4, d, rest, x + k + 4);
  }
  for (; k < n; ++k) {
    const double* line = U + k * n;
    x[k] /= line[k];
    for (size_t i = k + 1; i < n; ++i) x[i] -= x[k] * line[i];
  }
}
SWAGE_FOURS inline void solve_transposed_by_fours(size_t n, const double* U, double* x) noexcept {
  solve_transposed<toolkit::Fours>(n, U, x);
}

}  // namespace dense

/// Factors A in place as P A = L U, partial pivoting. False when a pivot is zero or not finite. `row`: P as n row indices.
inline bool lu_factor(size_t n, double* A, uint32_t* row) noexcept {
  return toolkit::has_fours() ? dense::lu_factor_by_fours(n, A, row) : dense::lu_factor<toolkit::Twos>(n, A, row);
}

/// Factors a symmetric, positive definite A in place as L D L^T: reads its upper half and leaves D L^T there. False
/// when a pivot is not above zero or not finite.
inline bool ldl_factor(size_t n, double* A) noexcept {
  return toolkit::has_fours() ? dense::ldl_factor_by_fours(n, A) : dense::ldl_factor<toolkit::Twos>(n, A);
}

/// Dot product by four partial sums of fixed order, so that the bits do not depend on the compiler.
inline double dot(size_t n, const double* a, const double* b) noexcept {
  using Two = Eigen::Vector2d;
  const auto two = [](const double* x) { return Eigen::Map<const Two>(x); };
  Two s = Two::Zero(), t = Two::Zero();
  size_t i = 0;
  for (; i + 4 <= n; i += 4) s += two(a + i).cwiseProduct(two(b + i)), t += two(a + i + 2).cwiseProduct(two(b + i + 2));
  for (; i < n; ++i) s[0] += a[i] * b[i];
  return (s[0] + s[1]) + (t[0] + t[1]);
}

/// x = A^-1 b with the factors of ldl_factor. x and b must not overlap.
inline void ldl_solve(size_t n, const double* DLt, const double* b, double* x) noexcept {
  for (size_t i = 0; i < n; ++i) x[i] = b[i];
  for (size_t k = 0; k < n; ++k) {
    const double* line = DLt + k * n;
    x[k] /= line[k];
    const auto rest = static_cast<Eigen::Index>(n - k - 1);
    Eigen::Map<Eigen::VectorXd>(x + k + 1, rest) -=
        x[k] * Eigen::Map<const Eigen::VectorXd>(line + k + 1, rest);
  }
  for (size_t k = n; k-- > 0;) {
    const double* line = DLt + k * n;
    x[k] -= dot(n - k - 1, line + k + 1, x + k + 1) / line[k];
  }
}

/// Factors a symmetric, positive definite A in place as U^T U, as ldl_factor does, and leaves U in its upper half.
inline bool cholesky_factor(size_t n, double* A) noexcept {
  if (!ldl_factor(n, A)) return false;
  for (size_t k = 0; k < n; ++k) {
    const auto rest = static_cast<Eigen::Index>(n - k);
    Eigen::Map<Eigen::VectorXd>(A + k * n + k, rest) *= 1 / std::sqrt(A[k * n + k]);
  }
  return true;
}

/// x = U^-T x, U in the upper half.
inline void solve_transposed(size_t n, const double* U, double* x) noexcept {
  toolkit::has_fours() ? dense::solve_transposed_by_fours(n, U, x) : dense::solve_transposed<toolkit::Twos>(n, U, x);
}

/// x = U^-1 x, U in the upper half.
inline void solve_upper(size_t n, const double* U, double* x) noexcept {
  for (size_t k = n; k-- > 0;)
    x[k] = (x[k] - dot(n - k - 1, U + k * n + k + 1, x + k + 1)) / U[k * n + k];
}

}  // namespace swage::dynamics
