// SPDX-License-Identifier: Apache-2.0
//
// Turns of a thread about an instrument, and its passages through it.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "toolkit/knot/winding.hpp"

namespace swage::test {
namespace {

using toolkit::Vec3;
using toolkit::Winding;

constexpr double kReach = 6e-3;

double turns(const std::vector<Vec3>& node) {
  Winding w(kReach);
  for (size_t i = 0; i + 1 < node.size(); ++i) w.add(node[i], node[i + 1]);
  return w.turns();
}

std::vector<Vec3> helix(double turns, double from_x, double to_x, int pieces = 60) {
  std::vector<Vec3> out;
  for (int i = 0; i <= pieces; ++i) {
    const double u = static_cast<double>(i) / pieces, a = 2 * M_PI * turns * u;
    out.emplace_back(from_x + u * (to_x - from_x), 0.5e-3 * std::cos(a), 0.5e-3 * std::sin(a));
  }
  return out;
}

TEST(Winding, OfAHelixIsItsTurnsWithTheirSign) {
  for (const double n : {1.0, 2.0, 0.3, -1.0, -2.7}) EXPECT_NEAR(turns(helix(n, -3e-3, -1e-3)), n, 1e-12);
}

TEST(Winding, OnlyWhatLiesBesideTheInstrumentCounts) {
  EXPECT_EQ(turns(helix(2, 1e-3, 3e-3)), 0) << "beyond the tips";
  EXPECT_EQ(turns(helix(2, -9e-3, -7e-3)), 0) << "beyond the base";
  EXPECT_NEAR(turns(helix(2, -1e-3, 1e-3)), 1, 0.01) << "half slid off";
  EXPECT_NEAR(turns(helix(2, -7e-3, -5e-3)), 1, 0.01);
  EXPECT_EQ(turns({Vec3(0.1e-3, 1e-3, 0), Vec3(0.1e-3, -1e-3, 1e-3)}), 0) << "square to it";
}

TEST(Winding, AThreadThatPassesHasLessThanHalfATurn) {
  for (const double away : {0.5e-3, -0.5e-3, 3e-3})
    EXPECT_NEAR(std::abs(turns({Vec3(-2e-3, -20e-3, away), Vec3(-2e-3, 20e-3, away)})), std::atan(20e-3 / std::abs(away)) / M_PI, 1e-12);
}

TEST(Winding, SaysHowFarBehindTheTipsItIs) {
  Winding w(kReach);
  const std::vector<Vec3> node = helix(2, -3e-3, -1e-3);
  for (size_t i = 0; i + 1 < node.size(); ++i) w.add(node[i], node[i + 1]);
  EXPECT_NEAR(w.behind(), 2e-3, 1e-12);
  EXPECT_EQ(Winding(kReach).behind(), 0);
}

// the turns of a closed polygon beside the instrument are whole, so whatever it does they change by its passages and by nothing else
TEST(Winding, OfAClosedThreadChangesByItsPassagesOnly) {
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  int passages = 0;
  for (int trial = 0; trial < 3000; ++trial) {
    std::vector<Vec3> then, now;
    for (int i = 0; i < 9; ++i) {
      then.emplace_back(-3e-3 + 0.3e-3 * normal(random), 1e-3 * normal(random), 1e-3 * normal(random));
      now.push_back(then.back() + 0.3e-3 * Vec3(0.3 * normal(random), normal(random), normal(random)));
    }
    then.push_back(then.front()), now.push_back(now.front());
    int gained = 0;
    for (size_t i = 0; i + 1 < then.size(); ++i) {
      const int g = toolkit::wound_through(then[i], then[i + 1], now[i], now[i + 1], kReach);
      gained += g, passages += std::abs(g);
    }
    ASSERT_NEAR(turns(now) - turns(then), gained, 1e-9) << trial;
  }
  EXPECT_GT(passages, 500);
}

// a loop that is led off over the tips loses its turn without a passage
TEST(Winding, SlidingOffOverTheTipsIsNoPassage) {
  std::vector<Vec3> then = helix(1, -1e-3, -0.9e-3);
  for (int step = 0; step < 60; ++step) {
    std::vector<Vec3> now = then;
    for (Vec3& p : now) p.x() += 20e-6;
    for (size_t i = 0; i + 1 < now.size(); ++i)
      ASSERT_EQ(toolkit::wound_through(then[i], then[i + 1], now[i], now[i + 1], kReach), 0);
    then = now;
  }
  EXPECT_EQ(turns(then), 0);
}

}  // namespace
}  // namespace swage::test
