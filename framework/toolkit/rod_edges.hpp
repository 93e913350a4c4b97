// SPDX-License-Identifier: Apache-2.0
//
// The edges of a rod, several at a time (wide.hpp): their directions, and the transport of directors with them. Each edge gets the
// bits that it would get alone. Header-only; the buffers are made on [main], the rest is [rt].
#pragma once

#include <cstring>
#include <limits>
#include <vector>

#include "toolkit/math.hpp"
#include "toolkit/three.hpp"

namespace swage::toolkit {

/// Unit vectors along edges, their lengths [m] and the inverse of these.
class RodEdges {
 public:
  RodEdges() = default;
  explicit RodEdges(size_t edges) : n_(edges) {
    for (std::vector<double>* v : {&x_, &y_, &z_, &length_, &inverse_}) v->resize(edges);
    nodes_.assign(3 * (edges + 1), std::numeric_limits<double>::quiet_NaN());
  }

  /// Computes the edges between nodes, 3 numbers each; those of the nodes of the last call are there.
  void find(const double* nodes) {
    const size_t bytes = nodes_.size() * sizeof(double);
    if (bytes == 0 || std::memcmp(nodes_.data(), nodes, bytes) == 0) return;
    std::memcpy(nodes_.data(), nodes, bytes);
    has_fours() ? find_by_fours(nodes) : find_with<Twos>(nodes);
  }
  Vec3 t(size_t j) const { return {x_[j], y_[j], z_[j]}; }
  /// Unit tangents of the edges from j on.
  template <class V>
  [[gnu::always_inline]] Three<V> t(V v, size_t j) const {
    Three<V> t{v, v, v};
    t.x.load(&x_[j]), t.y.load(&y_[j]), t.z.load(&z_[j]);
    return t;
  }
  template <class V>
  [[gnu::always_inline]] V inverse(V v, size_t j) const {
    v.load(&inverse_[j]);
    return v;
  }
  double length(size_t j) const { return length_[j]; }
  double inverse(size_t j) const { return inverse_[j]; }

  /// Parallel transport of the directors (3 numbers an edge) from these edges to those of `to`. The results are normal to their edge and
  /// of length 1, so that repeated transport adds no error.
  void carry(const RodEdges& to, const double* director, double* carried) const {
    has_fours() ? carry_by_fours(to, director, carried) : carry_with<Twos>(to, director, carried);
  }
  /// From each edge but the last to the next: sine and cosine of the angle from its transported director to that of the next, both times
  /// the same factor.
  void twists(const double* director, double* sine, double* cosine) const {
    has_fours() ? twists_by_fours(director, sine, cosine) : twists_with<Twos>(director, sine, cosine);
  }
  /// From each edge but the last to the next: 2 tan of half the angle.
  void bends(double* bend) const { has_fours() ? bends_by_fours(bend) : bends_with<Twos>(bend); }

 private:
  template <class V>
  [[gnu::always_inline]] static Three<V> transported(const Three<V>& director, const Three<V>& from, const Three<V>& to) {
    const Three<V> axis = from.cross(to);
    const V c = from.dot(to), along = axis.dot(director) / (every<V>(1) + c);
    return (c * director + axis.cross(director)) + along * axis;
  }

  template <class V>
  [[gnu::always_inline]] void find_with(const double* nodes) {
    for_each<V>(n_, [=, this](auto v, size_t j) __attribute__((always_inline)) {
      const double* x = nodes + 3 * j;
      const auto e = vectors(v, x + 3) - vectors(v, x);
      const auto length = e.norm(), inverse = every<decltype(v)>(1) / length;
      const auto t = inverse * e;
      length.store(&length_[j]);
      t.x.store(&x_[j]), t.y.store(&y_[j]), t.z.store(&z_[j]), inverse.store(&inverse_[j]);
    });
  }
  template <class V>
  [[gnu::always_inline]] void carry_with(const RodEdges& to, const double* director, double* carried) const {
    for_each<V>(n_, [=, this, &to](auto v, size_t j) __attribute__((always_inline)) {
      const auto t = to.t(v, j);
      auto d = transported(vectors(v, director + 3 * j), this->t(v, j), t);
      d = d - d.dot(t) * t;
      d = (every<decltype(v)>(1) / d.norm()) * d;
      double* out = carried + 3 * j;
      d.x.store(out, 3), d.y.store(out + 1, 3), d.z.store(out + 2, 3);
    });
  }
  template <class V>
  [[gnu::always_inline]] void twists_with(const double* director, double* sine, double* cosine) const {
    for_each<V>(n_ - 1, [=, this](auto v, size_t j) __attribute__((always_inline)) {
      const auto t = this->t(v, j + 1), next = vectors(v, director + 3 * j + 3);
      const auto d = transported(vectors(v, director + 3 * j), this->t(v, j), t);
      t.dot(d.cross(next)).store(sine + j), d.dot(next).store(cosine + j);
    });
  }
  template <class V>
  [[gnu::always_inline]] void bends_with(double* bend) const {
    for_each<V>(n_ - 1, [=, this](auto v, size_t j) __attribute__((always_inline)) {
      const auto e = this->t(v, j), f = this->t(v, j + 1);
      ((2.0 / (1.0 + e.dot(f))) * e.cross(f)).norm().store(bend + j);
    });
  }
  SWAGE_FOURS void bends_by_fours(double* bend) const { bends_with<Fours>(bend); }
  SWAGE_FOURS void find_by_fours(const double* nodes) { find_with<Fours>(nodes); }
  SWAGE_FOURS void carry_by_fours(const RodEdges& to, const double* director, double* carried) const {
    carry_with<Fours>(to, director, carried);
  }
  SWAGE_FOURS void twists_by_fours(const double* director, double* sine, double* cosine) const {
    twists_with<Fours>(director, sine, cosine);
  }

  size_t n_ = 0;
  std::vector<double> x_, y_, z_, length_, inverse_;
  std::vector<double> nodes_;  // of which these are the edges
};

}  // namespace swage::toolkit
