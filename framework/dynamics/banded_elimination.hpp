// SPDX-License-Identifier: Apache-2.0
//
// Block operations of banded_blocks.cpp by registers of two or four doubles (toolkit/wide.hpp). Blocks are column-major; the order of
// operations on each number is the same at every width, and so are the bits. Header-only, [rt].
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "toolkit/wide.hpp"

namespace swage::dynamics {

/// One update of the elimination: the product of two blocks below the diagonal, of one column.
struct BlockUpdate {
  uint32_t to;    // block from which the product is subtracted
  uint16_t i, j;  // places of its factors in the column
};

/// The blocks of the matrix in memory, 16 numbers each.
struct BlockStore {
  double *diagonal, *lower, *upper;  // upper: transposed
  const uint32_t* row;               // row of each block below the diagonal, in elimination order
  const uint32_t* first;             // index of the first such block of each column, n + 1
  uint32_t n;
};

/// One column: its blocks below the diagonal and their products.
struct BlockColumn {
  uint32_t k = 0, first = 0, size = 0;
  const BlockUpdate *update = nullptr, *last_update = nullptr;
};

namespace elimination {

inline constexpr uint32_t kBlock = 16;

template <class V>
using Line = toolkit::Line<V, 4>;

template <class V>
[[gnu::always_inline]] inline void take_column(const Line<V>* l, const double* B, double* A) noexcept {
  Line<V> a;
  a.load(A);
  a.take(B[0], l[0]), a.take(B[4], l[1]), a.take(B[8], l[2]), a.take(B[12], l[3]);
  a.store(A);
}
/// A -= L B', column by column.
template <class V>
[[gnu::always_inline]] inline void take_product(const double* L, const double* B, double* A) noexcept {
  Line<V> l[4];
  l[0].load(L), l[1].load(L + 4), l[2].load(L + 8), l[3].load(L + 12);
  take_column<V>(l, B, A), take_column<V>(l, B + 1, A + 4), take_column<V>(l, B + 2, A + 8), take_column<V>(l, B + 3, A + 12);
}

/// X U = A, in place; U: the upper half of LU.
template <class V>
[[gnu::always_inline]] inline void divide_by_upper(const double* LU, double* A) noexcept {
  Line<V> a, b, c, d;
  a.load(A), b.load(A + 4), c.load(A + 8), d.load(A + 12);
  a.divide(LU[0]);
  b.take(LU[4], a), b.divide(LU[5]);
  c.take(LU[8], a), c.take(LU[9], b), c.divide(LU[10]);
  d.take(LU[12], a), d.take(LU[13], b), d.take(LU[14], c), d.divide(LU[15]);
  a.store(A), b.store(A + 4), c.store(A + 8), d.store(A + 12);
}

/// X L' = A, in place; L: the lower half of LU, its diagonal 1.
template <class V>
[[gnu::always_inline]] inline void divide_by_lower(const double* LU, double* A) noexcept {
  Line<V> a, b, c, d;
  a.load(A), b.load(A + 4), c.load(A + 8), d.load(A + 12);
  b.take(LU[1], a);
  c.take(LU[2], a), c.take(LU[6], b);
  d.take(LU[3], a), d.take(LU[7], b), d.take(LU[11], c);
  b.store(A + 4), c.store(A + 8), d.store(A + 12);
}

/// X D = A, D: the pivots of LU. A symmetric matrix must be factored from one half alone: the two halves of a block differ by rounding,
/// which elimination multiplies by the ratio of the coupling (a thread tied to a needle, 1e5 N/m) to the stiffness that is left after it
/// (the inertia of both, 1e-2 N/m), until the difference is the larger.
template <class V>
[[gnu::always_inline]] inline void divide_by_pivots(const double* LU, const double* A, double* X) noexcept {
  Line<V> a, b, c, d;
  a.load(A), b.load(A + 4), c.load(A + 8), d.load(A + 12);
  a.divide(LU[0]), b.divide(LU[5]), c.divide(LU[10]), d.divide(LU[15]);
  a.store(X), b.store(X + 4), c.store(X + 8), d.store(X + 12);
}

/// Eliminates a column with a factored diagonal block: lower <- A U^-1, upper (transposed) <- A L'^-1, then subtracts their products.
template <class V>
[[gnu::always_inline]] inline void column(const BlockStore& s, const BlockColumn& c, bool symmetric) noexcept {
  const double* LU = s.diagonal + kBlock * c.k;
  for (uint32_t e = c.first; e < c.first + c.size; ++e) {
    double *low = s.lower + kBlock * e, *row = s.upper + kBlock * e;
    if (symmetric) std::copy_n(low, kBlock, row);
    divide_by_lower<V>(LU, row);
    if (symmetric)
      divide_by_pivots<V>(LU, row, low);
    else
      divide_by_upper<V>(LU, low);
    take_product<V>(low, row, s.diagonal + kBlock * s.row[e]);
  }
  for (const BlockUpdate* u = c.update; u != c.last_update; ++u) {
    const size_t i = kBlock * (c.first + u->i), j = kBlock * (c.first + u->j), to = kBlock * size_t{u->to};
    take_product<V>(s.lower + i, s.upper + j, s.lower + to);
    // (j, i), transposed: U_i' (L_j)' = (L_j U_i)'
    if (!symmetric) take_product<V>(s.upper + i, s.lower + j, s.upper + to);
  }
}

/// Part of a substitution: columns `from` to `to`, of numbers y that begin with those of block `base`.
struct Part {
  uint32_t from = 0, to = 0, base = 0;
};

/// y <- L^-1 y.
template <class V>
[[gnu::always_inline]] inline void forward(const BlockStore& s, const Part& part, double* y) noexcept {
  for (uint32_t k = part.from; k < part.to; ++k) {
    double* yk = y + 4 * (k - part.base);
    const double* D = s.diagonal + kBlock * k;
    for (int r = 1; r < 4; ++r)
      for (int c = 0; c < r; ++c) yk[r] -= D[r + 4 * c] * yk[c];
    for (uint32_t e = s.first[k]; e < s.first[k + 1]; ++e) {
      double* at = y + 4 * (s.row[e] - part.base);
      const double* L = s.lower + kBlock * e;
      Line<V> to;
      to.load(at);
      to.take(yk[0], L), to.take(yk[1], L + 4), to.take(yk[2], L + 8), to.take(yk[3], L + 12);
      to.store(at);
    }
  }
}

/// y <- U^-1 y.
template <class V>
[[gnu::always_inline]] inline void backward(const BlockStore& s, const Part& part, double* y) noexcept {
  for (uint32_t k = part.to; k-- > part.from;) {
    double* yk = y + 4 * (k - part.base);
    const double* D = s.diagonal + kBlock * k;
    for (uint32_t e = s.first[k]; e < s.first[k + 1]; ++e)
      toolkit::take_transposed<V>(s.upper + kBlock * e, y + 4 * (s.row[e] - part.base), yk);
    for (int r = 4; r-- > 0;) {
      for (int c = r + 1; c < 4; ++c) yk[r] -= D[r + 4 * c] * yk[c];
      yk[r] /= D[5 * r];
    }
  }
}

/// X <- (L U)^-1 X, four vectors side by side: a line of four numbers to each unknown.
template <class V>
[[gnu::always_inline]] inline void solve_four(const BlockStore& s, const Part& part, double* X) noexcept {
  const auto at = [&](uint32_t k) { return X + kBlock * size_t{k - part.base}; };
  Line<V> x[4], of[4];
  for (uint32_t k = part.from; k < part.to; ++k) {
    const double* D = s.diagonal + kBlock * k;
    for (int r = 0; r < 4; ++r) {
      x[r].load(at(k) + 4 * r);
      for (int c = 0; c < r; ++c) x[r].take(D[r + 4 * c], x[c]);
      x[r].store(at(k) + 4 * r);
    }
    for (uint32_t e = s.first[k]; e < s.first[k + 1]; ++e) {
      const double* L = s.lower + kBlock * e;
      double* to = at(s.row[e]);
      for (int r = 0; r < 4; ++r) {
        of[r].load(to + 4 * r);
        for (int c = 0; c < 4; ++c) of[r].take(L[r + 4 * c], x[c]);
        of[r].store(to + 4 * r);
      }
    }
  }
  for (uint32_t k = part.to; k-- > part.from;) {
    const double* D = s.diagonal + kBlock * k;
    for (int r = 0; r < 4; ++r) x[r].load(at(k) + 4 * r);
    for (uint32_t e = s.first[k]; e < s.first[k + 1]; ++e) {
      const double* U = s.upper + kBlock * e;
      for (int r = 0; r < 4; ++r) of[r].load(at(s.row[e]) + 4 * r);
      for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) x[c].take(U[r + 4 * c], of[r]);
    }
    for (int r = 4; r-- > 0;) {
      for (int c = r + 1; c < 4; ++c) x[r].take(D[r + 4 * c], x[c]);
      x[r].divide(D[5 * r]);
      x[r].store(at(k) + 4 * r);
    }
  }
}

/// y <- y - S x, S symmetric, given by its diagonal and the blocks below; both vectors begin with block `base`.
template <class V>
[[gnu::always_inline]] inline void take_symmetric(const BlockStore& s, const Part& part, const double* x, double* y) noexcept {
  const auto take = [](const double* M, const double* of, double* at) __attribute__((always_inline)) {
    Line<V> to;
    to.load(at);
    to.take(of[0], M), to.take(of[1], M + 4), to.take(of[2], M + 8), to.take(of[3], M + 12);
    to.store(at);
  };
  for (uint32_t k = part.from; k < part.to; ++k) {
    const double* xk = x + 4 * (k - part.base);
    double* yk = y + 4 * (k - part.base);
    take(s.diagonal + kBlock * k, xk, yk);
    for (uint32_t e = s.first[k]; e < s.first[k + 1]; ++e) {
      const size_t i = 4 * size_t{s.row[e] - part.base};
      take(s.lower + kBlock * e, xk, y + i);
      toolkit::take_transposed<V>(s.lower + kBlock * e, x + i, yk);
    }
  }
}

}  // namespace elimination

