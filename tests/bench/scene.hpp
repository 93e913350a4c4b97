// SPDX-License-Identifier: Apache-2.0
//
// The scene that every method and every peer gets: a micro-needle between two triangular jaws. SI units.
//
// Needle body frame N: origin at the centre of mass, +x normal of the curve's plane, +y along the tangent at
// mid-arc, +z away from the centre of curvature. A straight needle lies along +y. Jaw frame J: origin on the
// hinge axis, +x from hinge to tip, the upper jaw above z = 0 and the lower below; the gripping faces are in
// z = 0. A positive opening turns the upper jaw about -y, the lower about +y.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include "toolkit/math.hpp"

namespace swage::bench {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

struct Needle {
  double arc = 135.0 / 180.0 * std::numbers::pi;  // rad, 3/8 circle
  double chord = 5.0e-3;                          // m
  double wire_diameter = 0.1e-3;                  // m
  double density = 7900;                          // kg/m3, steel
  bool straight = false;
  double held_at = 0;  // rad from mid-arc, the place between the jaws

  double wire_radius() const { return 0.5 * wire_diameter; }
  double radius() const { return chord / (2 * std::sin(arc / 2)); }  // of the centre line
  double length() const { return radius() * arc; }
  double mass() const { return density * std::numbers::pi * wire_radius() * wire_radius() * length(); }
  /// Distance of the centre of mass from the centre of curvature: R sin(a/2) / (a/2).
  double offset() const { return radius() * std::sin(arc / 2) / (arc / 2); }
  /// Place of the centre line at the angle theta from mid-arc, in N.
  Vec3 point(double theta) const {
    if (straight) return {0, radius() * theta, 0};
    return {0, radius() * std::sin(theta), radius() * std::cos(theta) - offset()};
  }
  /// Principal moments in N. Thin-torus terms of the section: t = m r^2 times 3/4 about the normal, 5/8 in
  /// the plane.
  Vec3 inertia() const {
    const double m = mass(), r2 = wire_radius() * wire_radius(), R2 = radius() * radius();
    if (straight) {
      const double across = m * length() * length() / 12 + m * r2 / 4;
      return {across, m * r2 / 2, across};
    }
    const double c2 = offset() * offset(), s = std::sin(arc) / arc;
    return {m * (R2 - c2) + 0.75 * m * r2, m * (0.5 * R2 * (1 + s) - c2) + 0.625 * m * r2,
            m * 0.5 * R2 * (1 - s) + 0.625 * m * r2};
  }
  /// Centres of the thesis's chain of n spheres, in N.
  std::vector<Vec3> chain(int n) const {
    std::vector<Vec3> centre;
    for (int i = 0; i < n; ++i) centre.push_back(point(arc * (static_cast<double>(i) / (n - 1) - 0.5)));
    return centre;
  }
};

struct Jaw {
  static constexpr double kHinge = 4e-3;         // m, hinge axis to the base of the jaw
  static constexpr double kLength = 6e-3;        // m, base to tip
  static constexpr double kHalfWidth = 0.75e-3;  // m, at the base
  static constexpr double kThickness = 0.3e-3;   // m
  static constexpr double kGrip = 8e-3;          // m, hinge axis to the place of the grip; 0.5 mm wide there

  std::vector<Vec3> vertex;                 // in J
  std::vector<std::vector<uint32_t>> face;  // counter-clockwise from outside
};

/// side: +1 upper, -1 lower. A triangular prism: 5 faces, 9 edges.
inline Jaw jaw(int side) {
  const double x0 = Jaw::kHinge, x1 = Jaw::kHinge + Jaw::kLength, w = Jaw::kHalfWidth,
               t = side * Jaw::kThickness;
  Jaw j;
  j.vertex = {{x0, -w, 0}, {x0, w, 0}, {x1, 0, 0}, {x0, -w, t}, {x0, w, t}, {x1, 0, t}};
  j.face = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}};
  if (side < 0)
    for (auto& f : j.face) std::reverse(f.begin(), f.end());
  return j;
}

/// Triangles of a jaw for engines that want a mesh.
inline std::vector<std::array<uint32_t, 3>> triangles(const Jaw& j) {
  std::vector<std::array<uint32_t, 3>> out;
  for (const auto& f : j.face)
    for (size_t i = 1; i + 1 < f.size(); ++i) out.push_back({f[0], f[i], f[i + 1]});
  return out;
}

/// Pose of a jaw opened by `angle` [rad] (upper: positive, lower: negative) on a tool at X_WT.
inline Pose jaw_pose(const Pose& X_WT, double angle) {
  return X_WT * Pose{Vec3::Zero(), toolkit::exp_rotation({0, -angle, 0})};
}

/// The needle at the grip, where it is held between the jaws, wire across them and turned as closing jaws turn it: what they
/// cover of the arc lies evenly between them. Nearer to an end than half the jaws' width they cover less on that side; any other
/// attitude would press one jaw beside the other, a couple that rigid jaws at a fixed opening let go on until the wire is loose.
inline Pose grip_pose(const Needle& n) {
  const double half = Jaw::kHalfWidth * (Jaw::kHinge + Jaw::kLength - Jaw::kGrip) / Jaw::kLength / n.radius();
  const double middle =
      0.5 * (std::max(n.held_at - half, -0.5 * n.arc) + std::min(n.held_at + half, 0.5 * n.arc));
  const Quat q = n.straight ? Quat::Identity() : toolkit::exp_rotation({middle, 0, 0});
  return {Vec3{Jaw::kGrip, 0, 0} - q * n.point(n.held_at), q};
}

}  // namespace swage::bench
