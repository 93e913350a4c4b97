// SPDX-License-Identifier: Apache-2.0
//
// The smallest circle that encloses some points of a plane: incrementally, a point that is outside lies on the border of the next one
// (Welzl 1991, in the given order, so that the result is bitwise reproducible). Units m. Header-only, [rt].
#pragma once

#include <cmath>
#include <cstdint>

#include "outline.hpp"

namespace swage::coupling_pierce {

struct Circle {
  Vec2 centre = Vec2::Zero();
  double radius = 0;

  /// True when p is outside by more than rounding.
  bool leaves_out(const Vec2& p) const noexcept { return (p - centre).norm() > radius * (1 + 1e-9); }
};

inline Circle circle_through(const Vec2& a, const Vec2& b) noexcept {
  return {0.5 * (a + b), 0.5 * (b - a).norm()};
}
/// Circle through three points; of three on a line, through the two that are farthest apart.
inline Circle circle_through(const Vec2& a, const Vec2& b, const Vec2& c) noexcept {
  const Vec2 u = b - a, v = c - a;
  const double uu = u.squaredNorm(), vv = v.squaredNorm(), cross = 2 * (u.x() * v.y() - u.y() * v.x());
  if (std::abs(cross) <= 1e-9 * (uu + vv)) {
    const double ww = (c - b).squaredNorm();
    return uu >= vv && uu >= ww ? circle_through(a, b)
           : vv >= ww           ? circle_through(a, c)
                                : circle_through(b, c);
  }
  const Vec2 to((v.y() * uu - u.y() * vv) / cross, (u.x() * vv - v.x() * uu) / cross);
  return {a + to, to.norm()};
}

/// The smallest circle of n points, n at least 1.
inline Circle smallest_circle(const Vec2* p, uint32_t n) noexcept {
  Circle around{p[0], 0};
  for (uint32_t i = 1; i < n; ++i) {
    if (!around.leaves_out(p[i])) continue;
    around = {p[i], 0};
    for (uint32_t j = 0; j < i; ++j) {
      if (!around.leaves_out(p[j])) continue;
      around = circle_through(p[i], p[j]);
      for (uint32_t k = 0; k < j; ++k)
        if (around.leaves_out(p[k])) around = circle_through(p[i], p[j], p[k]);
    }
  }
  return around;
}

}  // namespace swage::coupling_pierce
