// SPDX-License-Identifier: Apache-2.0
#include "session/force_guard.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/rng.hpp"

namespace swage::session {
namespace force_guard_test {

constexpr double kDt = 1e-3;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

double size(const swage_vec3& f) { return std::sqrt(f.x * f.x + f.y * f.y + f.z * f.z); }
double distance(const swage_vec3& a, const swage_vec3& b) { return size({a.x - b.x, a.y - b.y, a.z - b.z}); }

ForceRequest push(double fx, double age = 0) {
  ForceRequest r;
  r.force = {fx, 0, 0};
  r.age = age;
  return r;
}

// an armed guard that has faded in under a constant request
void fade_in(ForceGuard& guard, double fx = 0) {
  guard.arm();
  for (int i = 0; i < 600; ++i) guard.tick(push(fx), {}, kDt, i * kDt);
}

TEST(ForceGuard, GivesNothingUntilArmed) {
  ForceGuard guard;
  EXPECT_EQ(size(guard.tick(push(1), {}, kDt, 0).force), 0);
  guard.arm();
  guard.tick(push(1), {}, kDt, 0);
  EXPECT_GT(size(guard.tick(push(1), {}, kDt, 0).force), 0);
}

TEST(ForceGuard, FadesInOverHalfASecond) {
  ForceGuard guard;
  guard.arm();
  double last = 0;
  for (int i = 1; i <= 500; ++i) {
    const double f = guard.tick(push(1), {}, kDt, i * kDt).force.x;
    EXPECT_NEAR(f, i / 500.0, 1e-9);
    EXPECT_GE(f, last);
    last = f;
  }
  EXPECT_NEAR(guard.tick(push(1), {}, kDt, 0).force.x, 1.0, 1e-12);
}

TEST(ForceGuard, KeepsTheDirectionWhenItLimitsTheMagnitude) {
  ForceGuard guard;
  fade_in(guard);
  ForceRequest r;
  r.force = {6, 8, 0};
  swage_command c{};
  for (int i = 0; i < 50; ++i) c = guard.tick(r, {}, kDt, 0);
  EXPECT_NEAR(size(c.force), 3.0, 1e-12);
  EXPECT_NEAR(c.force.y / c.force.x, 8.0 / 6.0, 1e-12);
}

TEST(ForceGuard, SlewsToAJump) {
  ForceGuard guard;
  fade_in(guard);
  swage_vec3 last{};
  for (int i = 0; i < 20; ++i) {
    const swage_command c = guard.tick(push(3), {}, kDt, 0);
    EXPECT_LE(distance(c.force, last), 300 * kDt + 1e-12);
    last = c.force;
  }
  EXPECT_NEAR(last.x, 3.0, 1e-12);  // full scale within 10 ms
}

// 3 N heat the motors: u = 9 (1 - exp(-t/10 s)) passes 1.75^2 after 4.16 s
TEST(ForceGuard, LimitsWhatTheMotorsBear) {
  ForceGuard guard;
  fade_in(guard);
  const double heated = -10.0 * std::log(1 - 1.75 * 1.75 / 9.0);
  int hot = 0;
  for (int i = 0; i < 20000; ++i) {
    const double f = guard.tick(push(3), {}, kDt, 0).force.x;
    if (f < 2.9 && i > 20) {
      hot = i;
      break;
    }
  }
  EXPECT_NEAR(hot * kDt, heated, 0.05);
  for (int i = 0; i < 100; ++i) guard.tick(push(3), {}, kDt, 0);
  EXPECT_NEAR(guard.tick(push(3), {}, kDt, 0).force.x, 1.75, 1e-9);
}

TEST(ForceGuard, OldRequestsReleaseAndFadeInAgain) {
  ForceGuard guard;
  fade_in(guard, 2);
  EXPECT_NEAR(guard.tick(push(2, 0.019), {}, kDt, 0).force.x, 2, 1e-12);  // young enough
  for (int i = 0; i < 7; ++i) guard.tick(push(2, 0.021), {}, kDt, 0);
  EXPECT_EQ(size(guard.tick(push(2, 0.021), {}, kDt, 0).force), 0);
  EXPECT_TRUE(guard.armed());
  EXPECT_LT(guard.tick(push(2), {}, kDt, 0).force.x, 0.01);  // from zero again
}

TEST(ForceGuard, OldSamplesReleaseToo) {
  ForceGuard guard;
  fade_in(guard, 1);
  HandMotion hand;
  hand.age = 0.05;
  for (int i = 0; i < 10; ++i) guard.tick(push(1), hand, kDt, 0);
  EXPECT_EQ(size(guard.tick(push(1), hand, kDt, 0).force), 0);
}

TEST(ForceGuard, LongSilenceDisarms) {
  ForceGuard guard;
  fade_in(guard, 1);
  EXPECT_EQ(size(guard.tick(push(1, 0.3), {}, kDt, 0).force), 0);
  EXPECT_EQ(guard.fault(), ForceFault::kLost);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(size(guard.tick(push(1), {}, kDt, 0).force), 0);
  guard.arm();
  EXPECT_EQ(guard.fault(), ForceFault::kNone);
}

TEST(ForceGuard, WhatIsNotANumberDisarmsAtOnce) {
  for (int which = 0; which < 5; ++which) {
    ForceGuard guard;
    fade_in(guard, 1);
    ForceRequest r = push(1);
    HandMotion hand;
    if (which == 0) r.force.y = kNaN;
    if (which == 1) r.stiffness = std::numeric_limits<double>::infinity();
    if (which == 2) r.anchor.p.z = kNaN;
    if (which == 3) hand.p.x = -std::numeric_limits<double>::infinity();
    if (which == 4) r.age = kNaN;
    EXPECT_EQ(size(guard.tick(r, hand, kDt, 0).force), 0) << which;
    EXPECT_FALSE(guard.armed()) << which;
    EXPECT_EQ(guard.fault(), which == 4 ? ForceFault::kLost : ForceFault::kNotFinite);
  }
}

TEST(ForceGuard, AHandTooFastDisarmsAfterThreeTicks) {
  ForceGuard guard;
  fade_in(guard, 1);
  HandMotion hand;
  hand.has_velocity = true;
  hand.v.x = 1.5;
  guard.tick(push(1), hand, kDt, 0);
  guard.tick(push(1), hand, kDt, 0);
  EXPECT_TRUE(guard.armed());
  EXPECT_EQ(size(guard.tick(push(1), hand, kDt, 0).force), 0);
  EXPECT_EQ(guard.fault(), ForceFault::kTooFast);
}

TEST(ForceGuard, BoundsTheCouplingForServos) {
  ForceGuard guard;
  fade_in(guard);
  ForceRequest r;
  r.stiffness = 5000;
  r.damping = 100;
  r.anchor.p.x = 1e-3;
  swage_command c{};
  for (int i = 0; i < 20; ++i) c = guard.tick(r, {}, kDt, 1.0);
  EXPECT_EQ(c.stiffness, 1000);
  EXPECT_EQ(c.damping, 5);
  EXPECT_NEAR(c.force.x, 1.0, 1e-12);
  EXPECT_NEAR(c.deadline_s, 1.020, 1e-12);
  r.age = 0.05;
  c = guard.tick(r, {}, kDt, 1.0);
  EXPECT_EQ(c.stiffness, 0);
  EXPECT_LE(c.deadline_s, 1.0);
}

// whatever comes in: finite, within the magnitude, within the slew unless zero at once
TEST(ForceGuard, HoldsItsBoundsAgainstNoise) {
  base::Xoshiro256 random(2026);
  ForceGuard guard;
  guard.arm();
  swage_vec3 last{};
  int given = 0;
  for (int i = 0; i < 200000; ++i) {
    auto wild = [&] { return (random.uniform() - 0.5) * std::exp(random.uniform(-5, 5)); };
    ForceRequest r;
    r.force = {wild(), wild(), wild()};
    r.anchor.p = {wild() * 1e-3, wild() * 1e-3, wild() * 1e-3};
    r.stiffness = wild() * 1e3;
    r.damping = wild();
    if (random.uniform() < 1e-4) r.force.x = kNaN;
    HandMotion hand;
    hand.p = {0.1 * std::sin(i * 1e-3), wild() * 1e-5, 0};
    hand.age = random.uniform() < 0.01 ? 0.03 : 0;
    const swage_command c = guard.tick(r, hand, kDt, i * kDt);
    ASSERT_TRUE(std::isfinite(c.force.x) && std::isfinite(c.force.y) && std::isfinite(c.force.z));
    ASSERT_LE(size(c.force), 3.0 + 1e-9);
    if (guard.armed()) {
      ASSERT_LE(distance(c.force, last), 0.3 + 1e-9);
      given += size(c.force) > 0.1;
    } else {
      ASSERT_EQ(size(c.force), 0);
      guard.arm();
    }
    last = c.force;
  }
  EXPECT_GT(given, 1000);
}

// A model of arm and hand: 45 g at the tip, light grip of 100 N/m and 0.5 N s/m pressing 10 mm into a wall,
// encoder steps of 23 um, the force held over the period and computed from the position one period ago.
// Returns the ripple of the last second in m.
double wall_ripple(double wall_stiffness, double max_dissipation) {
  ForceLimits limits;
  limits.max_force = 100;
  limits.continuous_force = 100;
  limits.slew = 1e6;
  limits.max_speed = 100;
  limits.max_dissipation = max_dissipation;
  ForceGuard guard(limits);
  guard.arm();
  double x = -0.005, v = 0, wall = 0, low = 1, high = -1;
  for (int tick = 0; tick < 4000; ++tick) {
    const double measured = std::floor(x / 23e-6) * 23e-6;
    HandMotion hand;
    hand.p.x = measured;
    const double held = guard.tick(push(wall), hand, kDt, tick * kDt).force.x;
    wall = measured > 0 ? -wall_stiffness * measured : 0;
    for (int sub = 0; sub < 20; ++sub) {
      const double friction = 0.06 * std::tanh(v / 1e-4);
      const double f = held + 100 * (0.01 - x) - 0.5 * v - friction;
      v += f / 0.045 * kDt / 20;
      x += v * kDt / 20;
    }
    if (tick >= 3000) {
      low = std::min(low, x);
      high = std::max(high, x);
    }
  }
  return high - low;
}

// the stiffness lies between what the bare loop bears and what passivity control bears
TEST(ForceGuard, PassivityControlCalmsAWallThatRingsWithoutIt) {
  EXPECT_LT(wall_ripple(600, 0), 100e-6);
  EXPECT_GT(wall_ripple(1500, 0), 100e-6);
  EXPECT_LT(wall_ripple(1500, 8), 100e-6);
  EXPECT_GT(wall_ripple(5000, 8), 100e-6);  // and it is no miracle either
}

TEST(ForceGuard, EnergyIsForgottenOutOfContactAndCounted) {
  ForceGuard guard;
  fade_in(guard, 1);
  HandMotion hand;
  for (int i = 0; i < 100; ++i) {  // the force does work on the hand: 1 N over 5 mm
    hand.p.x += 5e-5;
    guard.tick(push(1), hand, kDt, 0);
  }
  EXPECT_LT(guard.energy(), 0);
  EXPECT_GT(guard.dissipated(), 0);
  for (int i = 0; i < 20; ++i) guard.tick(push(0), hand, kDt, 0);
  EXPECT_EQ(guard.energy(), 0);
}

}  // namespace force_guard_test
}  // namespace swage::session
