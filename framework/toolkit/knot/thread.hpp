// SPDX-License-Identifier: Apache-2.0
//
// A thread, as a polyline on a grid whose two ends are led far away, straightened as far as the thread allows: a vertex is removed
// when no other piece pierces the triangle with its two neighbours (Koniaris and Muthukumar 1991). The rest is knotted as before and
// has a few straight sticks: about 6 for a half knot, 20 for three throws. Every decision is exact (grid.hpp).
//
// The thread is read in slices of bounded work, so that a step of the loop pays for a little of it. All that lasts is doubles (whole
// numbers), so it can be kept among the private numbers of a plugin.
//
// Threads: [rt], nothing allocates.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "toolkit/knot/grid.hpp"
#include "toolkit/math.hpp"

namespace swage::toolkit {

/// A vertex: whole numbers on the grid, and where on the thread it is, counted in nodes.
struct KnotVertex {
  double x = 0, y = 0, z = 0, s = 0;
  GridPoint grid() const { return {static_cast<int64_t>(x), static_cast<int64_t>(y), static_cast<int64_t>(z)}; }
};

/// Results of the views of a thread so far (reader.hpp).
struct KnotFindings {
  static constexpr int kThrows = 12;
  struct Throw {
    double turns = 0, sign = 0, knot = 0, strand[4] = {};
  };
  double word = -1;           // as a number; -1: none yet
  double agreed = 0;          // views that gave it
  double contradicted = 0;    // 1: two views gave different invariants, which views of one knot cannot
  double excess = 1e9;        // crossings removed from the plainest view that gave it
  double rival = 1e9;         // crossings removed from the plainest view that gave another word of the same invariants
  double determinant = 0, signature = 0;  // of all views; determinant 0: not known yet
  double taken = 1e9;         // nodes, of thread that the throws take in the view that locates them, and its removed crossings
  double throws = 0, knots = 0;
  std::array<Throw, kThrows> tied{};
};

struct KnotThread {
  static constexpr int kNodes = 402;       // most nodes of a thread
  static constexpr int kVertices = kNodes + 2;
  static constexpr int kMostSweeps = 40;   // 3 to 8 are usual; beyond, the thread is read as straight as it is
  /// The thread fills a cube of +- 2^20 of the grid; its ends are led 2^22 farther. 10 mm of half a cube: 10 nm.
  static constexpr double kHalfCube = 1 << 20, kFar = 1 << 22;
  /// Nodes are moved by up to 8 of the grid, so that none stay exactly in a line or a plane: 1e-5 of the cube, far less
  /// than a thread is thick.
  static constexpr int kJitter = 8;

  /// Takes n nodes, x y z each. False when there are too few, too many, or one is not finite.
  bool begin(const double* node, int n);
  /// Continues by about `work` tests of a piece with a piece; true when nothing is left to do. At first vertices stay about n / 64 nodes
  /// apart at most, so that places on the thread are accurate; after go_on() without that bound.
  bool straighten(int work);
  void go_on() { gap = kNodes, next = 1, kept = 0, dropped = 0, done = 0; }
  int vertices() const { return static_cast<int>(count); }

  double count = 0;            // vertices
  double next = 0, kept = 0;   // of the present sweep: the next vertex to test; the last one kept
  double dropped = 0, sweeps = 0, done = 1;
  double gap = kNodes;                  // nodes between two vertices, at most
  double view = 0;  // the reader's next view
  KnotFindings findings;
  std::array<KnotVertex, kVertices> vertex{};

 private:
  static constexpr int kBlock = 16;  // pieces that share a box
  using Boxes = std::array<GridBox, kVertices / kBlock + 1>;

