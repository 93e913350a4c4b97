// SPDX-License-Identifier: Apache-2.0
//
// Linear combinations of rows of a dense matrix, with the same bits at every width of registers (toolkit/wide.hpp). Header-only, [rt].
#pragma once

#include <cstddef>

#include "toolkit/wide.hpp"

namespace swage::dynamics::lines {

using toolkit::for_each;
using toolkit::Fours;
using toolkit::Ones;
using toolkit::Twos;

template <class V>
[[gnu::always_inline]] inline V times(double s, const double* x) {
  V every, at;
  every.fill(s), at.load(x);
  at.x = every.x * at.x;
  return at;
}

/// to -= s x.
template <class V>
[[gnu::always_inline]] inline void take(size_t n, double s, const double* x, double* to) {
  for_each<V>(n, [=](auto v, size_t i) __attribute__((always_inline)) {
    using W = decltype(v);
    v.load(to + i);
    v.x -= times<W>(s, x + i).x;
    v.store(to + i);
  });
}
/// to = (to - s x) - t y.
template <class V>
[[gnu::always_inline]] inline void take(size_t n, double s, const double* x, double t, const double* y, double* to) {
  for_each<V>(n, [=](auto v, size_t i) __attribute__((always_inline)) {
    using W = decltype(v);
    v.load(to + i);
    v.x = (v.x - times<W>(s, x + i).x) - times<W>(t, y + i).x;
    v.store(to + i);
  });
}
/// to = (((to - s0 x0) - s1 x1) - s2 x2) - s3 x3.
template <class V>
[[gnu::always_inline]] inline void take_four(size_t n, const double* s, const double* const* x, double* to) {
  for_each<V>(n, [=](auto v, size_t i) __attribute__((always_inline)) {
    using W = decltype(v);
    v.load(to + i);
    v.x = (((v.x - times<W>(s[0], x[0] + i).x) - times<W>(s[1], x[1] + i).x) - times<W>(s[2], x[2] + i).x) -
          times<W>(s[3], x[3] + i).x;
    v.store(to + i);
  });
}
/// to = (s0 x0 + s1 x1) + s2 x2 or, where kMore, to += that; the three rows are `stride` apart.
template <class V, bool kMore>
[[gnu::always_inline]] inline void combine_three(size_t n, const double* s, const double* x, size_t stride, double* to) {
  const double s0 = s[0], s1 = s[1], s2 = s[2];
  for_each<V>(n, [=](auto v, size_t i) __attribute__((always_inline)) {
    using W = decltype(v);
    const W sum{(times<W>(s0, x + i).x + times<W>(s1, x + stride + i).x) + times<W>(s2, x + 2 * stride + i).x};
    if constexpr (kMore) {
      v.load(to + i);
      v.x += sum.x;
      v.store(to + i);
    } else {
      sum.store(to + i);
    }
  });
}

SWAGE_FOURS inline void set_sum_by_fours(size_t n, const double* s, const double* x, size_t stride, double* to) noexcept {
  combine_three<Fours, false>(n, s, x, stride, to);
}
SWAGE_FOURS inline void add_sum_by_fours(size_t n, const double* s, const double* x, size_t stride, double* to) noexcept {
  combine_three<Fours, true>(n, s, x, stride, to);
}
inline void set_sum(size_t n, const double* s, const double* x, size_t stride, double* to) noexcept {
  toolkit::has_fours() ? set_sum_by_fours(n, s, x, stride, to) : combine_three<Twos, false>(n, s, x, stride, to);
}
inline void add_sum(size_t n, const double* s, const double* x, size_t stride, double* to) noexcept {
  toolkit::has_fours() ? add_sum_by_fours(n, s, x, stride, to) : combine_three<Twos, true>(n, s, x, stride, to);
}

}  // namespace swage::dynamics::lines
