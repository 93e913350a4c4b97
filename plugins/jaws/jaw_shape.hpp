// SPDX-License-Identifier: Apache-2.0
//
// The two jaws as convex polyhedra and the law by which closing the handle becomes force.
//
// Tool frame T: origin in the middle of the closed tips, x from the hinge to the tips, z the closing
// direction from the right jaw to the left one, y = z cross x across the gripping faces. Closed, both
// gripping faces lie in the plane z = 0. Jaw frame J: axes of T, origin on the hinge axis; the shapes below
// are in J.
#pragma once

#include <swage/units.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

namespace swage::jaws {

enum class JawShape : int { kPrism, kTetrahedron };

/// Sizes of one jaw. The gripping face is a triangle, or with a blunt tip a trapezium, symmetric about the x
/// axis.
struct JawSize {
  double reach = 10e-3;        // m, hinge axis to tip
  double length = 6e-3;        // m, base of the gripping face to tip
  double base_width = 1.5e-3;  // m, of the gripping face at its base
  double tip_width = 0.3e-3;   // m, 0 for a sharp triangle
  double thickness = 0.3e-3;   // m, behind the gripping face
};

/// Vertices and faces in the layout of swage_convex.
struct JawMesh {
  std::vector<double> vertex;  // 3 n, m, in J
  std::vector<uint32_t> face_start, face_vertex;
  uint32_t n_vertex() const { return static_cast<uint32_t>(vertex.size() / 3); }
  uint32_t n_face() const { return static_cast<uint32_t>(face_start.size() - 1); }
};

namespace detail {
inline void add_vertex(JawMesh& mesh, double x, double y, double z) {
  mesh.vertex.insert(mesh.vertex.end(), {x, y, z});
}
/// `loop` is counter-clockwise from outside for a left jaw; the right jaw is its mirror image, which reverses
/// loops.
inline void add_face(JawMesh& mesh, std::vector<uint32_t> loop, bool mirrored) {
  if (mirrored) std::reverse(loop.begin(), loop.end());
  if (mesh.face_start.empty()) mesh.face_start.push_back(0);
  mesh.face_vertex.insert(mesh.face_vertex.end(), loop.begin(), loop.end());
  mesh.face_start.push_back(static_cast<uint32_t>(mesh.face_vertex.size()));
}
}  // namespace detail

/// Two parallel outlines joined by side walls: 5 planes and 9 edges with a sharp tip, 6 and 12 with a blunt
/// one.
inline JawMesh prism(const JawSize& size, bool left) {
  const double side = left ? 1 : -1;
  const double base = size.reach - size.length, tip = size.reach;
  std::vector<double> outline = {base, -0.5 * size.base_width};
  if (size.tip_width > 0) {
    outline.insert(outline.end(), {tip, -0.5 * size.tip_width, tip, 0.5 * size.tip_width});
  } else {
    outline.insert(outline.end(), {tip, 0.0});
  }
  outline.insert(outline.end(), {base, 0.5 * size.base_width});
  const auto n = static_cast<uint32_t>(outline.size() / 2);

  // the gripping outline at z = 0, then the back
  JawMesh mesh;
  for (const double z : {0.0, side * size.thickness}) {
    for (uint32_t i = 0; i < n; ++i) detail::add_vertex(mesh, outline[2 * i], outline[2 * i + 1], z);
  }
  std::vector<uint32_t> grip, back;
  for (uint32_t i = 0; i < n; ++i) {
    grip.push_back(n - 1 - i);
    back.push_back(n + i);
  }
  detail::add_face(mesh, grip, !left);
  detail::add_face(mesh, back, !left);
  for (uint32_t i = 0; i < n; ++i) {
    const uint32_t j = (i + 1) % n;
    detail::add_face(mesh, {i, j, n + j, n + i}, !left);
  }
  return mesh;
}

/// A sharp triangle with a ridge that rises towards the hinge: a pair has the 8 planes and 12 edges of the
/// thesis.
inline JawMesh tetrahedron(const JawSize& size, bool left) {
  const double side = left ? 1 : -1;
  const double base = size.reach - size.length;
  JawMesh mesh;
  detail::add_vertex(mesh, base, -0.5 * size.base_width, 0);
  detail::add_vertex(mesh, size.reach, 0, 0);
  detail::add_vertex(mesh, base, 0.5 * size.base_width, 0);
  detail::add_vertex(mesh, base, 0, side * size.thickness);
  detail::add_face(mesh, {2, 1, 0}, !left);
  detail::add_face(mesh, {0, 1, 3}, !left);
  detail::add_face(mesh, {1, 2, 3}, !left);
  detail::add_face(mesh, {2, 0, 3}, !left);
  return mesh;
}

inline JawMesh jaw_mesh(JawShape shape, const JawSize& size, bool left) {
  return shape == JawShape::kPrism ? prism(size, left) : tetrahedron(size, left);
}

/// The closure of the handle sets the target angle of each jaw; an object between the faces holds the jaw open,
/// and the missing angle gives the force. One straight line from open to past closed:
///   target = half_opening - closure (half_opening + squeeze)
/// so empty jaws meet at closure half_opening / (half_opening + squeeze), and a jaw stopped at `angle`
/// presses with
///   force at the tip = stiffness (angle - target) / reach,  stiffness = max_grip reach / squeeze,
/// never above max_grip. A needle held nearer to the hinge than the tip bears reach / distance times as much.
struct GripLaw {
  double reach = 10e-3;               // m
  double half_opening = 9 * kDegree;  // rad, of one jaw, handle released
  double squeeze = 6 * kDegree;       // rad past closed, handle fully squeezed
  double max_grip = 2.0;              // N at the tips
  double handle_mass = 5e-3;          // kg, mass of the handle, reduced to the tips

  double target(double closure) const {
    return half_opening - std::clamp(closure, 0.0, 1.0) * (half_opening + squeeze);  // rad
  }
  double target_of_force(double force) const {
    return -squeeze * std::clamp(force / max_grip, 0.0, 1.0);  // rad, on closed jaws
  }
  double stiffness() const { return max_grip * reach / squeeze; }               // N m / rad
  double max_torque() const { return max_grip * reach; }                        // N m
  double inertia() const { return handle_mass * reach * reach; }                // kg m2, of one jaw
  double damping() const { return 2 * std::sqrt(stiffness() * inertia()); }     // N m s / rad, critical
  double closed_at() const { return half_opening / (half_opening + squeeze); }  // closure

  /// N, force at the tip of a jaw that rests at `angle`.
  double force(double angle, double drive_target) const {
    return std::clamp(stiffness() * (angle - drive_target) / reach, 0.0, max_grip);
  }
};

}  // namespace swage::jaws