  static size_t at(int i) { return static_cast<size_t>(i); }
  KnotVertex far_end(int end, int inner) const;
  bool clear(int k, int i, const Boxes& before, const Boxes& after, int& work) const;
  bool clear_of(const GridPoint* triangle, const GridBox& around, int first, int last, const Boxes& boxes,
                int& work) const;
  void box_up(int first, int last, Boxes& boxes) const;
  void end_sweep();
};

/// The direction in which an end is led away: of 26, the one farthest in angle from all of the thread.
inline KnotVertex KnotThread::far_end(int end, int inner) const {
  const KnotVertex& e = vertex[at(end)];
  double best = 2;
  Vec3 out = Vec3::UnitX();
  for (int c = 0; c < 27; ++c) {
    if (c == 13) continue;
    const Vec3 d = Vec3(c % 3 - 1 + 0.1, c / 3 % 3 - 1 + 0.07, c / 9 - 1 - 0.13).normalized();
    double most = -1;
    for (int i = 1; i <= vertices() - 2 && most < best; ++i) {
      const KnotVertex& v = vertex[at(i)];
      const Vec3 r(v.x - e.x, v.y - e.y, v.z - e.z);
      if (i != end) most = std::max(most, r.dot(d) / r.norm());
    }
    if (most < best) best = most, out = d;
  }
  return {std::nearbyint(e.x + kFar * out.x()), std::nearbyint(e.y + kFar * out.y()),
          std::nearbyint(e.z + kFar * out.z()), static_cast<double>(inner)};
}

inline bool KnotThread::begin(const double* node, int n) {
  count = 0, done = 1;
  if (n < 2 || n > kNodes) return false;
  Vec3 lo = Vec3::Constant(HUGE_VAL), hi = -lo;
  for (int i = 0; i < n; ++i) {
    const Vec3 p = Eigen::Map<const Vec3>(node + 3 * i);
    if (!p.allFinite()) return false;
    lo = lo.cwiseMin(p), hi = hi.cwiseMax(p);
  }
  const Vec3 middle = 0.5 * (lo + hi);
  const double half = 0.5 * (hi - lo).maxCoeff();
  if (!(half > 0)) return false;
  const double scale = kHalfCube / half;
  uint64_t noise = 0x9e3779b97f4a7c15u;
  const auto jitter = [&] {  // a linear congruential generator: the same for every thread
    noise = noise * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(static_cast<int>(noise >> 40) % (2 * kJitter + 1) - kJitter);
  };
  for (int i = 0; i < n; ++i) {
    const Vec3 p = scale * (Eigen::Map<const Vec3>(node + 3 * i) - middle);
    KnotVertex& v = vertex[at(i + 1)];
    v.x = std::nearbyint(p.x()) + jitter();
    v.y = std::nearbyint(p.y()) + jitter();
    v.z = std::nearbyint(p.z()) + jitter();
    v.s = i;
  }
  count = n + 2;
  vertex[0] = far_end(1, 0);
  vertex[at(n + 1)] = far_end(n, n - 1);
  next = 1, kept = 0, dropped = 0, sweeps = 0, done = 0, view = 0, findings = {};
  gap = std::max(2, n / 64);
  return true;
}

/// Boxes of the pieces that begin at the vertices first to last - 1.
inline void KnotThread::box_up(int first, int last, Boxes& boxes) const {
  for (int i = first; i < last; ++i) {
    GridBox& box = boxes[at(i / kBlock)];
    box.add(vertex[at(i)].grid()), box.add(vertex[at(i + 1)].grid());
  }
}

/// True when no piece that begins at the vertices first to last - 1 meets the triangle.
inline bool KnotThread::clear_of(const GridPoint* t, const GridBox& around, int first, int last,
                                 const Boxes& boxes, int& work) const {
  for (int block = first; block < last; block = (block / kBlock + 1) * kBlock) {
    --work;
    if (around.apart(boxes[at(block / kBlock)])) continue;
    const int end = std::min(last, (block / kBlock + 1) * kBlock);
    for (int i = block; i < end; ++i) {
      const GridPoint p = vertex[at(i)].grid(), q = vertex[at(i + 1)].grid();
      --work;
      if (!around.apart(GridBox::of(p, q)) && meets(t[0], t[1], t[2], p, q)) return false;
    }
  }
  return true;
}

/// True when vertex i may be removed; k is the last kept before it. Pieces that share only a corner with the triangle must leave its plane.
inline bool KnotThread::clear(int k, int i, const Boxes& before, const Boxes& after, int& work) const {
  const GridPoint t[3] = {vertex[at(k)].grid(), vertex[at(i)].grid(), vertex[at(i + 1)].grid()};
  if (k > 0 && orientation(t[0], t[1], t[2], vertex[at(k - 1)].grid()) == 0) return false;
  if (i + 2 < vertices() && orientation(t[0], t[1], t[2], vertex[at(i + 2)].grid()) == 0) return false;
  GridBox around = GridBox::of(t[0], t[1]);
  around.add(t[2]);
  return clear_of(t, around, 0, k - 1, before, work) && clear_of(t, around, i + 2, vertices() - 1, after, work);
}

inline void KnotThread::end_sweep() {
  vertex[at(static_cast<int>(kept) + 1)] = vertex[at(vertices() - 1)];
  count = kept + 2;
  sweeps += 1;
  done = dropped == 0 || sweeps >= kMostSweeps;
  next = 1, kept = 0, dropped = 0;
}

inline bool KnotThread::straighten(int work) {
  while (done == 0 && work > 0) {
    Boxes before, after;
    box_up(0, static_cast<int>(kept), before);
    box_up(static_cast<int>(next), vertices() - 1, after);
    while (work > 0 && next < count - 1) {
      const int k = static_cast<int>(kept), i = static_cast<int>(next);
      --work;
      if (vertex[at(i + 1)].s - vertex[at(k)].s <= gap && clear(k, i, before, after, work)) {
        dropped += 1;
      } else {
        vertex[at(k + 1)] = vertex[at(i)];
        box_up(k, k + 1, before);
        kept += 1;
      }
      next += 1;
    }
    if (next >= count - 1) end_sweep();
  }
  return done != 0;
}

}  // namespace swage::toolkit
