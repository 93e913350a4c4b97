// SPDX-License-Identifier: Apache-2.0
//
// Several numbers in a register: two, which every supported machine has, or four where it can. Sums, differences, products and
// quotients are those of each number alone, in the order in which they are written, so that the bits do not depend on the width. No
// products are contracted with sums. Header-only.
//
//   template <class V> [[gnu::always_inline]] inline void work(...)          what is done, by Twos or by Fours
//   SWAGE_FOURS inline void work_by_fours(...) { work<Fours>(...); }        compiled for machines that have them
//   has_fours() ? work_by_fours(...) : work<Twos>(...)
#pragma once

#include <cmath>
#include <concepts>
#include <cstddef>
#if defined(__x86_64__)
#include <emmintrin.h>
#endif

namespace swage::toolkit {

typedef double Two __attribute__((vector_size(16), aligned(8), may_alias));
typedef double Four __attribute__((vector_size(32), aligned(8), may_alias));

#if defined(__x86_64__)
#define SWAGE_FOURS [[gnu::target("avx2")]]
/// Whether the machine has registers of four.
inline bool has_fours() noexcept {
  static const bool has = __builtin_cpu_supports("avx2") != 0;
  return has;
}
#else
#define SWAGE_FOURS
inline bool has_fours() noexcept { return false; }
#endif

/// Takes both square roots.
[[gnu::always_inline]] inline void take_root(Two& x) {
#if defined(__x86_64__)
  x = reinterpret_cast<const Two&>(static_cast<const __m128d&>(_mm_sqrt_pd(reinterpret_cast<const __m128d&>(x))));
#else
  x = Two{std::sqrt(x[0]), std::sqrt(x[1])};
#endif
}

/// A register of two numbers.
struct Twos {
  static constexpr int n = 2;
  Two x;

  [[gnu::always_inline]] void load(const double* from) { x = *reinterpret_cast<const Two*>(from); }
  [[gnu::always_inline]] void store(double* to) const { *reinterpret_cast<Two*>(to) = x; }
  [[gnu::always_inline]] void fill(double s) { x = Two{s, s}; }
  /// Loads and stores numbers that are `apart` doubles from each other.
  [[gnu::always_inline]] void load(const double* from, std::ptrdiff_t apart) { x = Two{from[0], from[apart]}; }
  [[gnu::always_inline]] void store(double* to, std::ptrdiff_t apart) const { to[0] = x[0], to[apart] = x[1]; }
  [[gnu::always_inline]] void root() { take_root(x); }
};
struct Fours {
  static constexpr int n = 4;
  Four x;

  [[gnu::always_inline]] void load(const double* from) { x = *reinterpret_cast<const Four*>(from); }
  [[gnu::always_inline]] void store(double* to) const { *reinterpret_cast<Four*>(to) = x; }
  [[gnu::always_inline]] void fill(double s) { x = Four{s, s, s, s}; }
  [[gnu::always_inline]] void load(const double* from, std::ptrdiff_t apart) {
    x = Four{from[0], from[apart], from[2 * apart], from[3 * apart]};
  }
  [[gnu::always_inline]] void store(double* to, std::ptrdiff_t apart) const {
    to[0] = x[0], to[apart] = x[1], to[2 * apart] = x[2], to[3 * apart] = x[3];
  }
  [[gnu::always_inline]] void root() {
    Two low = __builtin_shufflevector(x, x, 0, 1), high = __builtin_shufflevector(x, x, 2, 3);
    take_root(low), take_root(high);
    x = __builtin_shufflevector(low, high, 0, 1, 2, 3);
  }
};
struct Ones {
  static constexpr int n = 1;
  double x;

