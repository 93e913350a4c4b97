// SPDX-License-Identifier: Apache-2.0
//
// The derivatives of a rod's joints and edges, added up four nodes at a time. A node has parts of the joint before it, of its own and of the
// joint after it, and of the two edges beside it; they are summed in that order, so that each entry has the bits of a sum joint by joint.
// Columns are written whole: the matrix need not be zero before. Header-only, pure, [rt].
#pragma once

#include "toolkit/rod_joint.hpp"

namespace swage::toolkit {

/// Numbers of eight neighbours along the rod.
struct Eight {
  static constexpr int n = 8, group = 4;
  double x[n];

  [[gnu::always_inline]] void shift() {
    for (int i = 0; i < group; ++i) x[i] = x[i + group];
  }
};

/// Stores numbers of V::n nodes; those of a node side by side, four at a time, and from one node to the next `apart` doubles.
[[gnu::always_inline]] inline void store_fours(Fours a, Fours b, Fours c, Fours d, double* to, std::ptrdiff_t apart) {
  const Four ab = __builtin_shufflevector(a.x, b.x, 0, 4, 2, 6), cd = __builtin_shufflevector(c.x, d.x, 0, 4, 2, 6),
             ba = __builtin_shufflevector(a.x, b.x, 1, 5, 3, 7), dc = __builtin_shufflevector(c.x, d.x, 1, 5, 3, 7);
  Fours{__builtin_shufflevector(ab, cd, 0, 1, 4, 5)}.store(to), Fours{__builtin_shufflevector(ba, dc, 0, 1, 4, 5)}.store(to + apart);
  Fours{__builtin_shufflevector(ab, cd, 2, 3, 6, 7)}.store(to + 2 * apart), Fours{__builtin_shufflevector(ba, dc, 2, 3, 6, 7)}.store(to + 3 * apart);
}
[[gnu::always_inline]] inline void store_fours(Twos a, Twos b, Twos c, Twos d, double* to, std::ptrdiff_t apart) {
  Twos{__builtin_shufflevector(a.x, b.x, 0, 2)}.store(to), Twos{__builtin_shufflevector(c.x, d.x, 0, 2)}.store(to + 2);
  Twos{__builtin_shufflevector(a.x, b.x, 1, 3)}.store(to + apart), Twos{__builtin_shufflevector(c.x, d.x, 1, 3)}.store(to + apart + 2);
}
[[gnu::always_inline]] inline void store_fours(Ones a, Ones b, Ones c, Ones d, double* to, std::ptrdiff_t) {
  to[0] = a.x, to[1] = b.x, to[2] = c.x, to[3] = d.x;
}

/// Force of a stretched edge on its nodes, and its stiffness.
template <class V>
struct EdgeDerivatives {
  static constexpr int kNumbers = 12, kOfGradient = 3;
  Three<V> f;         // N, on the node before it
  Three<Three<V>> K;  // N/m, its columns

  /// t: direction; inverse [1/m] of its length; L: rest length [m]; k [N/m]; tension [N], that of the linear model.
  [[gnu::always_inline]] void differentiate(const Three<V>& t, V inverse, V L, V k, V tension, bool second) {
    f = (k * (1.0 / inverse - L)) * t;
    if (!second) return;
    const V side = tension * inverse;
    const Three<V> along = (k - side) * t;
    K = {along.x * t, along.y * t, along.z * t};
    K.x.x = K.x.x + side, K.y.y = K.y.y + side, K.z.z = K.z.z + side;
  }
};

/// Joints 4 g - 4 to 4 g + 3 and the edges of the same numbers, from which the nodes 4 g - 3 to 4 g follow. Zeros stand for what is not there.
struct RodAssembly {
  JointDerivatives<Eight> joint;
  EdgeDerivatives<Eight> edge;

  /// Numbers of one joint or edge in use: with the second derivatives, or without.
  template <class Of>
  [[gnu::always_inline]] static int numbers(bool second) {
    return second ? Of::kNumbers : Of::kOfGradient;
  }
  /// Nothing is there.
  void clear() { joint = {}, edge = {}; }
  /// Moves on by four.
  [[gnu::always_inline]] void shift(bool second) {
    shift(joint, second), shift(edge, second);
  }
  /// Sets the numbers of V::n joints or edges, the first at place 4 + `at`.
  template <class V, template <class> class Of>
  [[gnu::always_inline]] static void set(const Of<V>& from, int at, bool second, Of<Eight>& to) {
    const V* number = reinterpret_cast<const V*>(&from);
    Eight* into = reinterpret_cast<Eight*>(&to);
    for (int k = 0; k < numbers<Of<V>>(second); ++k) number[k].store(into[k].x + Eight::group + at);
  }

