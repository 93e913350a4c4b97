// SPDX-License-Identifier: Apache-2.0
//
// The rod in motion: damping of the method, order in time, sinking in water, what it keeps.
#include <gtest/gtest.h>

#include "rod.hpp"

namespace swage::toolkit {
namespace {

constexpr double kPi = std::numbers::pi;

/// Damping [1/s] and period [s] of a cantilever of 20 mm that was bent a little by its first mode and let go.
struct Swing {
  double period = 0, decay = 0;
};
Swing swing(int n, double h, bool second) {
  const RodSection section = nylon();
  constexpr double L = 20e-3;
  TestRod t(section, n, L);
  t.clamp_start(Vec3::UnitX(), Vec3::UnitY());
  RodLoad load;
  std::vector<double> force(static_cast<size_t>(3 * n + 3), 0.0);
  for (int i = 0; i <= n; ++i)
    force[static_cast<size_t>(3 * i + 2)] = 1e-9 * std::pow(static_cast<double>(i) / n, 2) / n;
  load.force = force;
  t.settle(load);
  std::fill_n(t.s.v, 3 * n + 3, 0.0);
  *t.s.steps = 0;
  load.force = {};
  load.h = h;
  load.second_order = second;
  // crossings and peaks of the tip
  double before = t.tip().z(), slope = 0, first_crossing = 0, last_crossing = 0, first_peak = 0,
         last_peak = 0, first_time = 0, last_time = 0;
  int crossings = 0;
  for (int k = 1; k * h < 0.5; ++k) {
    t.rod.step(t.s, load, 8, 1e-14);
    const double z = t.tip().z();
    if ((z > 0) != (before > 0)) {
      const double time = (k - z / (z - before)) * h;
      if (crossings++ == 0) first_crossing = time;
      last_crossing = time;
    }
    if (crossings > 0 && slope * (z - before) < 0) {
      if (first_peak == 0) first_peak = std::abs(before), first_time = k * h;
      last_peak = std::abs(before), last_time = k * h;
    }
    slope = z - before, before = z;
  }
  return {2 * (last_crossing - first_crossing) / (crossings - 1),
          std::log(first_peak / last_peak) / (last_time - first_time)};
}

TEST(Rod, SwingsInItsFirstMode) {
  const RodSection section = nylon();
  const double omega = std::pow(1.875104 / 20e-3, 2) * std::sqrt(section.bending / section.mass);
  const Swing euler = swing(25, 0.5e-3, false);
  EXPECT_NEAR(euler.period, 2 * kPi / omega, 0.01 * euler.period);
  EXPECT_NEAR(euler.decay, 0.5 * omega * omega * 0.5e-3, 0.1 * euler.decay);  // theory of backward Euler
  const Swing second = swing(25, 0.5e-3, true);
  EXPECT_NEAR(second.period, 2 * kPi / omega, 0.01 * second.period);
  EXPECT_LT(second.decay, 0.06 * euler.decay);
}

/// A thread that swings from one end: energy falls, never rises, whatever the step.
TEST(Rod, NeverGainsEnergy) {
  for (const double h : {0.25e-3, 1e-3, 4e-3}) {
    TestRod t(nylon(), 50, 50e-3);
    t.rod.hold(0);
    RodLoad load;
    load.gravity = {0, 0, -kGravity};
    load.h = h;
    double before = HUGE_VAL;
    for (int k = 0; k * h < 0.4; ++k) {
      const RodEffort effort = t.rod.step(t.s, load, 20, 1e-11);
      ASSERT_TRUE(effort.settled) << h << " " << k;
      double E = t.rod.energy(t.s);
      for (int i = 0; i < t.rod.nodes(); ++i)
        E += t.rod.node_mass(i) * (0.5 * t.s.velocity(i).squaredNorm() + kGravity * t.s.node(i).z());
      EXPECT_LT(E, before + 1e-16) << h << " " << k;
      before = E;
    }
    // its own weight stretches it by 1e-7
    double length = 0;
    for (int j = 0; j < 50; ++j) length += t.s.edge(j).norm();
    EXPECT_NEAR(length, 50e-3, 1e-6 * 50e-3);
  }
}

/// A single edge that swings as a pendulum from the horizontal, 0.2 s long, at steps that are halved.
TEST(Rod, MovesToFirstAndToSecondOrder) {
  const auto end = [](double h, bool second) {
    TestRod t(nylon(), 1, 20e-3);
    t.rod.hold(0);
    RodLoad load;
    load.gravity = {0, 0, -kGravity};
    load.h = h, load.second_order = second;
    for (int k = 0; k < std::lround(0.2 / h); ++k) t.rod.step(t.s, load, 12, 1e-14);
    return t.tip();
  };
  for (const bool second : {false, true}) {
    const Vec3 a = end(0.4e-3, second), b = end(0.2e-3, second), c = end(0.1e-3, second);
    EXPECT_NEAR(std::log2((a - b).norm() / (b - c).norm()), second ? 2 : 1, 0.15) << (a - b).norm();
  }
}

TEST(Rod, KeepsItsMomentum) {
  TestRod t(nylon(), 30, 10e-3, Vec3::Zero(), Vec3::UnitX(), 60);
  Vec3 before = Vec3::Zero();
  for (int i = 0; i <= 30; ++i) {
    Eigen::Map<Vec3>(t.s.v + 3 * i) = Vec3(0.03, 0.02 * std::cos(0.2 * i), 0.05 * i / 30);
    before += t.rod.node_mass(i) * t.s.velocity(i);
  }
  RodLoad load;
  load.h = 1e-3;
  for (int k = 0; k < 200; ++k) EXPECT_TRUE(t.rod.step(t.s, load, 20, 1e-12).settled) << k;
  Vec3 after = Vec3::Zero();
  for (int i = 0; i <= 30; ++i) after += t.rod.node_mass(i) * t.s.velocity(i);
  EXPECT_LT((after - before).norm(), 1e-8 * before.norm());
}

/// Nodes thrown about by 0.3 of an edge in the first step, in every direction: energy and speed fall, and it comes to rest.
TEST(Rod, ComesThroughAKnock) {
  TestRod t(nylon(), 30, 10e-3, Vec3::Zero(), Vec3::UnitX(), 60);
  for (int i = 0; i <= 30; ++i)
    Eigen::Map<Vec3>(t.s.v + 3 * i) = Vec3(0.1 * std::sin(i), 0.1 * std::cos(2.0 * i), 0.05 * i / 30);
  double before = 0;
  for (int i = 0; i <= 30; ++i) before += 0.5 * t.rod.node_mass(i) * t.s.velocity(i).squaredNorm();
  RodLoad load;
  load.h = 1e-3;
  for (int k = 0; k < 100; ++k) t.rod.step(t.s, load, 50, 1e-12);
  double after = t.rod.energy(t.s);
  for (int i = 0; i <= 30; ++i) after += 0.5 * t.rod.node_mass(i) * t.s.velocity(i).squaredNorm();
  EXPECT_LT(after, 0.1 * before);
  EXPECT_TRUE(t.rod.step(t.s, load, 4, 1e-10).settled);
}

/// In water a horizontal thread sinks at 0.29 mm/s: its weight less that of the water over Lamb's drag.
TEST(Rod, SinksInWater) {
  TestRod t(nylon(), 20, 10e-3);
  RodLoad load;
  load.h = 1e-3, load.gravity = {0, 0, -kGravity}, load.fluid = {1000, 1e-3};
  for (int k = 0; k < 100; ++k) t.rod.step(t.s, load, 4, 1e-13);
  const double speed = -t.s.velocity(10).z();
  EXPECT_NEAR(speed, 0.29e-3, 0.02 * 0.29e-3);
  const double weight = (nylon().mass - 1000 * kPi * 121e-12) * kGravity;
  EXPECT_NEAR(speed * rod_drag(load.fluid, 22e-6, speed), weight, 1e-3 * weight);
}

/// Terminal speeds of a falling thread in air, 25 um, and what joins the two laws of drag.
TEST(Rod, FallsInAir) {
  const RodSection thick = RodSection::round(25e-6, 2.5e9, 0.39, 1140);
  const RodFluid air = {1.2, 1.8e-5};
  const double rate[][2] = {{0.01, 66.7}, {0.1, 107}, {0.5, 190}};
  for (const auto& [speed, expected] : rate)
    EXPECT_NEAR(rod_drag(air, 25e-6, speed) / thick.mass, expected, 0.06 * expected) << speed;
  const double joined = 0.7 * 1.8e-5 / (1.2 * 25e-6);
  EXPECT_NEAR(rod_drag(air, 25e-6, 0.9999 * joined), rod_drag(air, 25e-6, 1.0001 * joined),
              0.01 * rod_drag(air, 25e-6, joined));
}

}  // namespace
}  // namespace swage::toolkit
