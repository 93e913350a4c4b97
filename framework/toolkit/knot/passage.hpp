// SPDX-License-Identifier: Apache-2.0
//
// Passages: places at which a thread has passed through itself between two moments, each node on a straight line from one to the other.
// Two pieces meet when their four ends lie in a plane (a cubic in time) and the pieces cross there. Header-only.
//
// Threads: [rt], nothing allocates.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "toolkit/fixed_vector.hpp"
#include "toolkit/math.hpp"

namespace swage::toolkit {

struct KnotPassage {
  double s = 0, other = 0;  // places on the thread, in nodes
  int jump = 0;             // change of the writhe: 2 or -2
};

class KnotPassages {
 public:
  static constexpr int kNodes = 402, kMost = 32;
  using Found = FixedVector<KnotPassage, kMost>;

  /// Finds the passages between two states of n nodes, x y z each, and returns their number; `out` has at most the first kMost. -1 for a
  /// thread of more than kNodes, which is not searched.
  int find(const double* then, const double* now, int n, Found& out) {
    out.clear(), count_ = 0;
    if (n > kNodes) return -1;
    then_ = then, now_ = now, edges_ = n - 1;
    const int blocks = (edges_ + kBlock - 1) / kBlock;
    for (int b = 0; b < blocks; ++b) {
      box_[at(b)] = edge_box(b * kBlock);
      for (int i = b * kBlock + 1; i < end_of(b); ++i) box_[at(b)].extend(edge_box(i));
    }
    for (int b = 0; b < blocks; ++b)
      for (int c = b; c < blocks; ++c)
        if (box_[at(b)].intersects(box_[at(c)])) find_between(b, c, out);
    return count_;
  }

 private:
  static constexpr int kBlock = 8;
  using Box = Eigen::AlignedBox<double, 3>;
  static size_t at(int i) { return static_cast<size_t>(i); }
  int end_of(int block) const { return std::min(edges_, (block + 1) * kBlock); }
  Vec3 node(const double* of, int i) const { return Eigen::Map<const Vec3>(of + 3 * i); }
  Box edge_box(int i) const {
    Box box(node(then_, i));
    box.extend(node(then_, i + 1)), box.extend(node(now_, i)), box.extend(node(now_, i + 1));
    return box;
  }

  void find_between(int b, int c, Found& out) {
    for (int i = b * kBlock; i < end_of(b); ++i) {
      const Box mine = edge_box(i);
      if (!mine.intersects(box_[at(c)])) continue;
      for (int j = std::max(i + 2, c * kBlock); j < end_of(c); ++j)
        if (mine.intersects(edge_box(j))) find_pair(i, j, out);
    }
  }

  struct Pair {
    Vec3 u, v, w;  // of piece i, of piece j, from the first end of j to that of i
    double volume() const { return w.dot(u.cross(v)); }
  };
  Pair pair(int i, int j, double t) const {
    const auto p = [&](int k) { return Vec3(node(then_, k) + t * (node(now_, k) - node(then_, k))); };
    return {p(i + 1) - p(i), p(j + 1) - p(j), p(i) - p(j)};
  }

  /// The volume of the four ends is a cubic in time; between its extremes it has at most one zero.
  void find_pair(int i, int j, Found& out) {
    const double f0 = pair(i, j, 0).volume(), f1 = pair(i, j, 1).volume(), fa = pair(i, j, 1.0 / 3).volume(),
                 fb = pair(i, j, 2.0 / 3).volume();
    // coefficients from four values
    const double c3 = 4.5 * (f1 - 3 * fb + 3 * fa - f0), c2 = 4.5 * (2 * f0 - 5 * fa + 4 * fb - f1),
                 c1 = 0.5 * (-11 * f0 + 18 * fa - 9 * fb + 2 * f1);
    std::array<double, 4> knot{0, 1, 1, 1};
    int n = 1;
    const double d = c2 * c2 - 3 * c3 * c1;
    if (d > 0) {
      const double q = -(c2 + (c2 < 0 ? -1 : 1) * std::sqrt(d));
      double one = q / (3 * c3), two = c1 / q;
      if (two < one) std::swap(one, two);
      for (const double t : {one, two})
        if (t > 0 && t < 1) knot[at(n++)] = t;
    }
    knot[at(n)] = 1;
    for (int k = 0; k < n; ++k) {
      const double from = pair(i, j, knot[at(k)]).volume(), to = pair(i, j, knot[at(k + 1)]).volume();
      if ((from < 0) != (to < 0)) meet(i, j, zero(i, j, knot[at(k)], knot[at(k + 1)], from < 0), to < 0 ? -2 : 2, out);
    }
  }
  double zero(int i, int j, double low, double high, bool rising) const {
    for (int k = 0; k < 40; ++k) {
      const double t = 0.5 * (low + high);
      ((pair(i, j, t).volume() < 0) == rising ? low : high) = t;
    }
    return 0.5 * (low + high);
  }
  /// For two pieces in a plane: place of their intersection along the piece `along`, 0 to 1; false where they do not cross.
  static bool share_of(const Vec3& from, const Vec3& across, const Vec3& along, double& out) {
    const Vec3 n = along.cross(across);
    out = from.cross(across).dot(n) / n.squaredNorm();
    return out >= 0 && out < 1;
  }
  void meet(int i, int j, double t, int jump, Found& out) {
    const Pair p = pair(i, j, t);
    KnotPassage passage;
    if (!share_of(-p.w, p.v, p.u, passage.s) || !share_of(p.w, p.u, p.v, passage.other)) return;
    passage.s += i, passage.other += j, passage.jump = jump;
    ++count_;
    out.add(passage);
  }

  const double *then_ = nullptr, *now_ = nullptr;
  int edges_ = 0, count_ = 0;
  std::array<Box, kNodes / kBlock + 1> box_;
};

}  // namespace swage::toolkit
