// SPDX-License-Identifier: Apache-2.0
//
// A ball over a plate: what the reference problems of contact need. SI units, the plate's top in z = 0. [main]
#pragma once

#include <gtest/gtest.h>

#include <vector>

#include "contact/detector.hpp"
#include "dynamics/dynamics.hpp"
#include "scene/kinematics.hpp"

namespace swage::physics {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

constexpr double kGravity = 9.81;  // m/s2

/// Ball: body 0 of object 0. Plate: body 1 of object 1, moved by hand; `ceiling` [m]: where a second plate of it begins.
class BallOverPlate {
 public:
  BallOverPlate(double radius, const contact::Law& law, double ceiling = 0, const dynamics::Options& options = {})
      : world(make(radius, ceiling)), detector_(world, {contact::Pair{0, 1, law}}, {}), dynamics(world, options) {
    detector_.reserve(contacts);
  }

  void step() {
    dynamics.free_motion(world);
    detector_.detect(world, contacts);
    dynamics.solve(world, contacts, {}, {}, &detector_);
    dynamics.finish(world);
    ++world.step;
  }
  /// Of the ball's lowest point above the plate [m].
  double height() const { return world.X_WB[0].p.z - world.shape[0].radius; }
  double energy() const {
    const Vec3 v = toolkit::vec(world.V_WB[0].v), w = toolkit::vec(world.V_WB[0].w);
    return world.body[0].mass * (0.5 * v.squaredNorm() + kGravity * height()) +
           0.5 * world.body[0].inertia[0] * w.squaredNorm();
  }

 private:
  static scene::World make(double radius, double ceiling) {
    scene::World w;
    w.length = 1e-3, w.dt = 1e-3;
    w.gravity = {0, 0, -kGravity};
    w.body.resize(2);
    for (auto& b : w.body) b.start = Pose{}.abi();
    w.body[0].motion = SWAGE_MOTION_DYNAMIC;
    w.body[0].object = 0;
    w.body[0].mass = 4.0 / 3 * 3.14159265358979 * 7900 * radius * radius * radius;
    for (double& I : w.body[0].inertia) I = 0.4 * w.body[0].mass * radius * radius;
    w.body[1].motion = SWAGE_MOTION_FOLLOWS;
    w.body[1].object = 1;

    scene::Shape ball;
    ball.kind = SWAGE_SHAPE_SPHERE;
    ball.body = ball.object = 0;
    ball.X_BS = Pose{}.abi();
    ball.radius = ball.bounding_radius = radius;
    scene::Shape plate = ball;
    plate.kind = SWAGE_SHAPE_CONVEX;
    plate.body = plate.object = 1;
    plate.radius = 0;
    plate.convex = 0;
    plate.bounding_radius = 0.2;
    std::vector<Vec3> vertex;
    for (const double z : {-1e-3, 0.0})
      for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        vertex.push_back({0.1 * x, 0.1 * y, z});
    const std::vector<uint32_t> start{0, 4, 8, 12, 16, 20, 24};
    const std::vector<uint32_t> index{3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
    w.convex.resize(1);
    EXPECT_EQ(toolkit::build_convex(vertex, start, index, w.convex[0]), "");
    w.shape = {ball, plate};
    if (ceiling > 0) {
      plate.X_BS = Pose(Vec3(0, 0, ceiling + 1e-3), Quat::Identity()).abi();
      w.shape.push_back(plate);
    }
    scene::reset(w);
    return w;
  }

 public:
  scene::World world;
  contact::ContactSet contacts;

 private:
  contact::Detector detector_;

 public:
  dynamics::Dynamics dynamics;
};

}  // namespace swage::physics
