// SPDX-License-Identifier: Apache-2.0
//
// Writhe of a polyline and linking number of two closed polygons: Gauss's double integral, exact for straight pieces (each pair by the
// solid angle of directions in which they are seen to cross). For a closed thread Lk = Tw + Wr is constant; when a strand passes
// through another, writhe and linking number jump by 2. Work grows with the square of the nodes. Header-only.
//
// Threads: [any], pure, nothing allocates.
#pragma once

#include <cmath>
#include <numbers>

#include "toolkit/math.hpp"

namespace swage::toolkit {

/// Signed share of all directions in which ab is seen to cross cd, times 2: from -1 to 1. It is positive for a right-handed crossing.
inline double crossing_integral(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 ac = c - a, ad = d - a, bc = c - b, bd = d - b;
  const auto triangle = [](const Vec3& u, const Vec3& v, const Vec3& w) {  // solid angle over 2 (van Oosterom 1983)
    const double lu = u.norm(), lv = v.norm(), lw = w.norm();
    return std::atan2(u.dot(v.cross(w)), lu * lv * lw + u.dot(v) * lw + v.dot(w) * lu + w.dot(u) * lv);
  };
  return -(triangle(ac, ad, bd) + triangle(ac, bd, bc)) / std::numbers::pi;
}

/// Writhe of n nodes, x y z each; a closed polygon continues from the last to the first.
inline double writhe(const double* node, int n, bool closed) {
  const auto p = [&](int i) { return Vec3(Eigen::Map<const Vec3>(node + 3 * (i % n))); };
  const int edges = closed ? n : n - 1;
  double sum = 0;
  for (int i = 0; i < edges; ++i)
    for (int j = i + 2; j < edges; ++j)
      if (j - i != n - 1) sum += crossing_integral(p(i), p(i + 1), p(j), p(j + 1));
  return sum;
}

/// Linking number of two closed polygons; a whole number, up to rounding.
inline double linking(const double* node, int n, const double* other, int m) {
  const auto p = [&](int i) { return Vec3(Eigen::Map<const Vec3>(node + 3 * (i % n))); };
  const auto q = [&](int i) { return Vec3(Eigen::Map<const Vec3>(other + 3 * (i % m))); };
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) sum += 0.5 * crossing_integral(p(i), p(i + 1), q(j), q(j + 1));
  return sum;
}

}  // namespace swage::toolkit
