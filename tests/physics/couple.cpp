// SPDX-License-Identifier: Apache-2.0
//
// A light curved needle lies flat in a pinch, and a couple about the normal of the faces grows beyond what their friction bears,
// mu N b / 2 (pinch.cpp). In a step of 1 ms what is left of the couple would turn so light a body many times round: the needle slides
// as soon as the limit is passed, and is not held back step by step by a solve that does not converge.
#include <algorithm>
#include <cmath>

#include "scene.hpp"

namespace swage::physics {
namespace {

constexpr double kForce = 1, kFriction = 0.3, kWidth = 0.5e-3, kStiffness = 1e6;  // N, 1, m, N/m
constexpr double kLength = 2.6e-3;                                                // m, of the wire

/// A plate 2 mm along x, kWidth along y, from z = 0 to `thick`.
scene::Shape plate(scene::World& w, uint32_t body, double thick) {
  scene::Shape s;
  s.kind = SWAGE_SHAPE_CONVEX;
  s.body = body, s.object = 1;
  s.X_BS = Pose{}.abi();
  s.convex = static_cast<uint32_t>(w.convex.size());
  s.bounding_radius = 2e-3;
  std::vector<Vec3> vertex;
  for (const double z : {std::min(0.0, thick), std::max(0.0, thick)})
    for (const auto& [x, y] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
      vertex.push_back({1e-3 * x, 0.5 * kWidth * y, z});
  const std::vector<uint32_t> start{0, 4, 8, 12, 16, 20, 24};
  const std::vector<uint32_t> index{3, 2, 1, 0, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
  w.convex.emplace_back();
  EXPECT_EQ(toolkit::build_convex(vertex, start, index, w.convex.back()), "");
  return s;
}

/// A needle of a share of a circle between two faces that overlap it by N / k; the middle of its wire is in the origin.
scene::World pinched(double radius, double share) {
  scene::World w;
  w.length = 1e-3, w.dt = 1e-3;
  w.body.resize(3);
  for (auto& b : w.body) b.start = Pose{}.abi(), b.object = 1, b.motion = SWAGE_MOTION_FIXED;
  const double sweep = 2 * M_PI * share, R = kLength / sweep, m = 7900 * M_PI * radius * radius * kLength;
  const double centre = R * std::sin(0.5 * sweep) / (0.5 * sweep), tilt = std::sin(sweep) / sweep;
  scene::BodyInfo& needle = w.body[0];
  needle.motion = SWAGE_MOTION_DYNAMIC, needle.object = 0, needle.mass = m;
  needle.inertia[0] = 0.5 * m * R * R * (1 - tilt) + 0.5 * m * radius * radius;
  needle.inertia[1] = 0.5 * m * R * R * (1 + tilt) - m * centre * centre + 0.25 * m * radius * radius;
  needle.inertia[2] = m * (R * R - centre * centre);
  needle.start = Pose(Vec3(centre - R, 0, 0), Quat::Identity()).abi();
  const double apart = radius - kForce / kStiffness;
  w.body[1].start.p.z = -apart, w.body[2].start.p.z = apart;
  scene::Shape wire;
  wire.kind = SWAGE_SHAPE_ARC;
  wire.body = wire.object = 0;
  wire.X_BS = Pose(Vec3(-centre, 0, 0), toolkit::exp_rotation({0, 0, -0.5 * sweep})).abi();
  wire.radius = radius, wire.arc_radius = R, wire.sweep = sweep, wire.bounding_radius = R + radius;
  w.shape = {wire, plate(w, 1, -0.3e-3), plate(w, 2, 0.3e-3)};
  scene::reset(w);
  return w;
}

struct Outcome {
  double turned = 0;           // rad
  uint64_t not_converged = 0;  // steps
};

/// Under a couple that grows to so many times the limit in 0.2 s and stays for 0.2 s.
Outcome wring(double radius, double share, double times) {
  scene::World w = pinched(radius, share);
  contact::ContactSet contacts;
  contact::Detector detector(w, {contact::Pair{0, 1, {kFriction, kStiffness, 0}}}, {});
  dynamics::Dynamics dynamics(w, {});
  detector.reserve(contacts);
  Outcome out;
  for (int i = -100; i < 400; ++i) {
    const double couple = std::clamp(i / 200.0, 0.0, 1.0) * times * 0.5 * kFriction * kForce * kWidth;
    w.F_B_W[0] = {{0, 0, 0}, {0, 0, couple}};
    dynamics.free_motion(w);
    detector.detect(w, contacts);
    dynamics.solve(w, contacts, {});
    dynamics.finish(w);
    ++w.step;
    const double turned = toolkit::log_rotation(Pose(w.X_WB[0]).q).norm();
    out.turned = std::max(out.turned, turned);
  }
  out.not_converged = dynamics.stats().health.not_converged;
  return out;
}

TEST(Couple, BeyondFrictionTurnsALightNeedleAtOnce) {
  for (const double radius : {25e-6, 50e-6})
    for (const double share : {0.25, 0.375, 0.5}) {
      EXPECT_LT(wring(radius, share, 0.9).turned, 0.02) << radius << " " << share;
      for (const double times : {1.05, 1.5, 3.0}) {
        const Outcome slid = wring(radius, share, times);
        EXPECT_GT(slid.turned, 0.5) << radius << " " << share << " " << times;
        EXPECT_LT(slid.not_converged, 25u) << radius << " " << share << " " << times;
      }
    }
}

}  // namespace
}  // namespace swage::physics
