// SPDX-License-Identifier: Apache-2.0
//
// How often a thread is wound about an instrument, and whether it has passed through it. In the tool's frame the axis of the instrument
// is x, from -reach to its tips at 0; a piece of thread counts as far as it lies beside that. The winding is the sum of the angles of
// the pieces about the axis: a thread that only passes by has half a turn at most. Header-only.
//
// Threads: [rt], pure, nothing allocates.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "toolkit/math.hpp"

namespace swage::toolkit {

/// Turns of a thread about an axis, piece by piece from its first end on. Right-handed about +x is positive.
class Winding {
 public:
  /// reach [m]: length of the instrument that counts, from its tips back.
  explicit Winding(double reach) : reach_(reach) {}

  /// A straight piece from a to b, in the tool's frame.
  void add(const Vec3& a, const Vec3& b) {
    const double dx = b.x() - a.x();
    double from = 0, to = 1;  // share of the piece that lies beside the instrument
    if (dx == 0) {
      if (a.x() > 0 || a.x() < -reach_) return;
    } else {
      const double tips = -a.x() / dx, base = (-reach_ - a.x()) / dx;
      from = std::max(from, std::min(tips, base));
      to = std::min(to, std::max(tips, base));
    }
    if (from >= to) return;
    const Vec3 p = a + from * (b - a), q = a + to * (b - a);
    const double angle = std::atan2(p.y() * q.z() - p.z() * q.y(), p.y() * q.y() + p.z() * q.z());
    angle_ += angle;
    way_ += std::abs(angle);
    behind_ -= std::abs(angle) * 0.5 * (p.x() + q.x());
  }

  double turns() const { return angle_ / (2 * std::numbers::pi); }
  /// Distance from the tips back to the winding [m], averaged over its angle; 0 without a winding.
  double behind() const { return way_ > 0 ? behind_ / way_ : 0; }

 private:
  double reach_;
  double angle_ = 0, way_ = 0, behind_ = 0;  // rad, rad, rad m
};

/// Turns that a piece gains by passing through the axis, between its ends a0, b0 then and a1, b1 now, each on a straight line in the
/// tool's frame: 0, or 1 or -1. The area of the triangle of axis and piece is quadratic in time.
inline int wound_through(const Vec3& a0, const Vec3& b0, const Vec3& a1, const Vec3& b1, double reach) {
  const auto area = [](const Vec3& a, const Vec3& b) { return a.y() * b.z() - a.z() * b.y(); };
  const Vec3 da = a1 - a0, db = b1 - b0;
  const double c0 = area(a0, b0), c2 = area(da, db), c1 = area(a1, b1) - c0 - c2;
  std::array<double, 2> root{2, 2};
  const double d = c1 * c1 - 4 * c2 * c0;
  if (d < 0) return 0;
  const double q = -0.5 * (c1 + (c1 < 0 ? -1 : 1) * std::sqrt(d));
  if (c2 != 0) root[0] = q / c2;
  if (q != 0) root[1] = c0 / q;
  int gained = 0;
  for (const double t : root) {
    if (!(t > 0 && t <= 1)) continue;
    const Vec3 a = a0 + t * da, b = b0 + t * db;
    const double la = std::hypot(a.y(), a.z()), lb = std::hypot(b.y(), b.z());
    if (a.y() * b.y() + a.z() * b.z() >= 0 || la + lb == 0) continue;  // the axis is not between the ends
    const double x = a.x() + la / (la + lb) * (b.x() - a.x());
    if (x > 0 || x < -reach) continue;
    const double rate = c1 + 2 * c2 * t;  // where the area rises through 0 the angle goes from -pi to pi
    gained += rate > 0 ? 1 : rate < 0 ? -1 : 0;
  }
  return gained;
}

}  // namespace swage::toolkit
