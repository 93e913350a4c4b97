// SPDX-License-Identifier: Apache-2.0
//
// A symmetric, positive definite band matrix, factored as L D L' without pivoting: about n B^2 operations, where a dense matrix
// takes n^3 / 3. Columns are updated by vectors of fixed length, so every sum has one order: the same bits at every level of
// optimisation (no contraction, no reductions). Header-only.
//
// Threads: built on [main]; the rest [rt], nothing allocates.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace swage::toolkit {

/// n unknowns, of which i and j are coupled where |i - j| <= B; B is even.
template <int B>
class Band {
  static_assert(B % 2 == 0, "columns are padded to an even length");

 public:
  /// Doubles from one column to the next: B + 1 entries and one zero, so that vectors of two doubles never leave the column.
  static constexpr size_t kStride = B + 2;

  Band() = default;
  explicit Band(int n) : n_(n), a_(static_cast<size_t>(n + B) * kStride, 0.0) {}

  int size() const { return n_; }
  void set_zero() { std::fill(a_.begin(), a_.end(), 0.0); }

  /// The lower half: i >= j.
  double& at(int i, int j) { return column(j)[i - j]; }
  double at(int i, int j) const { return column(j)[i - j]; }
  double* column(int j) { return a_.data() + static_cast<size_t>(j) * kStride; }
  const double* column(int j) const { return a_.data() + static_cast<size_t>(j) * kStride; }

  /// y = A x, before it is factored.
  void multiply(const double* x, double* y) const {
    for (int i = 0; i < n_; ++i) y[i] = 0;
    for (int j = 0; j < n_; ++j) {
      const double* a = column(j);
      y[j] += a[0] * x[j];
      for (int k = 1; k <= B && j + k < n_; ++k) y[j + k] += a[k] * x[j], y[j] += a[k] * x[j + k];
    }
  }

  /// Unknown i stays where it is: its row and column become those of 1.
  void hold(int i) {
    for (int k = 1; k <= B; ++k) {
      column(i)[k] = 0;
      if (i >= k) column(i - k)[k] = 0;
    }
    column(i)[0] = 1;
  }

  /// Factors in place. False when a pivot is not above zero or not finite; the matrix is lost then.
  bool factor() {
    for (int j = 0; j < n_; ++j) {
      double* a = column(j);
      const double pivot = a[0];
      if (!(pivot > 0) || !std::isfinite(pivot)) return false;
      const double inverse = 1 / pivot;
      update(a, inverse, std::make_integer_sequence<int, B>{});
      for (int k = 1; k <= B; ++k) a[k] *= inverse;
      a[0] = inverse;
    }
    return true;
  }

  /// x = A^-1 x for R right-hand sides at once, side by side: unknown i of side r is x[i R + r]. Each gets the bits that it would
  /// get alone. `first`: unknowns before it are 0 in all of them; `least`: those before it are not wanted.
  template <int R = 1>
  void solve(double* x, int first = 0, int least = 0) const {
    forward<R>(x, first);
    backward<R>(x, least);
  }

 private:
  /// Column j + k, for k = 1 .. B, less l_k times column j from its entry k on.
  template <int... K>
  void update(double* a, double inverse, std::integer_sequence<int, K...>) {
    (update_column<K + 1>(a, inverse), ...);
  }
  template <int K>
  static void update_column(double* a, double inverse) {
    constexpr int length = (B + 2 - K) / 2 * 2;  // with the zero at the end where that makes it even
    using Part = Eigen::Matrix<double, length, 1>;
    const double l = a[K] * inverse;
    Eigen::Map<Part> to(a + static_cast<size_t>(K) * kStride);
    to -= l * Eigen::Map<const Part>(a + K);
  }
  // Each unknown less its share of up to B others: in two sums, of the odd and of the even neighbours, the nearest last, as it is
  // the one that has just been found.
  template <int R>
  void forward(double* x, int first) const {
    for (int j = first + 1; j < n_; ++j)
      subtract<R>(column(j), 1 - static_cast<std::ptrdiff_t>(kStride), -R, std::min(B, j),
                  x + static_cast<std::ptrdiff_t>(j) * R);
  }
  template <int R>
  void backward(double* x, int least) const {
    using Line = Eigen::Matrix<double, R, 1>;
    for (int j = n_ - 1; j >= least; --j) {
      double* xj = x + static_cast<std::ptrdiff_t>(j) * R;
      Eigen::Map<Line> at_j(xj);
      at_j *= column(j)[0];
      subtract<R>(column(j), 1, R, std::min(B, n_ - 1 - j), xj);
    }
  }
  /// x0 less the sum of l[k dl] x[k dx], k = 1 .. last.
  template <int R>
  static void subtract(const double* l, std::ptrdiff_t dl, std::ptrdiff_t dx, int last, double* x) {
    if (last == B)
      subtract_all<R>(l, dl, dx, B, x);  // of a length that the compiler knows
    else
      subtract_all<R>(l, dl, dx, last, x);
  }
  template <int R>
  [[gnu::always_inline]] static void subtract_all(const double* l, std::ptrdiff_t dl, std::ptrdiff_t dx,
                                                  int last, double* x) {
    using Line = Eigen::Matrix<double, R, 1>;
    if (last < 1) return;
    Eigen::Map<Line> x0(x);
    Line odd = x0, even = Line::Zero();
    for (int k = last / 2 * 2; k >= 2; k -= 2) even += l[k * dl] * Eigen::Map<const Line>(x + k * dx);
    for (int k = (last - 1) / 2 * 2 + 1; k >= 3; k -= 2)
      odd -= l[k * dl] * Eigen::Map<const Line>(x + k * dx);
    x0 = (odd - even) - l[dl] * Eigen::Map<const Line>(x + dx);
  }

  int n_ = 0;
  std::vector<double>
      a_;  // column by column; B columns of zeros at the end take what is beyond the last unknown
};

}  // namespace swage::toolkit
