// SPDX-License-Identifier: Apache-2.0
//
// What a hold asks beside the place of the grasp, and what fell out of reach in practice.
#include <gtest/gtest.h>

#include "grasp_attempt.hpp"

namespace swage::lesson_grasp {
namespace {

TEST(Judge, AHoldNeedsForceTipsAndLift) {
  Rules rules;
  rules.tips_needed = true;
  rules.lift = 1e-3;
  Attempt a(rules);
  a.go();
  EXPECT_EQ(a.take(0.6, 1e-3, 0.6).stage, Stage::kGrasp) << "not lifted";
  a.now.needle_W = Vec3(0, 0, 1.1e-3);
  EXPECT_EQ(a.go().stage, Stage::kHold);
  a.now.tip_reach = 3e-3;
  EXPECT_EQ(a.go().stage, Stage::kGrasp) << "deep in the jaws";
  a.now.tip_reach = 1e-3;
  a.now.force = 0.01;
  EXPECT_EQ(a.go().stage, Stage::kGrasp) << "hardly held";
  a.now.force = 1.2;
  const Finding f = a.go();
  EXPECT_TRUE(f.too_hard);
  EXPECT_EQ(f.stage, Stage::kGrasp) << "too hard";
}

// Open jaws that push a thread aside do not lift it.
TEST(Judge, TheLiftCountsFromWhereItWasGrasped) {
  Rules rules;
  rules.lift = 1e-3;
  Attempt a(rules);
  a.go();
  a.now.needle_W = Vec3(0, 0.9e-3, 0);
  a.go();
  EXPECT_EQ(a.take(0.6, 1e-3, 0.6).stage, Stage::kGrasp);
  a.now.needle_W = Vec3(0, 1.2e-3, 0);
  EXPECT_EQ(a.go().stage, Stage::kGrasp) << "lifted by 0.3 mm, though 1.2 mm from its start";
  a.now.needle_W = Vec3(0, 0.9e-3, 1.1e-3);
  EXPECT_EQ(a.go().stage, Stage::kHold);
}

TEST(Judge, InPracticeANeedleOutOfReachEndsNothing) {
  Rules practice;
  practice.ends = false;
  Attempt a(practice);
  a.go(10);
  a.now.needle_W = {0, 0, -31e-3};
  EXPECT_TRUE(a.go().dropped);
  EXPECT_EQ(a.go(10).end, End::kRunning) << "it can be put back";
}

}  // namespace
}  // namespace swage::lesson_grasp
