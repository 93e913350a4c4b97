// SPDX-License-Identifier: Apache-2.0
//
// The needle and the jaws as shapes and solids of our own rooms, for tests and benchmarks. `unit` multiplies all lengths.
#pragma once

#include <stdexcept>

#include "contact/solid.hpp"
#include "scene.hpp"

namespace swage::bench {

inline toolkit::Convex convex(const Jaw& jaw, double unit = 1) {
  std::vector<Vec3> vertex;
  for (const Vec3& v : jaw.vertex) vertex.push_back(unit * v);
  std::vector<uint32_t> start{0}, index;
  for (const auto& f : jaw.face) {
    index.insert(index.end(), f.begin(), f.end());
    start.push_back(static_cast<uint32_t>(index.size()));
  }
  toolkit::Convex out;
  const std::string problem = toolkit::build_convex(vertex, start, index, out);
  if (!problem.empty()) throw std::runtime_error(problem);
  return out;
}

inline scene::Shape convex_shape() {
  scene::Shape s;
  s.kind = SWAGE_SHAPE_CONVEX;
  s.X_BS = Pose().abi();
  s.convex = 0;
  return s;
}

/// The needle's wire, its arc about the body frame of bench::Needle.
inline scene::Shape needle_shape(const Needle& n, double unit = 1) {
  scene::Shape s;
  s.kind = n.straight ? SWAGE_SHAPE_CAPSULE : SWAGE_SHAPE_ARC;
  s.radius = unit * n.wire_radius();
  if (n.straight) {
    s.half_length = 0.5 * unit * n.length();
    s.X_BS = Pose(Vec3::Zero(), toolkit::exp_rotation({-std::numbers::pi / 2, 0, 0})).abi();
    return s;
  }
  s.arc_radius = unit * n.radius();
  s.sweep = n.arc;
  // arc about S.z from S.x: start at theta = -arc / 2, turning from N.z towards N.y
  toolkit::Mat3 R;
  const double a = -0.5 * n.arc;
  R.col(0) = Vec3(0, std::sin(a), std::cos(a));
  R.col(1) = Vec3(0, std::cos(a), -std::sin(a));
  R.col(2) = R.col(0).cross(R.col(1));
  s.X_BS = Pose(Vec3(0, 0, -unit * n.offset()), Quat(R)).abi();
  return s;
}

inline contact::Solid contact_solid(const Jaw& jaw, double unit = 1) {
  return contact::make_solid(convex_shape(), {convex(jaw, unit)});
}
inline contact::Solid contact_solid(const Needle& n, double unit = 1) {
  return contact::make_solid(needle_shape(n, unit), {});
}

inline Pose scaled(const Pose& X, double unit) { return {unit * X.p, X.q}; }

}  // namespace swage::bench
