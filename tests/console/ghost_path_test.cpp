// SPDX-License-Identifier: Apache-2.0
//
// The ghost waits for the trainee: along a curve, along one line down and up, in phases, with two instruments, with closing jaws.
#include "console/models/ghost_path.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

namespace swage::console {
namespace {

constexpr double kEvery_s = 0.02;

swage_pose at(double x, double y, double z) { return {{x, y, z}, {1, 0, 0, 0}}; }

// an instrument of one body whose tip is its origin
const std::vector<BodyPlace> kTip = {{0, {}}};

GhostPath way(double seconds, const std::function<swage_pose(double)>& go, const std::function<uint32_t(double)>& phase) {
  GhostPath path(kTip);
  for (double t = 0; t <= seconds + 1e-9; t += kEvery_s) {
    const swage_pose X = go(t);
    path.add(t, phase(t), {&X, 1});
  }
  return path;
}
uint32_t one_phase(double) { return 0; }

/// Moves the trainee there and checks that the ghost's lead is kept.
void lead(GhostPace& pace, const GhostPath& path, const swage_pose& X, uint32_t phase, double dt = 0.016) {
  pace.follow({&X, 1}, phase, dt);
  EXPECT_LE(pace.shown_way_m(), path[pace.progress()].way_m + GhostPace::kLead_m + 1e-12);
  EXPECT_GE(pace.shown_s(), path[pace.progress()].time_s) << "nor behind";
}

TEST(GhostPath, WaitsForATraineeWhoDoesNotMove) {
  const GhostPath path = way(10, [](double t) { return at(2e-3 * t, 0, 0); }, one_phase);  // 20 mm path
  GhostPace pace(path);
  for (int i = 0; i < 1000; ++i) lead(pace, path, at(0, 0, 0), 0);
  EXPECT_EQ(pace.progress(), 0u);
  EXPECT_NEAR(pace.shown_way_m(), GhostPace::kLead_m, 0.04e-3 + 1e-9) << "one frame";
  std::vector<swage_pose> shown;
  pace.pose(shown);
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_NEAR(shown[0].p.x, pace.shown_way_m(), 1e-12);
}

TEST(GhostPath, GoesAtTheTraineesPaceAndBackWithHim) {
  const GhostPath path = way(10, [](double t) { return at(2e-3 * t, 0, 0); }, one_phase);
  GhostPace pace(path);
  for (int i = 0; i <= 1000; ++i) lead(pace, path, at(10e-3 * i / 1000, 0.3e-3, 0), 0);  // 0.3 mm beside the path, in 16 s
  EXPECT_NEAR(path[pace.progress()].way_m, 10e-3, 0.2e-3);
  EXPECT_NEAR(pace.shown_way_m(), 10e-3 + GhostPace::kLead_m, 0.3e-3);
  for (int i = 1000; i >= 200; --i) lead(pace, path, at(10e-3 * i / 1000, 0.3e-3, 0), 0);
  EXPECT_NEAR(path[pace.progress()].way_m, 2e-3, 0.3e-3);
}

TEST(GhostPath, TheGhostIsNoFasterThanTheExpert) {
  const GhostPath path = way(10, [](double t) { return at(0.2e-3 * t, 0, 0); }, one_phase);  // 2 mm in 10 s
  GhostPace pace(path);
  for (int i = 0; i < 100; ++i) lead(pace, path, at(0, 0, 0), 0, 0.01);
  EXPECT_NEAR(pace.shown_s(), 1, 1e-9);
}

TEST(GhostPath, TheSameLineDownAndUpIsGoneInOrder) {
  const auto down_up = [](double t) { return at(0, 0, 10e-3 - 2e-3 * (t < 5 ? t : 10 - t)); };
  const GhostPath path = way(10, down_up, one_phase);
  GhostPace pace(path);
  std::mt19937 random(2);
  std::normal_distribution<double> tremor(0, 20e-6);
  double last = 0;
  for (int i = 0; i <= 1000; ++i) {
    swage_pose X = down_up(10.0 * i / 1000);
    X.p.x += tremor(random), X.p.y += tremor(random);
    lead(pace, path, X, 0);
    const double s = path[pace.progress()].way_m;
    EXPECT_LT(std::abs(s - last), 1e-3) << "at " << 10.0 * i / 1000 << " s: no leap over the turn";
    last = s;
  }
  EXPECT_NEAR(last, 20e-3, 0.2e-3);
}

TEST(GhostPath, AShortCutIsProgress) {
  const auto arc = [](double t) { return at(5e-3 - 5e-3 * std::cos(0.1 * M_PI * t), 0, 5e-3 * std::sin(0.1 * M_PI * t)); };
  const GhostPath path = way(10, arc, one_phase);
  GhostPace pace(path);
  for (int i = 0; i <= 200; ++i) lead(pace, path, at(10e-3 * i / 200, 0, 0), 0);
  EXPECT_EQ(pace.progress(), path.size() - 1) << "straight to the end";
}

TEST(GhostPath, NoPhaseIsLeftBeforeTheTraineeLeavesIt) {
  const auto phase = [](double t) -> uint32_t { return t < 1 ? 0 : t < 2 ? 1 : 2; };
  const GhostPath path = way(3, [](double t) { return at(1e-3 * t, 0, 0); }, phase);  // 3 mm: all within the lead
  GhostPace pace(path);
  for (int i = 0; i < 200; ++i) lead(pace, path, at(0, 0, 0), 0);
  EXPECT_LT(pace.shown_s(), 1);
  EXPECT_GT(pace.shown_s(), 0.95);
  lead(pace, path, at(0, 0, 0), 1);
  EXPECT_GE(pace.shown_s(), 1 - 1e-9) << "the phase began elsewhere: the ghost is in it";
  for (int i = 0; i < 200; ++i) lead(pace, path, at(0, 0, 0), 1);
  EXPECT_LT(pace.shown_s(), 2);
  // the needle is dropped: back to the first phase
  lead(pace, path, at(0.2e-3, 0, 0), 0);
  EXPECT_NEAR(pace.shown_s(), 0.99, 0.03);
  // a phase that the expert never has: the ghost waits
  const double before = pace.shown_s();
  for (int i = 0; i < 100; ++i) lead(pace, path, at(0, 0, 0), 7);
  EXPECT_EQ(pace.shown_s(), before);
}

TEST(GhostPath, ComesWhenTheExpertHasComeSoFar) {
  GhostPath path(kTip);
  GhostPace pace(path);
  const swage_pose X = at(0, 0, 0);
  std::vector<swage_pose> shown;
  pace.follow({&X, 1}, 0, 1);
  pace.pose(shown);
  EXPECT_TRUE(shown.empty());
  for (int i = 0; i < 50; ++i) {
    const swage_pose there = at(1e-3 * i, 0, 0);
    path.add(kEvery_s * i, 0, {&there, 1});
  }
  lead(pace, path, X, 0, 10);
  pace.pose(shown);
  EXPECT_EQ(shown.size(), 1u);
  EXPECT_NEAR(pace.shown_way_m(), GhostPace::kLead_m, 1e-12);
}

// Closing jaws and a rotating tool both count as path length.
TEST(GhostPath, ClosingAndTurningAreWay) {
  GhostPath path({{0, {10e-3, 0, 0}}, {1, {10e-3, 0, 0}}, {0, {}}});
  const auto closed = [](double angle) {
    return std::vector<swage_pose>{{{}, {std::cos(angle / 2), 0, std::sin(angle / 2), 0}}, {{}, {std::cos(angle / 2), 0, -std::sin(angle / 2), 0}}};
  };
  for (int i = 0; i <= 100; ++i) path.add(kEvery_s * i, 0, closed(0.2 * (1 - i / 100.0)));
  EXPECT_NEAR(path[100].way_m, 10e-3 * 0.2 * 2 / 3, 1e-6) << "two tips of three places go 2 mm";
  GhostPace pace(path);
  pace.follow(closed(0.1), 0, 0);
  EXPECT_NEAR(static_cast<double>(pace.progress()), 50, 1);
}

// One of two instruments waits while the other moves; the trainee moves one at a time, with one mouse.
TEST(GhostPath, TwoInstrumentsHaveOneClock) {
  GhostPath path({{0, {}}, {1, {}}});
  for (int i = 0; i <= 500; ++i) {
    const double t = kEvery_s * i;
    const swage_pose X[] = {at(1e-3 * std::min(t, 5.0), 0, 0), at(20e-3, 1e-3 * std::max(t - 5, 0.0), 0)};
    path.add(t, 0, X);
  }
  GhostPace pace(path);
  std::vector<swage_pose> shown;
  for (int i = 0; i <= 100; ++i) {
    const swage_pose X[] = {at(5e-3 * i / 100, 0, 0), at(20e-3, 0, 0)};
    pace.follow(X, 0, 0.1);
  }
  pace.pose(shown);
  EXPECT_NEAR(path[pace.progress()].time_s, 5, 0.1);
  EXPECT_NEAR(shown[0].p.x, 5e-3, 1e-5) << "the first has come to rest";
  EXPECT_GT(shown[1].p.y, 4e-3) << "and the ghost shows the second: 3 mm in the mean of two places are 6 mm of one";
  for (int i = 0; i <= 100; ++i) {
    const swage_pose X[] = {at(5e-3, 0, 0), at(20e-3, 5e-3 * i / 100, 0)};
    pace.follow(X, 0, 0.1);
  }
  EXPECT_NEAR(path[pace.progress()].time_s, 10, 0.1);
}

TEST(GhostPath, AnyMotionKeepsTheGhostWithinItsLead) {
  std::mt19937 random(8);
  std::uniform_real_distribution<double> any(-12e-3, 12e-3);
  const auto phase = [](double t) -> uint32_t { return static_cast<uint32_t>(t) % 4; };
  const GhostPath path = way(12, [](double t) { return at(6e-3 * std::sin(t), 4e-3 * std::cos(1.7 * t), 1e-3 * t); }, phase);
  GhostPace pace(path);
  for (int i = 0; i < 5000; ++i) lead(pace, path, at(any(random), any(random), any(random)), static_cast<uint32_t>(random() % 5), 0.2);
}

}  // namespace
}  // namespace swage::console
