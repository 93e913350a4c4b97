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

/// W = L L^T of a symmetric positive semi-definite W (n x n, its diagonal overwritten) by pivoted Cholesky; L is n x rank, row-major
/// with stride n. Stops where the remainder is below 1e-14 of the largest diagonal entry: what is left out is
/// compliance a million times below that of a contact. Returns the rank. `order`: the rows in which the columns begin, rank.
inline size_t cholesky_semidefinite(size_t n, double* W, double* L, uint32_t* order = nullptr) noexcept {
  double largest = 0;
  for (size_t i = 0; i < n; ++i) largest = std::fmax(largest, W[i * n + i]);
  const double floor = 1e-14 * largest;
  // the diagonal of W becomes that of the remainder; the rest of it is only computed in the column that is next
  for (size_t rank = 0; rank < n; ++rank) {
    size_t pivot = n;
    double best = floor;
    for (size_t i = 0; i < n; ++i)
      if (W[i * n + i] > best) best = W[i * n + i], pivot = i;
    if (pivot == n) return rank;
    if (order) order[rank] = static_cast<uint32_t>(pivot);

    const double root = std::sqrt(best), inverse = 1 / root;
    const double* p = L + pivot * n;
    for (size_t i = 0; i < n; ++i) {
      if (i == pivot) continue;
      double rest = 0.5 * (W[i * n + pivot] + W[pivot * n + i]);
      for (size_t k = 0; k < rank; ++k) rest -= L[i * n + k] * p[k];
      L[i * n + rank] = rest * inverse;
      W[i * n + i] -= L[i * n + rank] * L[i * n + rank];
    }
    L[pivot * n + rank] = root;
    W[pivot * n + pivot] = 0;
  }
  return n;
}

}  // namespace swage::dynamics
