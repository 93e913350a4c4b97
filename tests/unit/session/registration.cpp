// SPDX-License-Identifier: Apache-2.0
//
// An arm before a picture: the rigid fit against motions that are known, with and without a hand that shakes.
#include "session/registration.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <random>
#include <vector>

#include "session/sentences.hpp"
#include "toolkit/math.hpp"

namespace swage::session {
namespace {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

// the four marks of the wizard on a screen of 520 mm by 320 mm
const Vec3 kMarks[] = {{-0.13, 0.08, 0}, {0.13, 0.08, 0}, {0.13, -0.08, 0}, {-0.13, -0.08, 0}};

std::vector<Touched> touched(const Pose& X_SD, double noise_m, uint32_t seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> shake(0, noise_m);
  std::vector<Touched> out;
  for (const Vec3& p_S : kMarks) {
    Vec3 p_D = X_SD.inverse() * p_S;
    if (noise_m > 0) p_D += Vec3(shake(random), shake(random), shake(random));
    out.push_back({toolkit::raw(p_S), toolkit::raw(p_D)});
  }
  return out;
}

Pose some_pose(uint32_t seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> n;
  return {Vec3(0.1 * n(random), 0.1 * n(random), 0.1 * n(random)), Quat(n(random), n(random), n(random), n(random)).normalized()};
}

TEST(Registration, FourMarksGiveTheMotionBackToRounding) {
  for (uint32_t seed = 1; seed <= 200; ++seed) {
    const Pose X_SD = some_pose(seed);
    Registration found;
    ASSERT_EQ(fit_registration(touched(X_SD, 0), found), "");
    EXPECT_LT((Vec3(toolkit::vec(found.X_SD.p)) - X_SD.p).norm(), 1e-12);
    EXPECT_GT(std::abs(toolkit::quat(found.X_SD.q).dot(X_SD.q)), 1 - 1e-12);
    EXPECT_LT(found.worst, 1e-12);
  }
}

// A hand that shakes by s in each direction: the best fit of 6 numbers to 12 leaves s sqrt(3 (1 - 6/12)) in the mean.
TEST(Registration, TheResidualIsThatOfTheHand) {
  constexpr double kShake = 0.5e-3;
  constexpr int kTimes = 400;
  double sum = 0, turned = 0;
  for (uint32_t seed = 1; seed <= kTimes; ++seed) {
    const Pose X_SD = some_pose(seed);
    Registration found;
    ASSERT_EQ(fit_registration(touched(X_SD, kShake, 1000 + seed), found), "");
    sum += found.rms * found.rms / kTimes;
    turned = std::max(turned, toolkit::quat(found.X_SD.q).angularDistance(X_SD.q));
    EXPECT_GE(found.worst, found.rms);
  }
  EXPECT_NEAR(std::sqrt(sum), kShake * std::sqrt(1.5), 0.05 * kShake);
  EXPECT_LT(turned, 5 * kShake / 0.15) << "rad, the marks lie 0.15 m from the middle";
}

TEST(Registration, WhatCannotBeOneIsToldAndLeavesTheOldOne) {
  Registration kept;
  kept.worst = 7;
  const auto why = [&](const std::vector<Touched>& points) { return fit_registration(points, kept); };
  std::vector<Touched> points = touched(some_pose(1), 0);
  EXPECT_NE(why({points[0], points[1]}).find(say::kFewPoints(2)), std::string::npos);
  EXPECT_NE(why({points[0], points[0], points[0], points[0]}).find(say::kOneLine.words(0)), std::string::npos);
  std::vector<Touched> still = points;
  for (Touched& t : still) t.p_D = {};
  EXPECT_NE(why(still).find(say::kOneLine.words(2)), std::string::npos);
  std::vector<Touched> wrong = points;
  std::swap(wrong[0].p_D, wrong[1].p_D);
  EXPECT_NE(why(wrong).find(say::kPointOff.words(1)), std::string::npos) << why(wrong);
  wrong = points;
  wrong[2].p_D.y = std::nan("");
  EXPECT_NE(why(wrong).find(say::kPointNoNumber()), std::string::npos);
  EXPECT_EQ(kept.worst, 7);
  // three points are a registration, and say nothing of a wrong one
  EXPECT_EQ(why({points[0], points[1], points[2]}), "");
}

// The tip before a mark of the picture is, in the scene, at the place that the mark shows; at scale 1 and at 10.
TEST(Registration, HandAndToolAreInOnePlace) {
  const Pose X_SD = some_pose(3), X_WS = some_pose(4);
  Registration found;
  ASSERT_EQ(fit_registration(touched(X_SD, 0), found), "");
  for (const double scale : {1.0, 10.0}) {
    const Pose X_WD(place_device(found, toolkit::raw(X_WS.p), toolkit::raw(X_WS.q), scale));
    for (const Touched& t : touched(X_SD, 0)) {
      const Vec3 shown = X_WS.p + X_WS.q * Vec3(toolkit::vec(t.p_S)) / scale;
      const Vec3 tool = X_WD * Vec3(toolkit::vec(t.p_D) / scale);  // as the host places a hand: motion_scale = scale
      EXPECT_LT((tool - shown).norm(), 1e-12);
    }
  }
}

}  // namespace
}  // namespace swage::session
