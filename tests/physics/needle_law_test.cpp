// SPDX-License-Identifier: Apache-2.0
//
// The wire of a needle against closed forms: first yield and full plasticity of a round section, elastic core, springback,
// bending to and fro, a cantilever, the needle of 100 um whose tip goes 223 um under 10 mN and that yields at 20 to 49 mN.
#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "toolkit/bent_wire.hpp"

namespace swage::toolkit {
namespace {

constexpr double kWire = 100e-6;  // m

// M_y, M_p and the yield force at a 4 mm arm for three steels; E = 195 GPa
TEST(Joint, TurnsByASeriesAsByTheExponential) {
  for (double angle = 1e-9; angle < 1; angle *= 1.7) {
    const Vec3 a = angle * Vec3(0.6, -0.64, 0.48);
    const Quat exact = exp_rotation(a), turn = joint_rotation(a);
    EXPECT_NEAR(turn.w(), exact.w(), 2.3e-16) << angle;
    EXPECT_LT((turn.vec() - exact.vec()).norm(), 2.3e-16 * angle) << angle;
  }
}

TEST(WireSection, FirstYieldAndFullPlasticityOfRoundWire) {
  const double expected[][4] = {{0.8e9, 7.854e-5, 1.3333e-4, 19.6e-3},
                                {1.6e9, 1.5708e-4, 2.6667e-4, 39.3e-3},
                                {2.0e9, 1.9635e-4, 3.3333e-4, 49.1e-3}};
  for (const auto& [yield, M_y, M_p, force] : expected) {
    EXPECT_NEAR(yield_moment(kWire, yield), M_y, 1e-4 * M_y);
    EXPECT_NEAR(plastic_moment(kWire, yield), M_p, 1e-4 * M_p);
    EXPECT_NEAR(yield_moment(kWire, yield) / 4e-3, force, 2e-3 * force);
    EXPECT_NEAR(plastic_moment(kWire, yield) / yield_moment(kWire, yield), 16 / (3 * std::numbers::pi),
                1e-12);
  }
  EXPECT_NEAR(bending_stiffness(kWire, 195e9), 9.572e-7, 1e-10);
}

TEST(WireSection, ARoundOneIsTheSameInAllDirections) {
  const WireMaterial steel;
  const WireSection s = wire_section(kWire, 1, 0, steel);
  const double EI = bending_stiffness(kWire, steel.youngs), M_y = yield_moment(kWire, steel.yield);
  for (const int axis : {0, 2}) {
    EXPECT_NEAR(s.stiffness[axis], EI, 1e-12 * EI);
    EXPECT_NEAR(s.yield[axis], M_y, 1e-12 * M_y);
  }
  // GJ = EI / (1 + nu); torsion yields at pi d^3 tau / 16, tau = sigma / sqrt 3
  EXPECT_NEAR(s.stiffness[1], EI / (1 + steel.poisson), 1e-12 * EI);
  EXPECT_NEAR(s.yield[1], std::numbers::pi * kWire * kWire * kWire * steel.yield / std::sqrt(3.0) / 16,
              1e-12 * M_y);
}

TEST(WireSection, AFlatOneIsSofterInItsPlaneAndStifferAcross) {
  const WireMaterial steel;
  const WireSection round = wire_section(kWire, 1, 0, steel), flat = wire_section(kWire, 0.64, 0, steel);
  EXPECT_NEAR(flat.area, round.area, 1e-12 * round.area);
  EXPECT_NEAR(flat.stiffness[2], 0.64 * round.stiffness[2], 1e-12 * round.stiffness[2]);
  EXPECT_NEAR(flat.stiffness[0], round.stiffness[0] / 0.64, 1e-12 * round.stiffness[0]);
  EXPECT_NEAR(flat.yield[2], 0.8 * round.yield[2], 1e-12 * round.yield[2]);
  EXPECT_NEAR(flat.yield[0], round.yield[0] / 0.8, 1e-12 * round.yield[0]);
}

// curvature, moment, residual curvature after unloading, all over their values at first yield
constexpr std::array<std::array<double, 3>, 6> kRoundTable = {{{1.25, 1.211563, 0.038437},
                                                               {1.5, 1.347091, 0.152909},
                                                               {2, 1.493660, 0.506340},
                                                               {3, 1.604932, 1.395068},
                                                               {5, 1.663904, 3.336096},
                                                               {10, 1.689177, 8.310823}}};

// the closed form itself, against the sum over strips of the section (midpoint rule, 4000 strips: 1e-5)
TEST(RoundMoment, IsTheIntegralOverTheSection) {
  for (const double c : {0.5, 1.0, 1.25, 1.5, 2.0, 3.0, 5.0, 10.0}) {
    double sum = 0;
    const int n = 4000;
    for (int i = 0; i < n; ++i) {
      const double y = -1 + (i + 0.5) * 2.0 / n;  // over the radius
      sum += std::clamp(c * y, -1.0, 1.0) * y * 2 * std::sqrt(1 - y * y) * 2 / n;
    }
    EXPECT_NEAR(round_moment(c), sum / (std::numbers::pi / 4), 2e-5) << c;
    EXPECT_EQ(round_moment(-c), -round_moment(c));
  }
  for (const auto& [c, moment, residual] : kRoundTable) EXPECT_NEAR(round_moment(c), moment, 1e-6);
}

Vec3 in_plane(double c) { return {0, 0, c}; }

// 0.75 %: what six layers are off the closed form at worst, see wire_law.hpp
TEST(WireLaw, FollowsTheClosedFormOfTheRoundSection) {
  for (const double hardening : {0.0, 0.01, 0.1}) {
    const WireLaw law(hardening);
    WireMemory memory;
    for (double c = 0.02; c < 20; c *= 1.01) {
      const double m = law.bend(in_plane(c), memory).z(), exact = round_moment(c, hardening);
      ASSERT_NEAR(m, exact, 7.5e-3 * exact) << c << " hardening " << hardening;
    }
  }
}

TEST(WireLaw, IsElasticUpToYieldAndKeepsNothing) {
  const WireLaw law(0.01);
  WireMemory memory;
  for (const double c : {0.3, -0.9, 1.0, -1.0, 0.0}) EXPECT_NEAR(law.bend(in_plane(c), memory).z(), c, 1e-15);
  EXPECT_EQ(memory.path, 0);
  EXPECT_TRUE(law.relaxed(memory).isZero(0));
}

// springback: what stays is kappa - M / EI
TEST(WireLaw, KeepsWhatTheClosedFormKeeps) {
  for (const auto& [c, moment, residual] : kRoundTable) {
    const WireLaw law(0);
    WireMemory memory;
    law.bend(in_plane(c), memory);
    EXPECT_NEAR(law.relaxed(memory).z(), residual, 8e-3 * c) << c;
    // and it stands there without a moment: nothing flows back on the way
    const double path = memory.path;
    EXPECT_NEAR(law.bend(law.relaxed(memory), memory).z(), 0, 1e-12);
    EXPECT_EQ(memory.path, path);
  }
}

// Masing: bent back from c, it follows the doubled curve, and at -c it is at -M(c)
TEST(WireLaw, BentBackItFollowsTheDoubledCurve) {
  const WireLaw law(0.02);
  const double c = 4;
  WireMemory memory;
  const double top = law.bend(in_plane(c), memory).z();
  for (double back = 0.1; back <= 2 * c; back += 0.1) {
    WireMemory fresh;
    const double curve = law.bend(in_plane(0.5 * back), fresh).z();
    ASSERT_NEAR(law.bend(in_plane(c - back), memory).z(), top - 2 * curve, 1e-12) << back;
  }
  EXPECT_NEAR(law.moment(in_plane(-c), memory).z(), -top, 1e-12);
}

TEST(WireLaw, AsksNotFromWhereItIsBent) {
  const WireLaw law(0.01);
  WireMemory a, b;
  const Vec3 u(0.6, 0, 0.8);
  for (const double c : {0.5, 1.5, 3.0, 2.0, -1.0}) {
    const double m = law.bend(in_plane(c), a).z();
    EXPECT_LT((law.bend(c * u, b) - m * u).norm(), 1e-13);
  }
}

TEST(WireLaw, TangentIsTheDerivative) {
  const WireLaw law(0.01);
  WireMemory memory;
  law.bend({1.5, 0.3, 1.0}, memory);
  const Vec3 at(2.0, 0.4, 1.4), on = at.normalized();
  law.bend(at, memory);
  Mat3 D;
  ASSERT_TRUE(law.tangent(at, memory, D));
  const double step = 1e-6;
  WireMemory copy = memory;
  const Vec3 slope = (law.bend(at + step * on, copy) - law.moment(at, memory)) / step;
  EXPECT_LT((D * on - slope).norm(), 0.05 * slope.norm())
      << "onward: layers keep their directions to first order";

  WireMemory fresh;
  law.bend({0.2, 0, 0.3}, fresh);
  EXPECT_FALSE(law.tangent({0.2, 0, 0.3}, fresh, D));
  EXPECT_EQ(D, Mat3::Identity());
}

// Bent to and fro between +-c the plastic curvature goes 2 (c - M) from one end to the other, with M the moment there
TEST(WireLaw, CountsThePlasticWay) {
  const WireLaw law(0);
  const double c = 6;
  WireMemory memory;
  const double m = law.bend(in_plane(c), memory).z();
  const double first = memory.path;
  EXPECT_NEAR(first, c - m, 1e-12);
  for (int bends = 1; bends <= 5; ++bends) {
    law.bend(in_plane(bends % 2 == 1 ? -c : c), memory);
    EXPECT_NEAR(memory.path, first + bends * 2 * (c - m), 1e-9);
  }
}

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
      for (int j = 0; j < n - 1; ++j) {
        JointMemory& memory = joint[static_cast<size_t>(j)];
        const Frame J = wire.joint_frame(X[static_cast<size_t>(j)], memory);
        Mat3 F;
        const bool flows = wire.flexibility(j, memory, F);
        const Vec3 m = BentWire::gain(j, J, 0, n - 1, p).transpose() * Vec3(force, 0, 0);
        wire.bend(j, wire.answer(j, m, F, flows, memory), memory);
      }
    }
    return (tip() - start).x();
  }
  double stress() const {
    double most = 0;
    for (int j = 0; j < n - 1; ++j) most = std::max(most, wire.stress(j, joint[static_cast<size_t>(j)]));
    return most;
  }
  int n;
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

}  // namespace
}  // namespace swage::toolkit
