// SPDX-License-Identifier: Apache-2.0
//
// The state of the world, as arrays. The host owns all of it; plugins see slices. From that follow saving,
// rewinding, replaying and hashing (state_image.hpp).
//
// Units: SI. Frames: W world, right-handed, +Z up; B a body. Indices are global; every object owns contiguous
// ranges. Threads: built on [main]; afterwards touched by [rt] alone.
#pragma once

#include <swage/abi/object.h>
#include <swage/environment.hpp>

#include <cstdint>
#include <string>
#include <vector>

#include "scene/capacities.hpp"
#include "toolkit/convex.hpp"

namespace swage::scene {

inline constexpr uint32_t kNone = SWAGE_NONE;

/// Motion and mass of one body; fixed once the scene is built.
struct BodyInfo {
  int32_t motion = SWAGE_MOTION_FIXED;
  uint32_t object = kNone;
  uint32_t hinge = kNone;         // for HINGED bodies
  double mass = 0;                // kg, DYNAMIC only
  double inertia[3] = {0, 0, 0};  // kg m2, principal, about B's origin = centre of mass
  swage_pose start{};             // X_WB at reset
  std::string name;
};

/// A surface fixed to a body. X_BS places the shape's own frame S; the numbers in use depend on the kind:
///   SPHERE    radius, centre at S
///   CAPSULE   radius, axis S.z from -half_length to +half_length
///   CYLINDER  the same with flat ends
///   ARC       radius (of the wire), arc_radius, sweep, about S.z from S.x
///   CONVEX    convex, an index into World::convex, in S
///   HEIGHT_FIELD  field, an index into World::field, in S
///   CHAIN     chain, an index into World::chain, in W
struct Shape {
  int32_t kind = SWAGE_SHAPE_SPHERE;
  uint32_t body = kNone;
  uint32_t object = kNone;
  uint32_t flags = SWAGE_SHAPE_USUAL;
  swage_pose X_BS{};
  double radius = 0;       // m
  double half_length = 0;  // m
  double arc_radius = 0;   // m
  double sweep = 0;        // rad
  uint32_t convex = kNone;
  uint32_t field = kNone;
  uint32_t chain = kNone;
  double bounding_radius = 0;  // m, about S's origin
};

/// Heights over a grid (toolkit/height_field.hpp), fixed or those that the object keeps in its private doubles.
struct HeightFieldInfo {
  uint32_t nx = 0, ny = 0;     // vertices
  double dx = 0, dy = 0;       // m, sides of a cell
  double below = 0;            // m, how far the solid reaches under the surface
  std::vector<double> height;  // m, nx ny; as declared
  uint32_t state = kNone;      // first of nx ny in World::plugin_state that hold the heights instead
};

/// A flexible wire (chain.hpp); its state is in the object's private doubles.
struct ChainInfo {
  std::vector<swage_vec3> start;  // m, vertices as declared, in B
  std::vector<double> s;          // m, arc length of each vertex, rising
  std::vector<double> radius;     // m, of the segment that begins at each vertex; 0: no segment, as at the last
  double bend_radius = 0;         // m, least radius of curvature
  uint32_t state = kNone;         // first of 8 n in World::plugin_state
};

/// One angle between a HINGED body and its parent.
struct HingeInfo {
  uint32_t object = kNone, parent = kNone, child = kNone;
  swage_vec3 anchor{};      // m, in the parent
  swage_vec3 axis{};        // unit, in the parent
  swage_pose X_PC0{};       // child in parent at angle 0
  double inertia = 0;       // kg m2 about the axis
  double min = 0, max = 0;  // rad
};

/// Contiguous run of indices.
struct Range {
  uint32_t first = 0, count = 0;
};

/// Everything there is, fixed part first.
struct World {
  // --- fixed while the scene lives
  std::vector<BodyInfo> body;
  std::vector<Shape> shape;
  std::vector<toolkit::Convex> convex;
  std::vector<HeightFieldInfo> field;
  std::vector<ChainInfo> chain;
  std::vector<HingeInfo> hinge;
  std::vector<double> particle_mass;    // kg
  std::vector<double> particle_radius;  // m
  std::vector<uint32_t> particle_object;
  swage_vec3 gravity{0, 0, -9.80665};  // m/s2
  swage_environment environment = kStillAir;
  double length = 1e-3;                // m, characteristic length: every tolerance is relative to it
  double dt = 1e-3;                    // s
  Capacities capacity;                 // of a step

  // --- the state: saved, restored, hashed
  uint64_t step = 0;
  std::vector<swage_pose> X_WB;
  std::vector<swage_twist> V_WB;
  std::vector<double> particle_p_W, particle_v_W;  // 3 n
  std::vector<double> hinge_angle, hinge_rate;     // rad, rad/s
  std::vector<double> hinge_torque;                // N m from contacts in the last step
  std::vector<double> plugin_state;                // all private doubles, in declaration order
  std::vector<double> signal;
  std::vector<uint64_t> random;  // one generator per instance

  // --- inputs of the current step, rewritten every step
  std::vector<swage_wrench> F_B_W;
  std::vector<double> particle_f_W;
  std::vector<swage_drive> drive;

  double time() const { return static_cast<double>(step) * dt; }
};

}  // namespace swage::scene
