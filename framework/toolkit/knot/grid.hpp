// SPDX-License-Identifier: Apache-2.0
//
// Points on a grid of whole numbers, and predicates on them that are exact: integer arithmetic of 128 bits, so a sign is never a
// rounding error and has the same bits everywhere. Coordinates stay below 2^23, differences below 2^24. Header-only.
//
// Threads: [any], pure, nothing allocates.
#pragma once

#include <algorithm>
#include <cstdint>

namespace swage::toolkit {

__extension__ typedef __int128 Wide;

inline int sign_of(Wide w) { return (w > 0) - (w < 0); }

struct GridPoint {
  int64_t x = 0, y = 0, z = 0;
  GridPoint operator-(const GridPoint& b) const { return {x - b.x, y - b.y, z - b.z}; }
};

/// Sign of det(b - a, c - a, d - a): of the volume of a tetrahedron; 0 where the four lie in a plane.
inline int orientation(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& d) {
  const GridPoint u = b - a, v = c - a, w = d - a;
  return sign_of(Wide(u.x) * (v.y * w.z - v.z * w.y) + Wide(u.y) * (v.z * w.x - v.x * w.z) +
                 Wide(u.z) * (v.x * w.y - v.y * w.x));
}

struct GridBox {
  GridPoint lo{INT64_MAX, INT64_MAX, INT64_MAX}, hi{INT64_MIN, INT64_MIN, INT64_MIN};
  void add(const GridPoint& p) {
    lo = {std::min(lo.x, p.x), std::min(lo.y, p.y), std::min(lo.z, p.z)};
    hi = {std::max(hi.x, p.x), std::max(hi.y, p.y), std::max(hi.z, p.z)};
  }
  bool apart(const GridBox& b) const {
    return lo.x > b.hi.x || b.lo.x > hi.x || lo.y > b.hi.y || b.lo.y > hi.y || lo.z > b.hi.z || b.lo.z > hi.z;
  }
  static GridBox of(const GridPoint& a, const GridPoint& b) {
    GridBox box;
    box.add(a), box.add(b);
    return box;
  }
};

/// False when the segment pq is certainly clear of the triangle abc; a segment that touches it, or lies in its plane, is not clear.
inline bool meets(const GridPoint& a, const GridPoint& b, const GridPoint& c, const GridPoint& p,
                  const GridPoint& q) {
  const int sp = orientation(a, b, c, p), sq = orientation(a, b, c, q);
  if (sp == sq) return sp == 0;
  const int ab = orientation(p, q, a, b), bc = orientation(p, q, b, c), ca = orientation(p, q, c, a);
  const bool positive = ab > 0 || bc > 0 || ca > 0, negative = ab < 0 || bc < 0 || ca < 0;
  return !(positive && negative);
}

}  // namespace swage::toolkit
