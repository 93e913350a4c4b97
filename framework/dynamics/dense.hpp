// SPDX-License-Identifier: Apache-2.0
//
// Small dense systems in buffers of the caller: no allocation, fixed order of operations, so the same bits everywhere.
// Matrices are row-major, n x n, without gaps. Header-only, [rt].
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace swage::dynamics {

/// Factors A in place as P A = L U, partial pivoting. False when a pivot is zero or not finite. `row`: n.
inline bool lu_factor(size_t n, double* A, uint32_t* row) noexcept {
  for (size_t i = 0; i < n; ++i) row[i] = static_cast<uint32_t>(i);
  for (size_t k = 0; k < n; ++k) {
    size_t best = k;
    double largest = std::abs(A[k * n + k]);
    for (size_t i = k + 1; i < n; ++i) {
      const double candidate = std::abs(A[i * n + k]);
      if (candidate > largest) largest = candidate, best = i;
    }
    if (!(largest > 0) || !std::isfinite(largest)) return false;
    if (best != k) {
      for (size_t j = 0; j < n; ++j) std::swap(A[k * n + j], A[best * n + j]);
      std::swap(row[k], row[best]);
    }

    const double inverse = 1 / A[k * n + k];
    for (size_t i = k + 1; i < n; ++i) {
      const double l = A[i * n + k] * inverse;
      A[i * n + k] = l;
      if (l == 0) continue;
      const auto rest = static_cast<Eigen::Index>(n - k - 1);
      Eigen::Map<Eigen::VectorXd>(A + i * n + k + 1, rest) -=
          l * Eigen::Map<const Eigen::VectorXd>(A + k * n + k + 1, rest);
    }
  }
  return true;
}

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

/// Factors a symmetric, positive definite A in place as L D L^T, of which it reads the upper half and leaves D L^T there. False
/// when a pivot is not above zero or not finite.
inline bool ldl_factor(size_t n, double* A) noexcept {
  for (size_t k = 0; k < n; ++k) {
    const double* pivot = A + k * n;
    if (!(pivot[k] > 0) || !std::isfinite(pivot[k])) return false;
    const double inverse = 1 / pivot[k];
    for (size_t i = k + 1; i < n; ++i) {
      const double l = pivot[i] * inverse;
      if (l == 0) continue;
      const auto rest = static_cast<Eigen::Index>(n - i);
      Eigen::Map<Eigen::VectorXd>(A + i * n + i, rest) -=
          l * Eigen::Map<const Eigen::VectorXd>(pivot + i, rest);
    }
  }
  return true;
}

/// Four sums at a time, of which no order depends on the compiler.
inline double dot(size_t n, const double* a, const double* b) noexcept {
  double s0 = 0, s1 = 0, s2 = 0, s3 = 0;
  size_t i = 0;
  for (; i + 4 <= n; i += 4)
    s0 += a[i] * b[i], s1 += a[i + 1] * b[i + 1], s2 += a[i + 2] * b[i + 2], s3 += a[i + 3] * b[i + 3];
  for (; i < n; ++i) s0 += a[i] * b[i];
  return (s0 + s1) + (s2 + s3);
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
  for (size_t k = 0; k < n; ++k) {
    const double* line = U + k * n;
    x[k] /= line[k];
    const auto rest = static_cast<Eigen::Index>(n - k - 1);
    Eigen::Map<Eigen::VectorXd>(x + k + 1, rest) -=
        x[k] * Eigen::Map<const Eigen::VectorXd>(line + k + 1, rest);
  }
}

/// x = U^-1 x, U in the upper half.
inline void solve_upper(size_t n, const double* U, double* x) noexcept {
  for (size_t k = n; k-- > 0;)
    x[k] = (x[k] - dot(n - k - 1, U + k * n + k + 1, x + k + 1)) / U[k * n + k];
}

}  // namespace swage::dynamics
