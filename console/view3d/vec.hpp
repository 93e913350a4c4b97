// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The vector formulas needed for drawing, in double, on the plain structs of the plugin boundary.
#pragma once

#include <swage/abi/base.h>

#include <cmath>

namespace swage::console {

struct Vec {
  double x = 0, y = 0, z = 0;
  Vec() = default;
  Vec(double x_, double y_, double z_) : x(x_), y(y_), z(z_) {}
  Vec(const swage_vec3& v) : x(v.x), y(v.y), z(v.z) {}  // NOLINT: the boundary's vector is the same thing
  double operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
};

inline Vec operator+(const Vec& a, const Vec& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(const Vec& a, const Vec& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(const Vec& a, double s) { return {a.x * s, a.y * s, a.z * s}; }
inline double dot(const Vec& a, const Vec& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline Vec cross(const Vec& a, const Vec& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double norm(const Vec& a) { return std::sqrt(dot(a, a)); }
inline Vec normalized(const Vec& a) {
  const double n = norm(a);
  return n > 0 ? a * (1 / n) : Vec(0, 0, 1);
}
inline Vec any_perpendicular(const Vec& a) {
  return normalized(std::abs(a.z) < 0.9 ? cross(a, {0, 0, 1}) : cross(a, {1, 0, 0}));
}

/// v turned by the unit quaternion q.
inline Vec rotate(const swage_quat& q, const Vec& v) {
  const Vec u{q.x, q.y, q.z}, t = cross(u, v) * 2;
  return v + t * q.w + cross(u, t);
}
inline Vec transform(const swage_pose& X_AB, const Vec& p_B) { return rotate(X_AB.q, p_B) + Vec(X_AB.p); }

}  // namespace swage::console
