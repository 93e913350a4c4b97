// SPDX-License-Identifier: Apache-2.0
//
// The rod at rest against closed forms: elastica under its weight and under a force, catenary, bending with twist, buckling.
#include <gtest/gtest.h>

#include "rod.hpp"

namespace swage::toolkit {
namespace rod_statics_test {

constexpr double kPi = std::numbers::pi;

/// Distance of the tip of a horizontal thread from where the exact one hangs, over its length. G = rho A g L^3 / EI.
double heavy_elastica(double G, int n, double x, double drop) {
  const RodSection section = nylon();
  const double L = std::cbrt(G * section.bending / (section.mass * kGravity));
  TestRod t(section, n, L);
  t.clamp_start(Vec3::UnitX(), Vec3::UnitY());
  RodLoad load;
  load.gravity = {0, 0, -kGravity};
  EXPECT_TRUE(t.settle(load));
  return (t.tip() / L - Vec3(x, 0, -drop)).norm();
}

TEST(Rod, HangsAsAnElasticaUnderItsWeight) {
  EXPECT_NEAR(std::cbrt(nylon().bending / (nylon().mass * kGravity)), 18.910e-3, 5e-6);
  EXPECT_LT(heavy_elastica(1, 25, 0.991246, 0.123471), 1e-3);
  EXPECT_LT(heavy_elastica(1, 12, 0.991246, 0.123471), 1e-3);
  EXPECT_LT(heavy_elastica(10, 50, 0.656354, 0.700200), 1e-3);
  EXPECT_LT(heavy_elastica(50, 100, 0.245015, 0.907917), 1e-3);
  // order 2
  const double coarse = heavy_elastica(10, 80, 0.656354, 0.700200),
               fine = heavy_elastica(10, 160, 0.656354, 0.700200);
  EXPECT_NEAR(std::log2(coarse / fine), 2, 0.1) << coarse << " " << fine;
}

/// Edges alternate as 1 : 2.
TEST(Rod, HangsAsAnElasticaWithUnevenEdges) {
  const RodSection section = nylon();
  const double L = std::cbrt(section.bending / (section.mass * kGravity));
  std::vector<double> rest;
  for (int i = 0; i < 24; ++i) rest.push_back(L / 36 * (1 + i % 2));
  TestRod t(section, rest, Vec3::Zero(), Vec3::UnitX(), 0);
  t.clamp_start(Vec3::UnitX(), Vec3::UnitY());
  RodLoad load;
  load.gravity = {0, 0, -kGravity};
  EXPECT_TRUE(t.settle(load));
  EXPECT_LT((t.tip() / L - Vec3(0.991246, 0, -0.123471)).norm(), 1e-3);
}

TEST(Rod, BendsAsAnElasticaUnderAForceAtItsTip) {
  const double exact[][3] = {
      {0.2, 0.997353, 0.066364}, {1, 0.943567, 0.301721}, {5, 0.612372, 0.713792}, {10, 0.445004, 0.810609}};
  const RodSection section = nylon();
  const double L = 5e-3;
  for (const auto& [a, x, y] : exact) {
    TestRod t(section, 49, L);
    t.clamp_start(Vec3::UnitX(), Vec3::UnitZ());
    std::vector<double> force(150, 0.0);
    force[148] = a * section.bending / (L * L);
    RodLoad load;
    load.force = force;
    EXPECT_TRUE(t.settle(load));
    EXPECT_LT((t.tip() / L - Vec3(x, y, 0)).norm(), 4e-4) << a;
  }
}

TEST(Rod, HangsAsACatenaryWithoutBending) {
  RodSection section = nylon();
  section.bending = section.twisting = 0;
  constexpr double L = 50e-3, D = 30e-3, kA = 8.158414e-3, kSag = 18.139109e-3;
  for (const int n : {50, 100, 200}) {
    TestRod t(section, n, L);
    t.rod.hold(0), t.rod.hold(n);
    // without tension to begin with: two straight halves, 3 : 4 : 5
    for (int i = 0; i <= n; ++i) t.put(i, {D * i / n, 0, -40e-3 * std::min(i, n - i) / n});
    t.rod.start(t.s);
    RodLoad load;
    load.gravity = {0, 0, -kGravity};
    EXPECT_TRUE(t.settle(load));
    double worst = 0;
    for (int i = 0; i <= n; ++i) {
      const double s = L * (static_cast<double>(i) / n - 0.5), x = kA * std::asinh(s / kA);
      const double z = -kSag + std::sqrt(kA * kA + s * s) - kA;
      worst = std::max(worst, (t.s.node(i) - Vec3(0.5 * D + x, 0, z)).norm());
    }
    EXPECT_LT(worst / L, 0.3 / n / n * 4) << n;
    EXPECT_NEAR(t.rod.tension(t.s, 0), 0.525950 * section.mass * kGravity * L,
                0.02 * 0.525950 * section.mass * kGravity * L);
  }
}

/// A quarter circle, pushed at its end out of its plane: d = F R^3 (pi / (4 EI) + (3 pi / 4 - 2) / GJ), Castigliano.
TEST(Rod, BendsAndTwistsTogether) {
  const RodSection section = nylon();
  const double R = 4e-3, F = 1e-9 * section.bending / 2.875e-11;
  for (const int n : {20, 40}) {
    TestRod t(section, n, 0.5 * kPi * R, Vec3::Zero(), Vec3::UnitX(), 1 / R);
    // the circle to which it would bend, about the director z
    const double step = 0.5 * kPi / n, chord = 0.5 * kPi * R / n;
    Vec3 x = Vec3::Zero();
    for (int i = 1; i <= n; ++i) {
      const double angle = (i - 0.5) * step;
      x += chord * Vec3(std::cos(angle), std::sin(angle), 0);
      t.put(i, x);
    }
    t.clamp_start(Vec3::UnitX(), Vec3::UnitZ());
    EXPECT_LT(t.rod.energy(t.s), 1e-20);  // J; it is unloaded
    std::vector<double> force(static_cast<size_t>(3 * n + 3), 0.0);
    force.back() = F;
    RodLoad load;
    load.force = force;
    EXPECT_TRUE(t.settle(load));
    const double exact = F * R * R * R * (kPi / 4 / section.bending + (0.75 * kPi - 2) / section.twisting);
    EXPECT_NEAR(t.tip().z(), exact, 1.2 / n / n * 8 * exact) << n;
  }
}

/// The load under which a straight cantilever is no longer stable: pi^2 EI / (4 L^2).
TEST(Rod, BucklesAsEulerSays) {
  const RodSection section = nylon();
  const double L = 5e-3, exact = kPi * kPi * section.bending / (4 * L * L);
  for (const int n : {10, 20, 40}) {
    double low = 0.5 * exact, high = 2 * exact;
    while (high - low > 1e-5 * exact) {
      const double P = 0.5 * (low + high);
      TestRod t(section, n, L);
      t.clamp_start(Vec3::UnitX(), Vec3::UnitY());
      t.rod.hold_turn(0);
      for (int i = 0; i <= n; ++i) t.put(i, Vec3(L * i / n * (1 - P / section.stretching), 0, 0));
      (t.rod.stable(t.s, {}) ? low : high) = P;
    }
    EXPECT_NEAR(low / exact, 1, 0.8 / n / n) << n;
  }
}

/// A closed ring whose ends are turned against each other: it leaves its plane at 2 pi sqrt 3 EI / GJ (Michell 1889).
TEST(Rod, RingBucklesAsMichellSays) {
  const RodSection section = nylon();
  const double exact = 2 * kPi * std::sqrt(3.0) * section.bending / section.twisting, R = 3e-3;
  EXPECT_NEAR(exact, 15.127, 1e-3);
  constexpr int n = 100;
  TestRod t(section, n, 2 * kPi * R);
  Vec3 x = Vec3::Zero();
  for (int i = 1; i <= n; ++i) {
    const double angle = (i - 0.5) * 2 * kPi / n;
    x += 2 * kPi * R / n * Vec3(std::cos(angle), std::sin(angle), 0);
    t.put(i, i == n ? Vec3::Zero() : x);
  }
  t.rod.hold(0), t.rod.hold(n);
  t.rod.clamp(0) = t.rod.clamp(1) = {true, Vec3::UnitX(), Vec3::UnitZ()};
  t.rod.start(t.s);
  // turned on until the flat ring is no longer stable
  double turn = 0;
  while (turn < 1.5 * exact) {
    turn += (turn < 0.9 * exact ? 0.03 : 0.001) * exact;
    t.rod.clamp(1).director = Vec3(0, -std::sin(turn), std::cos(turn));
    t.rod.follow_clamps(t.s);
    t.rod.step(t.s, {}, 20, 1e-13);
    // what has left its plane has turned twist into writhe
    if (std::abs(2 * kPi * t.rod.turns(t.s) - turn) > 1e-2 * turn || !t.rod.stable(t.s, {})) break;
  }
  EXPECT_NEAR(turn / exact, 1, 0.01);
}

}  // namespace rod_statics_test
}  // namespace swage::toolkit
