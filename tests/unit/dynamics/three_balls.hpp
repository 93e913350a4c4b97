// SPDX-License-Identifier: Apache-2.0
//
// A ball between two others, one below and one above it: the scene of tests of flexible bodies.
#pragma once

#include "scene/kinematics.hpp"
#include "toolkit/math.hpp"

namespace swage::dynamics {

/// Ball 0 of object 0 at the origin, fixed balls 1 and 2 of object 1 so far below and above it [m]; no gravity. Not reset yet.
inline scene::World three_balls(double radius, double gap_below, double gap_above) {
  scene::World w;
  w.gravity = {0, 0, 0};
  w.body.resize(3);
  const double z[] = {0, -2 * radius - gap_below, 2 * radius + gap_above};
  for (uint32_t i = 0; i < 3; ++i) {
    w.body[i].start = toolkit::Pose(toolkit::Vec3(0, 0, z[i]), toolkit::Quat::Identity()).abi();
    w.body[i].object = i == 0 ? 0 : 1;
    scene::Shape shape;
    shape.body = i, shape.object = w.body[i].object;
    shape.X_BS = toolkit::Pose{}.abi();
    shape.radius = shape.bounding_radius = radius;
    w.shape.push_back(shape);
  }
  return w;
}

}  // namespace swage::dynamics
