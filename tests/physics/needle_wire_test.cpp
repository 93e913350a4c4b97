// SPDX-License-Identifier: Apache-2.0
//
// A bending arm of wire against closed forms: deflection, elastica, first yield, the angle that stays, loads beyond the plastic moment,
// ductility. The section by itself is in needle_law_test.cpp.
#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "curvature_at.hpp"
#include "toolkit/bent_wire.hpp"

namespace swage::toolkit {
namespace needle_wire_test {

constexpr double kWire = 100e-6;  // m

/// A straight wire, nearly: piece 0 is held, the last one is pushed across at its end.
struct Cantilever {
  Cantilever(int pieces, double arm, const WireMaterial& steel) : n(pieces) {
    // the arm counts from the middle of the piece that is held
    const double length = arm * n / (n - 0.5), radius = 1e3 * length;
    wire = BentWire(n, radius, length / radius, steel);
    for (int j = 0; j < n - 1; ++j) wire.set_section(j, wire_section(kWire, 1, 0, steel));
    start = tip();
  }
  Vec3 tip() {
    wire.place(0, Pose(), joint.data(), X.data());
    return X[static_cast<size_t>(n - 1)] * Vec3(0, 0.5 * wire.piece_length(), 0);
  }
  /// Deflection under `force` [N] in the plane; a few passes, as the lever changes with the shape.
  double push(double force) {
    for (int pass = 0; pass < 20; ++pass) {
      const Vec3 p = tip();
      std::array<Vec3, BentWire::kMaxPieces> by, moment;
      double asked = 0;
      for (int j = 0; j < n - 1; ++j) {
        const JointMemory& memory = joint[static_cast<size_t>(j)];
        const Frame J = wire.joint_frame(X[static_cast<size_t>(j)], memory);
        Mat3 F;
        const bool flows = wire.flexibility(j, memory, F);
        const Vec3 m = BentWire::gain(j, J, 0, n - 1, p).transpose() * Vec3(force, 0, 0);
        moment[static_cast<size_t>(j)] = m;
        by[static_cast<size_t>(j)] = wire.answer(j, m, F, flows, memory);
        asked += by[static_cast<size_t>(j)].norm();
      }
      for (int j = 0; j < n - 1; ++j)
        wire.bend(j, BentWire::share(asked) * by[static_cast<size_t>(j)], joint[static_cast<size_t>(j)],
                  even ? Vec3(Vec3::Zero()) : wire.slope(j, moment.data()));
    }
    return (tip() - start).x();
  }
  double stress() const {
    double most = 0;
    for (int j = 0; j < n - 1; ++j) most = std::max(most, wire.stress(j, joint[static_cast<size_t>(j)]));
    return most;
  }
  int n;
  bool even = false;  // takes the moment to be the same all along a joint's stretch
  BentWire wire;
  std::array<JointMemory, BentWire::kMaxPieces> joint{};
  std::array<Pose, BentWire::kMaxPieces> X;
  Vec3 start;
};

// P L^3 / 3 EI = 222.9 um; the midpoint rule over pieces is of order 2. As a tenth of the load shows ten times, without the 0.3 %
// by which the arm is shortened under the whole
TEST(BentWire, ACantileverGives223Micrometres) {
  const WireMaterial steel;
  const double exact = 0.01 * 64e-9 / (3 * bending_stiffness(kWire, steel.youngs));
  EXPECT_NEAR(exact, 222.9e-6, 0.1e-6);
  const auto error = [&](int n) { return std::abs(10 * Cantilever(n, 4e-3, steel).push(1e-3) / exact - 1); };
  EXPECT_LT(error(8), 5e-3);
  EXPECT_LT(error(16), 1.5e-3);
  EXPECT_LT(error(40), 2e-4);
  EXPECT_GT(error(8), 3 * error(16)) << "it converges";
  EXPECT_NEAR(Cantilever(40, 4e-3, steel).push(0.01), 222.9e-6, 1e-6);
}

// large deflection: a = P L^2 / EI = 1 is 59.8 mN, y/L = 0.301721, x/L = 0.943567 (heavy wire: it must not yield)
TEST(BentWire, FollowsTheElastica) {
  WireMaterial steel;
  steel.yield = 20e9;
  Cantilever wire(40, 4e-3, steel);
  const double force = bending_stiffness(kWire, steel.youngs) / 16e-6;
  EXPECT_NEAR(wire.push(force) / 4e-3, 0.301721, 1e-3);
  EXPECT_NEAR(wire.tip().y() / 4e-3, 0.943567, 1e-3);
}

/// Turn of the end that stays after a load has been put on and taken off slowly [rad].
double kept_turn(Cantilever wire, double force) {
  for (int k = 1; k <= 50; ++k) wire.push(force * k / 50);
  for (int k = 49; k >= 0; --k) wire.push(force * k / 50);
  double turn = 0;
  for (const JointMemory& joint : wire.joint) turn += joint.turn[2];
  return turn;
}

/// The same by the closed form for a small deflection: the integral of the curvature that stays where the moment falls evenly from m
/// times that of first yield to none, over the yield curvature times the arm; midpoint rule of 20000 places.
double exact_kept_turn(double m) {
  double sum = 0;
  constexpr int kPlaces = 20000;
  for (int i = 0; i < kPlaces; ++i) {
    const double here = m * (i + 0.5) / kPlaces;
    if (here > 1) sum += curvature_at(here, [](double c) { return round_moment(c); }) - here;
  }
  return sum / kPlaces;
}

// What stays of the angle, of the stock needle of 12 pieces and of finer ones. The steel is so soft that the arm does not shorten as it
// bends. At 1.02 the part that flows, 1 - 1/m of the arm, is a quarter of a piece.
TEST(BentWire, KeepsTheAngleThatTheClosedFormKeeps) {
  WireMaterial soft;
  soft.yield = 0.02e9, soft.hardening = 1e-6;
  const double force = yield_moment(kWire, soft.yield) / 4e-3;  // of first yield at the clamp
  const double unit = wire_section(kWire, 1, 0, soft).yield_curvature(2) * 4e-3;
  for (const int n : {12, 24, 40})
    for (const double m : {1.02, 1.021, 1.022, 1.025, 1.03, 1.035, 1.04, 1.05, 1.07, 1.1, 1.2, 1.4, 1.6}) {
      const double exact = exact_kept_turn(m);
      EXPECT_NEAR(-kept_turn(Cantilever(n, 4e-3, soft), m * force) / unit, exact, 0.08 * exact) << n << " pieces, " << m;
    }
  // and not by chance: a moment that is the same all along a joint's stretch leaves a third of it out
  Cantilever even(12, 4e-3, soft);
  even.even = true;
  EXPECT_LT(-kept_turn(even, 1.1 * force) / unit, 0.7 * exact_kept_turn(1.1));
}

// Beyond the plastic moment the wire bends until its lever is short enough: a little beyond, it is at rest so; far beyond, it lies along
// the load, bent at its root. Turns and moments stay finite.
TEST(BentWire, GivesWayInBoundsBeyondThePlasticMoment) {
  for (const double hardening : {1e-9, 0.01})
    for (const double over : {1.2, 3.0, 100.0}) {
      WireMaterial steel;
      steel.hardening = hardening;
      Cantilever wire(12, 4e-3, steel);
      const double force = over * plastic_moment(kWire, steel.yield) / 4e-3;
      for (int k = 0; k < 50; ++k) wire.push(force);
      const Vec3 d = wire.tip();
      EXPECT_LE(d.norm(), 4.4e-3);
      for (int j = 0; j < 11; ++j) {
        const JointMemory& joint = wire.joint[static_cast<size_t>(j)];
        EXPECT_EQ(joint.broken, 0);
        EXPECT_LE(BentWire::turn(joint).norm(), BentWire::kFolded * (1 + 1e-9));
        EXPECT_LE(BentWire::moment(joint).norm(), 2 * plastic_moment(kWire, steel.yield));
        EXPECT_TRUE(std::isfinite(BentWire::path(joint)));
      }
      wire.push(force);
      if (over < 2)
        EXPECT_LT((wire.tip() - d).norm(), 1e-9) << "it is at rest";
      else
        EXPECT_GT(d.x(), 0.85 * 4e-3) << over;
    }
}

// A moment that no turn relieves folds a joint, which then stands; the section bears what it can
TEST(BentWire, FoldsUnderAMomentWithoutEnd) {
  const WireMaterial steel;
  BentWire wire(2, 1, 2e-3, steel);
  const WireSection section = wire_section(kWire, 1, 0, steel);
  wire.set_section(0, section);
  JointMemory joint;
  const auto under = [&](double moment) {
    Mat3 F;
    const bool flows = wire.flexibility(0, joint, F);
    const Vec3 by = wire.answer(0, {0, 0, moment}, F, flows, joint);
    wire.bend(0, BentWire::share(by.norm()) * by, joint);
  };
  for (int k = 0; k < 1000; ++k) under(5 * section.yield[2]);
  EXPECT_TRUE(BentWire::folded(joint));
  EXPECT_NEAR(joint.turn[2], BentWire::kFolded, 1e-9);
  EXPECT_EQ(joint.broken, 0) << "3 rad over 1 mm strain the outer fibre by 15 %";
  EXPECT_LT(wire.stress(0, joint), 2);
  // let go, it springs back by the elastic part: 14.6 yield curvatures less 1.83 of them
  for (int k = 0; k < 10; ++k) under(0);
  const double turn_y = section.yield_curvature(2) * 1e-3, c = BentWire::kFolded / turn_y;
  EXPECT_NEAR(joint.turn[2], (c - round_moment(c, steel.hardening)) * turn_y, 0.01);
}

// The first joint is half a piece from the clamp, where the moment is smaller by 1/(2n), 1.3 % for 40 pieces; and bending shortens
// the arm, by 4 % where the load is greatest
TEST(BentWire, YieldsAt20To49Millinewtons) {
  for (const auto& [yield, force] : {std::pair{0.8e9, 19.6e-3}, {1.6e9, 39.3e-3}, {2.0e9, 49.1e-3}}) {
    WireMaterial steel;
    steel.yield = yield;
    EXPECT_LT(Cantilever(40, 4e-3, steel).push(0), 1e-15);
    Cantilever below(40, 4e-3, steel), above(40, 4e-3, steel);
    below.push(0.98 * force);
    above.push(1.08 * force);
    EXPECT_LT(below.stress(), 1);
    EXPECT_GT(above.stress(), 1);
  }
}

// Ductility: bends to a right angle and back, over 1 mm. In either direction the plastic curvature goes c - 2 M(c/2), Masing's
// curve, with c = 7.66 yield curvatures; the outer fibre strains by that times sigma / E.
TEST(BentWire, BreaksAfterAsManyBendsAsItsDuctilitySays) {
  WireMaterial steel;
  steel.hardening = 1e-9;
  BentWire wire(2, 1, 2e-3, steel);  // two pieces of 1 mm, and a joint that stands for 1 mm
  const WireSection section = wire_section(kWire, 1, 0, steel);
  wire.set_section(0, section);
  const double turn = std::numbers::pi / 2, c = turn / 1e-3 / section.yield_curvature(2);
  const double strain = (c - 2 * round_moment(0.5 * c)) * steel.yield / steel.youngs;
  const double expected = steel.break_strain / (2 * strain);
  EXPECT_NEAR(c, 7.66, 0.01);

  JointMemory joint;
  int bends = 0;
  double half = 0;
  for (; joint.broken == 0 && bends < 100; ++bends) {
    wire.bend(0, {0, 0, turn}, joint);
    if (bends == 0) half = wire.damage(joint);
    if (joint.broken == 0) wire.bend(0, {0, 0, -turn}, joint);
  }
  EXPECT_NEAR(half, (c - round_moment(c)) * steel.yield / steel.youngs / steel.break_strain, 0.02 * half);
  EXPECT_NEAR(bends, expected, 1.1) << "a whole number, and the first bend strains more than the others";
  // broken, it bears next to nothing
  wire.bend(0, {0, 0, 0.1}, joint);
  EXPECT_LT(wire.stress(0, joint), 0.02);
}

}  // namespace needle_wire_test
}  // namespace swage::toolkit
