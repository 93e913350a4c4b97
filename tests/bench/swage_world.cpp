// SPDX-License-Identifier: Apache-2.0
#include "swage_world.hpp"

#include "scene/kinematics.hpp"
#include "solids.hpp"

namespace swage::bench {
namespace {

/// Arc, straight capsule or ball of a setup, in the needle's body frame.
scene::Shape moving_shape(const Setup& s) {
  const double u = unit_of(s);
  scene::Shape shape = needle_shape(s.needle, u);
  shape.body = kNeedle, shape.object = kNeedleObject;
  shape.bounding_radius = (s.needle.straight ? shape.half_length : shape.arc_radius) + shape.radius;
  if (s.ball_radius > 0) {
    shape.kind = SWAGE_SHAPE_SPHERE;
    shape.X_BS = Pose{}.abi();
    shape.radius = shape.bounding_radius = s.ball_radius * u;
  }
  return shape;
}

scene::Shape fixed_shape(scene::World& world, uint32_t body, const Jaw& j, double unit) {
  scene::Shape shape = convex_shape();
  shape.body = body, shape.object = kJawsObject;
  shape.convex = static_cast<uint32_t>(world.convex.size());
  for (const Vec3& v : j.vertex) shape.bounding_radius = std::max(shape.bounding_radius, unit * v.norm());
  world.convex.push_back(convex(j, unit));
  return shape;
}

/// A plate whose top is the plane z = 0.
Jaw jaw_plate(double half) {
  Jaw j;
  for (double z : {-half, 0.0})
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      j.vertex.push_back({x * half, y * half, z});
  j.face = {{3, 2, 1, 0}, {4, 5, 6, 7}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}};
  return j;
}

}  // namespace

scene::World make_world(const Setup& s) {
  const double u = unit_of(s);
  scene::World w;
  w.length = 1e-3 * u;
  w.dt = s.dt;
  w.gravity = {0, 0, 0};
  w.body.resize(kBodies);
  for (auto& b : w.body) b.start = Pose{}.abi(), b.object = kJawsObject;
  w.body[kNeedle].motion = SWAGE_MOTION_DYNAMIC;
  w.body[kNeedle].object = kNeedleObject;
  w.body[kNeedle].mass = s.mass();
  for (int i = 0; i < 3; ++i) w.body[kNeedle].inertia[i] = s.moments()[i] * u * u;
  w.body[kUpper].motion = w.body[kLower].motion = SWAGE_MOTION_FOLLOWS;
  if (s.upper_driven) {
    w.body[kUpper].motion = SWAGE_MOTION_HINGED;
    w.body[kUpper].hinge = 0;
    scene::HingeInfo hinge;
    hinge.object = kJawsObject, hinge.parent = kBase, hinge.child = kUpper;
    hinge.axis = {0, 1, 0};  // closing turns the upper jaw about +y
    hinge.X_PC0 = Pose{}.abi();
    hinge.inertia = s.jaw_mass * Jaw::kGrip * Jaw::kGrip * u * u;
    hinge.min = -1, hinge.max = 1;
    w.hinge.push_back(hinge);
  }
  w.shape.push_back(moving_shape(s));
  if (s.ball_radius > 0) {
    w.shape.push_back(fixed_shape(w, kBase, jaw_plate(10 * s.ball_radius), u));
  } else if (s.jaws) {
    w.shape.push_back(fixed_shape(w, kUpper, jaw(1), u));
    w.shape.push_back(fixed_shape(w, kLower, jaw(-1), u));
  }
  scene::reset(w);
  return w;
}

}  // namespace swage::bench
