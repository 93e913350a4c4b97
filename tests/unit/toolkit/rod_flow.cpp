// SPDX-License-Identifier: Apache-2.0
//
// A rod that stays bent, against the closed form of two springs side by side, of which one slides (toolkit/rod_flow.hpp).
#include "toolkit/rod_flow.hpp"

#include <gtest/gtest.h>

#include <random>

namespace swage::toolkit {
namespace {

constexpr int kEdges = 24;
constexpr double kLength = 50e-6;  // m, of an edge
const RodSection kThread = RodSection::round(22e-6, 2.5e9, 0.39, 1140);

/// A rod along a circle of curvature `k` [1/m], in a plane turned by `about` [rad] from the one of its directors.
struct Bent {
  explicit Bent(double memory = 0)
      : numbers(RodState::size(kEdges + 1)), s(kEdges + 1, numbers.data()), rod(kThread, std::vector<double>(kEdges, kLength), memory),
        set(2 * (kEdges + 1)) {
    lay(0, 0);
    rod.start_set(set.data()), rod.remember(set.data());
  }
  void lay(double k, double about) {
    const double turn = 2 * std::atan(0.5 * k * kLength);  // from edge to edge, so that 2 tan(turn / 2) = k l
    Vec3 x = Vec3::Zero();
    for (int i = 0; i <= kEdges; ++i) {
      Eigen::Map<Vec3>(s.x + 3 * i) = x;
      const double a = i * turn;
      x += kLength * (std::cos(a) * Vec3::UnitX() + std::sin(a) * (std::cos(about) * Vec3::UnitY() + std::sin(about) * Vec3::UnitZ()));
    }
    rod.clamp(0) = {true, Vec3::UnitX(), Vec3::UnitZ()};
    rod.start(s);
    rod.clamp(0).on = false;
  }
  /// Natural curvature of the middle joint [1/m], towards where it was bent and across that.
  std::array<double, 2> natural(double about) const {
    const double a = set[kEdges] / kLength, b = set[kEdges + 1] / kLength;
    // the binormal of a bend towards `about` is Z turned by it about X; Z is the director, X x Z = -Y the other
    return {a * std::cos(about) + b * std::sin(about), -a * std::sin(about) + b * std::cos(about)};
  }
  void flow(const RodYield& yield) { rod.flow(s, yield, set.data()); }

  std::vector<double> numbers;
  RodState s;
  Rod rod;
  std::vector<double> set;
};

/// 2 tan(k l / 2) / l, which is what a joint knows of a curvature.
double as_joint(double k) { return 2 * std::tan(0.5 * k * kLength) / kLength; }

// bent to k it keeps (1 - c) (k - y), in whatever direction
TEST(RodFlow, KeepsWhatIsBeyondYield) {
  const RodYield yield{5e3, 0.3};
  for (const double about : {0.0, 0.7, 2.0, -1.3}) {
    Bent rod;
    rod.lay(4.9e3, about), rod.flow(yield);
    EXPECT_EQ(rod.natural(about)[0], 0) << "elastic below yield";
    rod.lay(12e3, about), rod.flow(yield);
    const auto [along, across] = rod.natural(about);
    EXPECT_NEAR(along, 0.7 * (12e3 - as_joint(5e3)), 1e-9 * 12e3) << about;
    EXPECT_NEAR(across, 0, 1e-9 * 12e3) << about;
    const std::vector<double> once = rod.set;
    rod.flow(yield);
    for (size_t i = 0; i < once.size(); ++i) EXPECT_NEAR(rod.set[i], once[i], 1e-12) << "what has flowed stays";
  }
}

// a rod of its own lies where nothing bends it: as the natural curvature says, by the equilibrium that the solver finds
TEST(RodFlow, LetGoItLiesAsItWasLeft) {
  const RodYield yield{5e3, 0.3};
  Bent rod;
  rod.lay(9e3, 0.4), rod.flow(yield);
  rod.rod.hold(0), rod.rod.hold(1), rod.rod.hold_turn(0);
  ASSERT_TRUE(rod.rod.step(rod.s, RodLoad{}, 200, 1e-12).settled);
  const double kept = 0.7 * (9e3 - as_joint(5e3));
  for (int i = 2; i < kEdges; ++i) EXPECT_NEAR(rod.rod.curvature(rod.s, i), kept, 1e-6 * kept) << i;
  EXPECT_LT(rod.rod.energy(rod.s), 1e-9 * 0.5 * kThread.bending * kept * kept * kEdges * kLength);
}

// bent back it yields at 2 y from where it was, and after a whole turn of bends it is what the last of them left
TEST(RodFlow, YieldsAgainAfterTwiceTheYieldCurvature) {
  const RodYield yield{4e3, 0};
  const double y = as_joint(4e3);
  Bent rod;
  rod.lay(10e3, 0), rod.flow(yield);
  const double kept = rod.natural(0)[0];
  EXPECT_NEAR(kept, 10e3 - y, 1e-5);
  rod.lay(10e3 - 1.99 * y, 0), rod.flow(yield);
  EXPECT_EQ(rod.natural(0)[0], kept);
  rod.lay(-10e3, 0), rod.flow(yield);
  EXPECT_NEAR(rod.natural(0)[0], -(10e3 - y), 1e-5);
  // half a turn away is the same plane
  EXPECT_NEAR(rod.natural(M_PI)[0], 10e3 - y, 1e-5);
}

// what it remembered before it was bent: with c it goes back by c of that
TEST(RodFlow, MemoryStaysInTheElasticShare) {
  const RodYield yield{4e3, 0.25};
  Bent rod(100);
  EXPECT_NEAR(rod.natural(0)[0], as_joint(100), 1e-6);
  rod.lay(10e3, 0), rod.flow(yield);
  EXPECT_NEAR(rod.natural(0)[0], 0.25 * as_joint(100) + 0.75 * (10e3 - as_joint(4e3)), 1e-5);
}

// flowing only takes energy, and leaves no more moment than a section bears that yields throughout: bends in 200 random directions
TEST(RodFlow, OnlyTakesEnergy) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(0, 1);
  Bent rod;
  int flowed = 0;
  for (int i = 0; i < 200; ++i) {
    rod.lay(8e3 * any(random), 6.3 * any(random));
    const double before = rod.rod.energy(rod.s);
    rod.flow({3e3, 0});
    const double after = rod.rod.energy(rod.s);
    EXPECT_LE(after, before * (1 + 1e-12)) << i;
    flowed += after < before * (1 - 1e-6);
    const double most = 0.5 * kThread.bending * as_joint(3e3) * as_joint(3e3) * kLength * (kEdges - 1);
    EXPECT_LE(after, most * (1 + 1e-9)) << i;
  }
  EXPECT_GT(flowed, 50);
}

// the moment at yield is that of a round section of which each fibre bears its yield stress: 4/3 r^3 sigma, by quadrature
TEST(RodFlow, YieldIsThatOfARoundSection) {
  const double r = 11e-6, E = 2.5e9, strain = 0.05;
  double moment = 0;
  constexpr int kStrips = 200000;
  for (int i = 0; i < kStrips; ++i) {
    const double z = r * (2 * (i + 0.5) / kStrips - 1);
    moment += E * strain * std::abs(z) * 2 * std::sqrt(r * r - z * z) * 2 * r / kStrips;
  }
  EXPECT_NEAR(kThread.bending * RodYield::round(2 * r, strain, 0).curvature, moment, 1e-5 * moment);
  EXPECT_EQ(RodYield::round(2 * r, 0, 0).curvature, 0) << "elastic";
}

}  // namespace
}  // namespace swage::toolkit