  [[gnu::always_inline]] void load(const double* from) { x = *from; }
  [[gnu::always_inline]] void store(double* to) const { *to = x; }
  [[gnu::always_inline]] void fill(double s) { x = s; }
  [[gnu::always_inline]] void load(const double* from, std::ptrdiff_t) { x = *from; }
  [[gnu::always_inline]] void store(double* to, std::ptrdiff_t) const { *to = x; }
  [[gnu::always_inline]] void root() { x = std::sqrt(x); }
};

template <class V>
concept Register = std::same_as<V, Ones> || std::same_as<V, Twos> || std::same_as<V, Fours>;

template <Register V>
[[gnu::always_inline]] inline V operator+(V a, V b) {
  return {a.x + b.x};
}
template <Register V>
[[gnu::always_inline]] inline V operator-(V a, V b) {
  return {a.x - b.x};
}
template <Register V>
[[gnu::always_inline]] inline V operator*(V a, V b) {
  return {a.x * b.x};
}
template <Register V>
[[gnu::always_inline]] inline V operator/(V a, V b) {
  return {a.x / b.x};
}
template <Register V>
[[gnu::always_inline]] inline V operator-(V a) {
  return {-a.x};
}
template <class V>
[[gnu::always_inline]] inline V every(double s) {
  V v;
  v.fill(s);
  return v;
}

/// Element by element, the number in every place of the register.
template <Register V>
[[gnu::always_inline]] inline V operator*(double s, V a) {
  return every<V>(s) * a;
}
template <Register V>
[[gnu::always_inline]] inline V operator+(double s, V a) {
  return every<V>(s) + a;
}
template <Register V>
[[gnu::always_inline]] inline V operator/(double s, V a) {
  return every<V>(s) / a;
}

/// Calls `each` with registers that begin at 0, V::n, 2 V::n .., then for the remaining numbers one at a time.
template <class V, class Each>
[[gnu::always_inline]] inline void for_each(size_t n, const Each& each) {
  size_t i = 0;
  for (; i + V::n <= n; i += V::n) each(V{}, i);
  for (; i < n; ++i) each(Ones{}, i);
}

/// N numbers side by side, in registers V.
template <class V, int N>
struct Line {
  static constexpr int parts = N / V::n;
  static_assert(parts * V::n == N);
  V part[parts];

  [[gnu::always_inline]] void load(const double* from) {
    for (int i = 0; i < parts; ++i) part[i].load(from + V::n * i);
  }
  [[gnu::always_inline]] void store(double* to) const {
    for (int i = 0; i < parts; ++i) part[i].store(to + V::n * i);
  }
  [[gnu::always_inline]] void fill(double s) {
    for (int i = 0; i < parts; ++i) part[i].fill(s);
  }
  /// Adds s times the numbers at `from`, or s times another line.
  [[gnu::always_inline]] void add(double s, const double* from) {
    V every, p;
    every.fill(s);
    for (int i = 0; i < parts; ++i) p.load(from + V::n * i), part[i].x += every.x * p.x;
  }
  [[gnu::always_inline]] void add(double s, const Line& other) {
    V every;
    every.fill(s);
    for (int i = 0; i < parts; ++i) part[i].x += every.x * other.part[i].x;
  }
  /// Subtracts s times the numbers at `from`; only the first `count` registers where it is given.
  [[gnu::always_inline]] void take(double s, const double* from, int count = parts) {
    V every, p;
    every.fill(s);
    for (int i = 0; i < count; ++i) p.load(from + V::n * i), part[i].x -= every.x * p.x;
  }
  [[gnu::always_inline]] void take(double s, const Line& other) {
    V every;
    every.fill(s);
    for (int i = 0; i < parts; ++i) part[i].x -= every.x * other.part[i].x;
  }
  [[gnu::always_inline]] void add(const Line& other) {
    for (int i = 0; i < parts; ++i) part[i].x += other.part[i].x;
  }
  [[gnu::always_inline]] void take(const Line& other) {
    for (int i = 0; i < parts; ++i) part[i].x -= other.part[i].x;
  }
  [[gnu::always_inline]] void multiply(double s) {
    V every;
    every.fill(s);
    for (int i = 0; i < parts; ++i) part[i].x *= every.x;
  }
  [[gnu::always_inline]] void divide(double s) {
    V every;
    every.fill(s);
    for (int i = 0; i < parts; ++i) part[i].x /= every.x;
  }
};

/// y -= L' x: of each of four columns its product with x, the halves of which are summed first.
template <class V>
[[gnu::always_inline]] inline void take_transposed(const double* L, const double* x, double* y) {
  if constexpr (V::n == 4) {
    const Four at = *reinterpret_cast<const Four*>(x), p = *reinterpret_cast<const Four*>(L) * at,
               q = *reinterpret_cast<const Four*>(L + 4) * at, r = *reinterpret_cast<const Four*>(L + 8) * at,
               s = *reinterpret_cast<const Four*>(L + 12) * at;
    // neighbours of two columns each: the first halves in the places 0 and 1, the second in 2 and 3
    const Four a = __builtin_shufflevector(p, q, 0, 4, 2, 6) + __builtin_shufflevector(p, q, 1, 5, 3, 7);
    const Four b = __builtin_shufflevector(r, s, 0, 4, 2, 6) + __builtin_shufflevector(r, s, 1, 5, 3, 7);
    *reinterpret_cast<Four*>(y) -= __builtin_shufflevector(a, b, 0, 1, 4, 5) + __builtin_shufflevector(a, b, 2, 3, 6, 7);
  } else {
    for (int k = 0; k < 4; ++k) {
      const double* l = L + 4 * k;
      y[k] -= (l[0] * x[0] + l[1] * x[1]) + (l[2] * x[2] + l[3] * x[3]);
    }
  }
}

}  // namespace swage::toolkit
