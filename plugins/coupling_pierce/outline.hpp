// SPDX-License-Identifier: Apache-2.0
//
// Areas of unions of capsules of one radius: each is a convex polygon (its ends are halves of 24-gons with a disc's area), and the
// area of their union is the sum of cross(a, b) / 2 over the parts of their edges a..b that no other capsule covers (Green).
//
// Units m. [rt]: no allocation.
#pragma once

#include <cstdint>

#include "toolkit/math.hpp"

namespace swage::coupling_pierce {

using toolkit::Vec3;
using Vec2 = Eigen::Vector2d;

struct Capsule {
  double a[2], b[2];  // m, ends of the middle line
};

/// The middle line of a capsule.
struct Line {
  Vec2 from = Vec2::Zero(), along = Vec2::Zero();
  double per_length2 = 0;  // 1/m2

  Line() = default;
  explicit Line(const Capsule& capsule);
  double distance2(const Vec2& p) const;
};

/// A capsule as a convex polygon, counter-clockwise. Every point within `inner` of its middle line is inside, and none beyond
/// `outer`.
struct Polygon {
  static constexpr int kCorners = 24;
  Vec2 corner[kCorners];
  Vec2 side[kCorners];      // m, from each corner to the next
  double beside[kCorners];  // m2, cross(side, p) for a point p on that side
  Line line;
  Vec2 low, high;                      // of the box around it
  double inner = 0, outer = 0, size2;  // m, m; m2, square of its longest extent

  Polygon() = default;
  Polygon(const Capsule& capsule, double radius);
};

/// The outline of the union of some capsules, which grows by one at a time. It follows from the capsules alone, so it need not be saved
/// with a state: after a return to an earlier state it is computed anew, with the same bits.
class Outline {
 public:
  static constexpr uint32_t kMost = 15;  // capsules

  /// Makes this the outline of n <= kMost capsules: cheap where it already is the outline of the first of them.
  void follow(const Capsule* capsule, uint32_t n, double radius) noexcept;
  double area() const noexcept;  // m2
  /// Area by which another capsule would enlarge the union [m2].
  double added(const Capsule& capsule, double radius) const noexcept;

 private:
  struct Piece {
    Vec2 a, b;
  };
  // Each capsule covers at most one stretch of an edge: k of them leave at most k pieces of any of their edges.
  static constexpr uint32_t kPieces = Polygon::kCorners * kMost * kMost;

  void insert(const Capsule& capsule, double radius) noexcept;
  void cut(const Polygon& polygon) noexcept;

  uint32_t n_ = 0, n_piece_ = 0;
  double radius_ = 0;
  Capsule capsule_[kMost];
  Polygon polygon_[kMost];
  Piece piece_[kPieces];
};

/// Area of the union of n <= kMost + 1 capsules [m2], edge by edge against all others: the reference for the running sums.
double union_area(const Capsule* capsule, uint32_t n, double radius) noexcept;

}  // namespace swage::coupling_pierce