using elimination::Part;

SWAGE_FOURS inline void forward_by_fours(const BlockStore& s, const Part& part, double* y) noexcept {
  elimination::forward<toolkit::Fours>(s, part, y);
}
inline void forward_by_twos(const BlockStore& s, const Part& part, double* y) noexcept { elimination::forward<toolkit::Twos>(s, part, y); }

SWAGE_FOURS inline void backward_by_fours(const BlockStore& s, const Part& part, double* y) noexcept {
  elimination::backward<toolkit::Fours>(s, part, y);
}
inline void backward_by_twos(const BlockStore& s, const Part& part, double* y) noexcept { elimination::backward<toolkit::Twos>(s, part, y); }

SWAGE_FOURS inline void solve_four_by_fours(const BlockStore& s, const Part& part, double* X) noexcept {
  elimination::solve_four<toolkit::Fours>(s, part, X);
}
inline void solve_four_by_twos(const BlockStore& s, const Part& part, double* X) noexcept {
  elimination::solve_four<toolkit::Twos>(s, part, X);
}

SWAGE_FOURS inline void take_symmetric_by_fours(const BlockStore& s, const Part& part, const double* x, double* y) noexcept {
  elimination::take_symmetric<toolkit::Fours>(s, part, x, y);
}
inline void take_symmetric_by_twos(const BlockStore& s, const Part& part, const double* x, double* y) noexcept {
  elimination::take_symmetric<toolkit::Twos>(s, part, x, y);
}

SWAGE_FOURS inline void eliminate_by_fours(const BlockStore& s, const BlockColumn& c, bool symmetric) noexcept {
  elimination::column<toolkit::Fours>(s, c, symmetric);
}
inline void eliminate_by_twos(const BlockStore& s, const BlockColumn& c, bool symmetric) noexcept {
  elimination::column<toolkit::Twos>(s, c, symmetric);
}

}  // namespace swage::dynamics
