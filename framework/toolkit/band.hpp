// SPDX-License-Identifier: Apache-2.0
//
// A symmetric, positive definite band matrix, factored as L D L' without pivoting: about n B^2 operations, where a dense matrix
// takes n^3 / 3. Every sum has one order: the same bits at every level of optimisation and every width of registers (wide.hpp).
// Header-only.
//
// Threads: built on [main]; the rest [rt], nothing allocates.
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

#include "toolkit/wide.hpp"

namespace swage::toolkit {

/// n unknowns, of which i and j are coupled where |i - j| <= B; B is even.
template <int B>
class Band {
  static_assert((B + 2) % 4 == 0, "columns are padded to whole registers");

 public:
  /// Doubles from one column to the next: B + 1 entries and one zero.
  static constexpr size_t kStride = B + 2;

  Band() = default;
  explicit Band(int n) : n_(n), a_(static_cast<size_t>(n + B) * kStride, 0.0) {}

  int size() const { return n_; }
  void set_zero() { std::fill(a_.begin(), a_.end(), 0.0); }
  /// Sets what lies beyond the last unknown to zero again, after a factorisation that failed.
  void clear_beyond() { std::fill(a_.begin() + n_ * kColumn, a_.end(), 0.0); }

  /// The lower half: i >= j.
  double& at(int i, int j) { return column(j)[i - j]; }
  double at(int i, int j) const { return column(j)[i - j]; }
  double* column(int j) { return a_.data() + static_cast<size_t>(j) * kStride; }
  const double* column(int j) const { return a_.data() + static_cast<size_t>(j) * kStride; }

  /// y = A x, before it is factored.
  void multiply(const double* x, double* y) const {
    for (int i = 0; i < n_; ++i) {
      const double* a = column(i);
      constexpr Back back = 1 - kColumn;
      double sum = 0;
      if (i >= B && i + B < n_) {
#pragma GCC unroll 16
        for (int k = B; k >= 1; --k) sum += a[k * back] * x[i - k];
#pragma GCC unroll 16
        for (int k = 0; k <= B; ++k) sum += a[k] * x[i + k];
      } else {
        for (int k = std::min(B, i); k >= 1; --k) sum += a[k * back] * x[i - k];
        for (int k = 0; k <= B && i + k < n_; ++k) sum += a[k] * x[i + k];
      }
      y[i] = sum;
    }
  }

  /// Fixes unknown i: its row and column become those of the identity. `columns`: of the matrix, from the first on.
  void hold(int i) { hold(a_.data(), i); }
  static void hold(double* columns, int i) {
    double* own = columns + i * kColumn;
    for (int k = 1; k <= B; ++k) {
      own[k] = 0;
      if (i >= k) own[k - k * kColumn] = 0;
    }
    own[0] = 1;
  }