  /// Gradient at V::n nodes, the first at place 1 + `at`: of displacements and, in w, of the rotation of the edge that begins there.
  template <class V>
  [[gnu::always_inline]] void gradient(int at, Three<V>& x, V& w) const {
    const auto row = [&](int r) __attribute__((always_inline)) {
      V sum = every<V>(0) + get<V>(joint.f[r], at);
      sum = sum + get<V>(edge.f[r], at);
      sum = sum + (get<V>(joint.e[r], at + 1) - get<V>(joint.f[r], at + 1));
      sum = sum - get<V>(edge.f[r], at + 1);
      return sum - get<V>(joint.e[r], at + 2);
    };
    x = {row(0), row(1), row(2)};
    w = (every<V>(0) + get<V>(joint.tf, at + 1)) + get<V>(joint.te, at + 2);
  }

  /// The four columns of each of V::n nodes, the first at place 1 + `at`, into columns of `stride` numbers (12, of which the last is 0).
  template <class V>
  [[gnu::always_inline]] void columns(int at, double* to, std::ptrdiff_t stride) const {
    const V zero = every<V>(0);
    column_of<V, 0>(at, to, stride), column_of<V, 1>(at, to, stride), column_of<V, 2>(at, to, stride);
    const auto f_tf = [&](int r) __attribute__((always_inline)) {
      return ((zero + get<V>(joint.f_tf[r], at + 1)) + (get<V>(joint.e_te[r], at + 2) - get<V>(joint.f_te[r], at + 2)));
    };
    const auto f_te = [&](int r) __attribute__((always_inline)) { return zero + get<V>(joint.f_te[r], at + 2); };
    double* turn = to + 3 * stride;
    store_fours((zero + get<V>(joint.tf_tf, at + 1)) + get<V>(joint.te_te, at + 2), f_tf(0), f_tf(1), f_tf(2), turn, 4 * stride);
    store_fours(zero + get<V>(joint.te_tf, at + 2), f_te(0), f_te(1), f_te(2), turn + 4, 4 * stride);
    store_fours(zero, zero, zero, zero, turn + 8, 4 * stride);
  }

 private:
  template <class Of>
  [[gnu::always_inline]] static void shift(Of& of, bool second) {
    for (int k = 0; k < numbers<Of>(second); ++k) reinterpret_cast<Eight*>(&of)[k].shift();
  }
  template <class V>
  [[gnu::always_inline]] static V get(const Eight& from, int at) {
    V v;
    v.load(from.x + at);
    return v;
  }

  /// Column of the displacement c: entries with the node itself, its rotation, the next node, its rotation, and the node after that.
  template <class V, int c>
  [[gnu::always_inline]] void column_of(int at, double* to, std::ptrdiff_t stride) const {
    const V zero = every<V>(0);
    const auto own = [&](int r) __attribute__((always_inline)) {
      V sum = zero + get<V>(joint.ff[c][r], at);
      sum = sum + get<V>(edge.K[c][r], at);
      sum = sum + ((get<V>(joint.ee[c][r], at + 1) + get<V>(joint.ff[c][r], at + 1)) -
                   (get<V>(joint.ef[c][r], at + 1) + get<V>(joint.ef[r][c], at + 1)));
      sum = sum + get<V>(edge.K[c][r], at + 1);
      return sum + get<V>(joint.ee[c][r], at + 2);
    };
    const auto next = [&](int r) __attribute__((always_inline)) {
      V sum = zero + (get<V>(joint.ef[r][c], at + 1) - get<V>(joint.ff[c][r], at + 1));
      sum = sum - get<V>(edge.K[c][r], at + 1);
      return sum + (get<V>(joint.ef[r][c], at + 2) - get<V>(joint.ee[c][r], at + 2));
    };
    const auto after = [&](int r) __attribute__((always_inline)) { return zero - get<V>(joint.ef[r][c], at + 2); };
    const V turn = (zero + (get<V>(joint.e_tf[c], at + 1) - get<V>(joint.f_tf[c], at + 1))) - get<V>(joint.e_te[c], at + 2);
    const V turn_next = zero - get<V>(joint.e_tf[c], at + 2);
    double* h = to + c * stride;
    const std::ptrdiff_t apart = 4 * stride;
    if constexpr (c == 0) {
      store_fours(own(0), own(1), own(2), turn, h, apart);
      store_fours(next(0), next(1), next(2), turn_next, h + 4, apart);
      store_fours(after(0), after(1), after(2), zero, h + 8, apart);
    } else if constexpr (c == 1) {
      store_fours(own(1), own(2), turn, next(0), h, apart);
      store_fours(next(1), next(2), turn_next, after(0), h + 4, apart);
      store_fours(after(1), after(2), zero, zero, h + 8, apart);
    } else {
      store_fours(own(2), turn, next(0), next(1), h, apart);
      store_fours(next(2), turn_next, after(0), after(1), h + 4, apart);
      store_fours(after(2), zero, zero, zero, h + 8, apart);
    }
  }
};

}  // namespace swage::toolkit
