// SPDX-License-Identifier: Apache-2.0
#include "couple.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

#include "contact/detector.hpp"
#include "dynamics/dynamics.hpp"
#include "scene/kinematics.hpp"

namespace swage::bench {
namespace {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

constexpr double kForce = 1, kFriction = 0.3, kWidth = 0.5e-3, kStiffness = 1e6;  // N, 1, m, N/m
constexpr double kLength = 2.6e-3;                                                // m, of the wire
constexpr double kLimit = 0.5 * kFriction * kForce * kWidth;                       // N m
constexpr double kSettle = 0.1, kGrow = 0.2, kStay = 0.2;                         // s

/// A plate 2 mm along x, kWidth along y, from z = 0 to `thick`.
scene::Shape plate_shape(scene::World& w, uint32_t body, double thick) {
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
  toolkit::build_convex(vertex, start, index, w.convex.back());
  return s;
}

/// A needle of a share of a circle between two faces that overlap it by N / k; the middle of its wire is in the origin.
scene::World pinched(const WringSetup& setup) {
  scene::World w;
  w.length = 1e-3, w.dt = setup.dt;
  w.body.resize(3);
  for (auto& b : w.body) b.start = Pose{}.abi(), b.object = 1, b.motion = SWAGE_MOTION_FIXED;
  const double r = setup.wire_radius, sweep = 2 * std::numbers::pi * setup.share, R = kLength / sweep;
  const double m = setup.density * std::numbers::pi * r * r * kLength;
  const double centre = R * std::sin(0.5 * sweep) / (0.5 * sweep), tilt = std::sin(sweep) / sweep;
  scene::BodyInfo& needle = w.body[0];
  needle.motion = SWAGE_MOTION_DYNAMIC, needle.object = 0, needle.mass = m;
  needle.inertia[0] = 0.5 * m * R * R * (1 - tilt) + 0.5 * m * r * r;
  needle.inertia[1] = 0.5 * m * R * R * (1 + tilt) - m * centre * centre + 0.25 * m * r * r;
  needle.inertia[2] = m * (R * R - centre * centre);
  needle.start = Pose(Vec3(centre - R, 0, 0), Quat::Identity()).abi();
  const double apart = r - kForce / kStiffness;
  w.body[1].start.p.z = -apart, w.body[2].start.p.z = apart;
  scene::Shape wire;
  wire.kind = SWAGE_SHAPE_ARC;
  wire.body = wire.object = 0;
  wire.X_BS = Pose(Vec3(-centre, 0, 0), toolkit::exp_rotation({0, 0, -0.5 * sweep})).abi();
  wire.radius = r, wire.arc_radius = R, wire.sweep = sweep, wire.bounding_radius = R + r;
  w.shape = {wire, plate_shape(w, 1, -0.3e-3), plate_shape(w, 2, 0.3e-3)};
  scene::reset(w);
  return w;
}

}  // namespace

double free_turn(const WringSetup& setup) {
  return kLimit * setup.dt * setup.dt / pinched(setup).body[0].inertia[2];
}

WringResult wring(const WringSetup& setup) {
  scene::World w = pinched(setup);
  contact::ContactSet contacts;
  contact::Detector detector(w, {contact::Pair{0, 1, {kFriction, kStiffness, 0}}}, {});
  dynamics::Options options;
  if (setup.impulse) options.response = dynamics::Response::kImpulse;
  dynamics::Dynamics dynamics(w, options);
  detector.reserve(contacts);
  WringResult out;
  const auto steps_in = [&](double time) { return static_cast<int>(std::lround(time / setup.dt)); };
  const int settle = steps_in(kSettle), steps = steps_in(kGrow + kStay);
  for (int i = -settle; i < steps; ++i) {
    const double couple = std::clamp(i * setup.dt / kGrow, 0.0, 1.0) * setup.times * kLimit;
    w.F_B_W[0] = {{0, 0, 0}, {0, 0, couple}};
    dynamics.free_motion(w);
    detector.detect(w, contacts);
    dynamics.solve(w, contacts, {}, {}, &detector);
    dynamics.finish(w);
    ++w.step;
    out.turned = std::max(out.turned, toolkit::log_rotation(Pose(w.X_WB[0]).q).norm());
  }
  out.steps = static_cast<uint64_t>(steps);
  out.not_converged = dynamics.stats().health.not_converged;
  return out;
}

}  // namespace swage::bench