  /// Factors in place. False when a pivot is not above zero or not finite; the matrix is lost then.
  bool factor() {
    if constexpr (B == 10)
      if (has_fours()) return factor_by_fours(a_.data(), n_);
    return factor_by_twos();
  }
  bool factor_by_twos() {
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
  /// get alone. `first`: unknowns before it are 0 in all of them; `least`: results before it are not needed.
  template <int R = 1>
  void solve(double* x, int first = 0, int least = 0) const {
    if (R % 4 == 0 && has_fours())
      solve_by_fours<R>(a_.data(), n_, x, first, least);
    else
      solve_with<Narrow<R>, R, R>(a_.data(), n_, x, first, least);
  }
  /// The same for one right-hand side whose unknowns are in reverse order: unknown i is x[n - 1 - i].
  void solve_reversed(double* x, int first = 0) const { solve_with<Ones, 1, -1>(a_.data(), n_, x + n_ - 1, first, 0); }
  /// x' A^-1 x, of one right-hand side, in half the time: (L^-1 x)' D^-1 (L^-1 x). x is lost.
  double inverse_form(double* x, int first = 0) const { return inverse_form<1>(x, first); }
  double inverse_form_reversed(double* x, int first = 0) const { return inverse_form<-1>(x + n_ - 1, first); }

 private:
  using Back = std::ptrdiff_t;
  static constexpr Back kColumn = kStride;

  /// Subtracts l_k times column j, from its entry k on, from column j + k, for k = 1 .. B.
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

  /// Factors with the present column in registers, so that the next one need not wait for it.
  SWAGE_FOURS static bool factor_by_fours(double* a, int n) {
    Line<Fours, kStride> now;
    now.load(a);
    for (int j = 0; j < n; ++j, a += kStride) {
      const Four &x = now.part[0].x, &y = now.part[1].x, &z = now.part[2].x, none = {0, 0, 0, 0};
      const double pivot = x[0];
      if (!(pivot > 0) || !std::isfinite(pivot)) return false;
      const double inverse = 1 / pivot;
      Line<Fours, kStride> l = now, next;
      l.multiply(inverse), l.store(a);
      a[0] = inverse;
      // entries from the first, second, third .. on
      const Fours v1{__builtin_shufflevector(x, y, 1, 2, 3, 4)}, v2{__builtin_shufflevector(x, y, 2, 3, 4, 5)},
          v3{__builtin_shufflevector(x, y, 3, 4, 5, 6)}, v4{y}, v5{__builtin_shufflevector(y, z, 1, 2, 3, 4)},
          v6{__builtin_shufflevector(y, z, 2, 3, 4, 5)}, v7{__builtin_shufflevector(y, z, 3, 4, 5, 6)}, v8{z},
          v9{__builtin_shufflevector(z, none, 1, 2, 3, 4)}, v10{__builtin_shufflevector(z, none, 2, 3, 4, 5)};
      const Four& l0 = l.part[0].x;
      const Fours l1{__builtin_shufflevector(l0, l0, 1, 1, 1, 1)};
      next.load(a + kStride);
      next.part[0].x -= l1.x * v1.x, next.part[1].x -= l1.x * v5.x, next.part[2].x -= l1.x * v9.x;
      const auto take = [a](int k, int part, const Fours& v) __attribute__((always_inline)) {
        double* to = a + k * kColumn + 4 * part;
        Fours rest;
        rest.load(to);
        rest.x -= every<Fours>(a[k]).x * v.x;
        rest.store(to);
      };
      take(2, 0, v2), take(2, 1, v6), take(2, 2, v10), take(3, 0, v3), take(3, 1, v7);
      take(4, 0, v4), take(4, 1, v8), take(5, 0, v5), take(5, 1, v9), take(6, 0, v6), take(6, 1, v10);
      take(7, 0, v7), take(8, 0, v8), take(9, 0, v9), take(10, 0, v10);
      now = next;
    }
    return true;
  }

  // Substitution subtracts up to B neighbours from each unknown, in two sums, of the odd and of the even ones, the nearest last, as it is
  // the one computed just before
  template <int R>
  using Narrow = std::conditional_t<R % 2 == 0, Twos, Ones>;

  template <int R>
  SWAGE_FOURS static void solve_by_fours(const double* a, int n, double* x, int first, int least) {
    solve_with<std::conditional_t<R % 4 == 0, Fours, Narrow<R>>, R, R>(a, n, x, first, least);
  }
  template <Back kNext>
  double inverse_form(double* x, int first) const {
    forward<Ones, 1, kNext>(a_.data(), n_, x, first);
    double sum = 0;
    for (int j = first; j < n_; ++j) sum += x[j * kNext] * x[j * kNext] * column(j)[0];
    return sum;
  }
  /// kNext: from an unknown to the next.
  template <class V, int R, Back kNext>
  [[gnu::always_inline]] static void solve_with(const double* a, int n, double* x, int first, int least) {
    forward<V, R, kNext>(a, n, x, first);
    backward<V, R, kNext>(a, n, x, least);
  }
  template <class V, int R, Back kNext>
  [[gnu::always_inline]] static void forward(const double* a, int n, double* x, int first) {
    Line<V, R> near, next;  // the two unknowns computed last
    near.load(x + first * kNext), next = near;
    for (int j = first + 1; j < n; ++j) {
      double* at = x + j * kNext;
      Line<V, R> now;
      now.load(at);
      if (j == first + 1 && j >= 2) next.load(at - 2 * kNext);
      take<V, R>(a + static_cast<Back>(j) * kColumn, 1 - kColumn, -kNext, std::min(B, j), at, near, next, now);
      now.store(at);
      next = near, near = now;
    }
  }
  template <class V, int R, Back kNext>
  [[gnu::always_inline]] static void backward(const double* a, int n, double* x, int least) {
    Line<V, R> near = {}, next = {};
    for (int j = n - 1; j >= least; --j) {
      const double* l = a + static_cast<Back>(j) * kColumn;
      double* at = x + j * kNext;
      Line<V, R> now;
      now.load(at);
      now.multiply(l[0]);
      take<V, R>(l, 1, kNext, std::min(B, n - 1 - j), at, near, next, now);
      now.store(at);
      next = near, near = now;
    }
  }
  /// now -= the sum of l[k dl] x[k dx], k = 1 .. last, of which `near` and `next` are x[dx] and x[2 dx].
  template <class V, int R>
  [[gnu::always_inline]] static void take(const double* l, Back dl, Back dx, int last, const double* x, const Line<V, R>& near,
                                          const Line<V, R>& next, Line<V, R>& now) {
    if (last == B)
      take_whole<V, R>(l, dl, dx, x, near, next, now);
    else if (last >= 1)
      take_all<V, R>(l, dl, dx, last, x, near, next, now);
  }
  /// The same with last = B, written out: a loop costs more than what it does.
  template <class V, int R>
  [[gnu::always_inline]] static void take_whole(const double* l, Back dl, Back dx, const double* x, const Line<V, R>& near,
                                                const Line<V, R>& next, Line<V, R>& now) {
    Line<V, R> even = {};
#pragma GCC unroll 16
    for (int k = B; k >= 4; k -= 2) even.add(l[k * dl], x + k * dx);
#pragma GCC unroll 16
    for (int k = B - 1; k >= 3; k -= 2) now.take(l[k * dl], x + k * dx);
    even.add(l[2 * dl], next);
    now.take(even);
    now.take(l[dl], near);
  }
  template <class V, int R>
  [[gnu::always_inline]] static void take_all(const double* l, Back dl, Back dx, int last, const double* x,
                                              const Line<V, R>& near, const Line<V, R>& next, Line<V, R>& now) {
    Line<V, R> even = {};
    for (int k = last / 2 * 2; k >= 4; k -= 2) even.add(l[k * dl], x + k * dx);
    for (int k = (last - 1) / 2 * 2 + 1; k >= 3; k -= 2) now.take(l[k * dl], x + k * dx);
    if (last >= 2) even.add(l[2 * dl], next);
    now.take(even);
    now.take(l[dl], near);
  }

  int n_ = 0;
  std::vector<double>
      a_;  // column by column; B columns of zeros at the end pad what lies beyond the last unknown
};

}  // namespace swage::toolkit
