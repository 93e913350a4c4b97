// SPDX-License-Identifier: Apache-2.0
//
// Newton's restitution: a ball dropped from the height H meets the plate at v = sqrt(2 g H) after T = sqrt(2 H / g), leaves with
// e v, rises to e^2 H and is back after 2 e T; the bounces last T (1 + e) / (1 - e) altogether. From 1 mm: 0.1401 m/s after
// 14.278 ms; e = 0.5 gives 0.250 mm, 0.9 gives 0.810 mm.
#include <cmath>

#include "scene.hpp"

namespace swage::physics {
namespace rebound_test {

constexpr double kRadius = 50e-6;  // m
constexpr double kHeight = 1e-3;   // m

struct Dropped : BallOverPlate {
  Dropped(double restitution, double height) : BallOverPlate(kRadius, {0.3, 1e6, restitution}) {
    world.X_WB[0].p.z = kRadius + height;
  }
};

// the height of a flight from any point of it: z + v^2 / 2 g; so the steps' phase does not matter
double summit(const BallOverPlate& s) {
  const double v = s.world.V_WB[0].v.z;
  return s.height() + v * v / (2 * kGravity);
}

TEST(Rebound, RisesToESquaredH) {
  for (const double e : {0.5, 0.9, 1.0})
    for (int phase = 0; phase < 16; ++phase) {
      const double height = kHeight * (1 + 0.02 * phase / 16);
      Dropped s(e, height);
      while (s.world.V_WB[0].v.z <= 0 && s.world.step < 100) s.step();
      EXPECT_NEAR(summit(s) / (e * e * height), 1, 1e-6) << e << " " << phase;
      EXPECT_NEAR(static_cast<double>(s.world.step), std::ceil(14.278 * std::sqrt(height / kHeight)), 1)
          << phase;
    }
}

TEST(Rebound, NeverGainsEnergy) {
  for (const double e : {0.3, 0.9, 1.0}) {
    Dropped s(e, kHeight);
    s.world.V_WB[0] = {{0.05, 0, 0}, {10, -400, 30}};  // thrown, spinning
    double before = s.energy();
    for (int i = 0; i < 400; ++i) {
      s.step();
      // once it rolls, the bristle of the contact takes and gives back a millionth
      EXPECT_LE(s.energy(), before * (1 + 1e-5)) << e << " " << i;
      if (s.height() > 1e-6) {
        EXPECT_LE(s.energy(), before * (1 + 1e-9)) << e << " " << i;
      }
      before = s.energy();
    }
  }
}

// infinitely many bounces in finite time: afterwards it lies still
TEST(Rebound, ComesToRest) {
  const double e = 0.9, T = std::sqrt(2 * kHeight / kGravity), rest = T * (1 + e) / (1 - e);
  Dropped s(e, kHeight);
  while (s.world.time() < rest + 0.02) s.step();
  for (int i = 0; i < 100; ++i) {
    s.step();
    EXPECT_LT(std::abs(s.height()), 1e-9);
    EXPECT_LT(std::abs(s.world.V_WB[0].v.z), 1e-6);
  }
}

// a plate that comes up at u gives 2 u to what is elastic and at rest
TEST(Rebound, CountsFromTheMovingSurface) {
  BallOverPlate s(kRadius, {0.0, 1e6, 1.0});
  s.world.gravity = {0, 0, 0};
  s.world.X_WB[0].p.z = kRadius + 0.35e-3;
  for (int i = 1; i <= 8; ++i) {
    scene::follow(s.world, 1, Pose(Vec3(0, 0, 0.1e-3 * i), Quat::Identity()));
    s.step();
  }
  EXPECT_NEAR(s.world.V_WB[0].v.z, 0.2, 1e-9);
}

// without restitution nothing comes back: the check above can fail
TEST(Rebound, NoneWithoutRestitution) {
  Dropped s(0, kHeight);
  for (int i = 0; i < 60; ++i) {
    s.step();
    EXPECT_LT(s.world.V_WB[0].v.z, 1e-4);
  }
  EXPECT_LT(std::abs(s.height()), 1e-9);
}

// between plates 4 um farther apart than it is thick, an elastic ball of 1 m/s touches 250 times in a millisecond: that is more than a
// step looks for, and said
TEST(Rebound, WhatTouchesTooOftenIsCounted) {
  BallOverPlate s(kRadius, {0.0, 1e6, 1.0}, 2 * kRadius + 4e-6);
  s.world.gravity = {0, 0, 0};
  s.world.X_WB[0].p.z = kRadius + 1e-6;
  s.world.V_WB[0].v.z = 1;
  for (uint64_t i = 1; i <= 5; ++i) {
    s.step();
    EXPECT_EQ(s.dynamics.stats().health.over_budget, i);
    EXPECT_EQ(s.dynamics.stats().health.steps, i);
    EXPECT_GT(s.height(), -5e-6);
    EXPECT_LT(s.height(), 9e-6);
  }
}

// In a soft plate, a ball is under the surface by more than its radius and flies out. A sweep that takes it for thinner by what it has
// sunk in finds it still overlapping, and each look ends where it began.
TEST(Rebound, LeavesASoftPlateThatItIsDeepIn) {
  for (const double e : {0.0, 0.5})
    for (const double speed : {0.06, 0.126, 0.5}) {
      BallOverPlate s(kRadius, {0.3, 100, e});
      s.world.gravity = {0, 0, 0};
      s.world.X_WB[0].p.z = kRadius - 164e-6;
      s.world.V_WB[0].v.z = speed;
      double before = s.height();
      for (int i = 0; i < 4; ++i) {
        s.step();
        EXPECT_GT(s.height(), before + 0.9e-3 * speed) << e << ", " << speed << " m/s, step " << i;
        before = s.height();
      }
      EXPECT_GT(s.height(), 0) << e << ", " << speed;
      EXPECT_EQ(s.dynamics.stats().health.over_budget, 0u) << e << ", " << speed;
    }
}

}  // namespace rebound_test
}  // namespace swage::physics
