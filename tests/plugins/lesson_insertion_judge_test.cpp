// SPDX-License-Identifier: Apache-2.0
//
// The insertion lesson: what counts as good, each way to fail, every metric against a way that can be integrated by hand.
#include <gtest/gtest.h>

#include "insertion_attempt.hpp"

namespace swage::lesson_insertion {
namespace {

TEST(InsertionJudge, APerfectInsertionHasFullMarks) {
  Attempt a;
  EXPECT_EQ(a.go().stage, Stage::kTake);
  a.hold();
  EXPECT_EQ(a.go().stage, Stage::kAim);
  EXPECT_EQ(a.enter().stage, Stage::kDrive);
  const Finding end = a.drive(0.36, 200, 0);
  EXPECT_EQ(end.end, End::kPassed);
  EXPECT_EQ(end.stage, Stage::kDone);
  EXPECT_EQ(end.score, 100);
}

TEST(InsertionJudge, NearMeansBesideTheMarkAndNotFarAbove) {
  Attempt a;
  a.hold();
  a.now.point_W = Vec3(0.2e-3, 0, 0.5e-3);
  EXPECT_TRUE(a.go().near);
  a.now.point_W = Vec3(0.4e-3, 0, 0.5e-3);
  EXPECT_FALSE(a.go().near);
  a.now.point_W = Vec3(0, 0, 3e-3);
  EXPECT_FALSE(a.go().near);
  a.now.point_W = Vec3::Zero();
  a.now.held = false;
  EXPECT_FALSE(a.go().near);
}

TEST(InsertionJudge, TheAngleIsWeightedByTheWayAndNotByTheTime) {
  Rules rules;
  rules.drive = 0.9;
  Attempt a(rules);
  a.hold();
  a.enter();
  // half of the way at 10 deg, half at 20 deg, and a long rest at 60 deg
  a.drive(0.2, 50, 10 * kDegree);
  a.now.angle = 60 * kDegree;
  a.go(5000);
  a.drive(0.4, 400, 20 * kDegree);
  EXPECT_NEAR(angle_rms(a.memory) / kDegree, std::sqrt((100 + 400) / 2.0), 1e-9);
  EXPECT_NEAR(a.memory.travel, 0.4 * 4e-3, 1e-15);
  EXPECT_NEAR(a.memory.travel_in, 0.2 * 4e-3, 1e-15);  // 10 deg is within 15, 20 is not
}

// what the cue says is wrong for most of the way is not passed
TEST(InsertionJudge, ANeedleThatLeansForMostOfItsWayDoesNotPass) {
  for (const double mended : {0.17, 0.19}) {
    Attempt a;
    a.hold();
    a.enter(Vec3::Zero(), 20 * kDegree);
    a.drive(mended, 100, 20 * kDegree);
    const Finding end = a.drive(0.36, 100, 2 * kDegree);
    EXPECT_EQ(end.end, mended < 0.18 ? End::kPassed : End::kOffAngle);
    EXPECT_EQ(end.score <= 40, mended > 0.18);
  }
  Rules rules;
  rules.least_in_angle = 0;
  Attempt any(rules);
  any.hold();
  any.enter();
  EXPECT_EQ(any.drive(0.36, 100, 20 * kDegree).end, End::kPassed);
}

TEST(InsertionJudge, BendingTheNeedleCostsPoints) {
  const auto lost = [](double bending) {
    Attempt a;
    a.hold();
    a.enter();
    a.now.bending = bending;
    a.go();
    a.now.bending = 0.1;
    return a.drive(0.36, 100, 0).lost.bending;
  };
  EXPECT_EQ(lost(0.7), 0);
  EXPECT_NEAR(lost(0.85), 10, 1e-12);
  EXPECT_EQ(lost(1.5), 20);
}

TEST(InsertionJudge, TheThesissCosineIsAMeanOverTime) {
  Rules rules;
  rules.drive = 0.9;
  Attempt a(rules);
  a.hold();
  a.enter(Vec3::Zero(), 30 * kDegree);  // one step
  a.now.angle = 0;
  a.now.cosine = 0;
  a.go(3);
  EXPECT_NEAR(a.memory.cosine_s / a.memory.inside_s, 0.5 / 4, 1e-12);
}

TEST(InsertionJudge, TheEntryIsMeasuredAlongTheSurface) {
  Attempt a;
  a.hold();
  // 0.3 mm along, 0.4 mm of dimple
  EXPECT_FALSE(a.enter(Vec3(0.2e-3, 0.1e-3, -0.4e-3)).missed);
  EXPECT_NEAR(a.memory.entry_distance, std::sqrt(0.05) * 1e-3, 1e-15);
}

TEST(InsertionJudge, AWrongPlaceFailsInTheEndAndMayBeMended) {
  Attempt a;
  a.hold();
  EXPECT_TRUE(a.enter(Vec3(1e-3, 0, 0)).missed);
  EXPECT_EQ(a.drive(0.2, 20, 0).end, End::kRunning);
  // out again, and in at the mark
  a.now.in_tissue = false;
  a.go();
  EXPECT_FALSE(a.enter().missed);
  EXPECT_EQ(a.drive(0.36, 20, 0).end, End::kPassed);

  Attempt b;
  b.hold();
  b.enter(Vec3(1e-3, 0, 0));
  const Finding end = b.drive(0.36, 20, 0);
  EXPECT_EQ(end.end, End::kMissed);
  EXPECT_EQ(end.score, 0);
}

/// Lifted, let go and fallen, three times.
Finding drop_three_times(const Rules& rules) {
  Attempt a(rules);
  Finding f;
  for (int i = 0; i < 3; ++i) {
    a.hold();
    a.now.needle_W = Vec3(0, 0, 10e-3);
    a.go();
    a.now.held = false;
    a.now.needle_W = Vec3(0, 0, 5e-3);
    f = a.go();
  }
  return f;
}

TEST(InsertionJudge, EachWayToFail) {
  Attempt torn;
  torn.hold();
  torn.enter();
  torn.now.wound = 7;
  EXPECT_EQ(torn.go().end, End::kTorn);

  Attempt deflected;
  deflected.hold();
  Finding f;
  for (int i = 0; i < 6; ++i) {
    EXPECT_EQ(f.end, End::kRunning);
    for (int skip = 0; skip < 3; ++skip) {  // a point that skips along the surface is turned away once
      deflected.now.deflected = true;
      f = deflected.go();
    }
    if (f.end == End::kRunning) f = deflected.go(1000);
  }
  EXPECT_EQ(f.end, End::kDeflected);

  EXPECT_EQ(drop_three_times(Rules()).end, End::kDropped);

  Rules rules;
  rules.max_time = 0.05;
  EXPECT_EQ(Attempt(rules).go(100).end, End::kOutOfTime);
}

// In practice the same is told and the attempt goes on; a needle that was driven in through a wound beyond the limit has not passed.
TEST(InsertionJudge, InPracticeNoLimitEndsIt) {
  Rules practice;
  practice.ends = false;
  Attempt torn(practice);
  torn.hold();
  torn.enter();
  torn.now.wound = 7;
  Finding f = torn.go();
  EXPECT_EQ(f.end, End::kRunning);
  EXPECT_TRUE(f.torn);
  EXPECT_EQ(torn.drive(0.36, 20, 0).end, End::kTorn);

  Attempt far(practice);
  far.now.needle_W = Vec3(20e-3, 0, -30e-3);
  EXPECT_EQ(far.go().end, End::kRunning) << "it can be put back";

  EXPECT_EQ(drop_three_times(practice).end, End::kRunning);
}

TEST(InsertionJudge, WhatNobodyCanReachIsLost) {
  Attempt held;
  held.hold();
  held.now.needle_W = Vec3(0, 0, 31e-3);
  EXPECT_EQ(held.go(10).end, End::kRunning) << "in the jaws it may be carried anywhere";
  held.now.held = false;
  EXPECT_EQ(held.go().end, End::kLost);

  Attempt beside;  // a drop beyond the tray: it falls and falls
  beside.now.needle_W = Vec3(20e-3, 0, -20e-3);
  EXPECT_EQ(beside.go().end, End::kRunning);
  beside.now.needle_W = Vec3(20e-3, 0, -30e-3);
  EXPECT_EQ(beside.go().end, End::kLost);
}

TEST(InsertionJudge, WhatSticksInTheTissueIsNotDropped) {
  Attempt a;
  a.hold();
  a.enter();
  a.drive(0.2, 20, 0);
  a.now.held = false;
  a.now.needle_W = Vec3(0, 4e-3, 0);  // it may be pushed about
  const Finding f = a.go(10);
  EXPECT_TRUE(f.stuck);
  EXPECT_FALSE(f.dropped);
  EXPECT_EQ(a.memory.drops, 0);
}

TEST(InsertionJudge, StrayTouchesAreCountedOnceEach) {
  Attempt a;
  a.go();
  EXPECT_EQ(a.memory.stray.count, 0);
  a.now.needle_astray = true;
  a.go(5);
  a.now.needle_astray = false;
  EXPECT_EQ(a.memory.stray.count, 1);
  // the jaws, with a gap too short to count twice, and one that is not
  for (const int gap : {100, 200}) {
    a.now.jaws_astray = true;
    a.go(5);
    a.now.jaws_astray = false;
    a.go(gap);
  }
  EXPECT_EQ(a.memory.stray.count, 2);
  a.now.jaws_astray = true;
  a.go();
  EXPECT_EQ(a.memory.stray.count, 3);
}

TEST(InsertionJudge, PointsAreLostForWhatTheyAreLostFor) {
  const auto score = [](double wound, double angle, double off) {
    Rules rules;
    rules.least_in_angle = 0;
    Attempt a(rules);
    a.hold();
    a.enter(Vec3(off, 0, 0));
    a.now.wound = wound;
    return a.drive(0.36, 100, angle).score;
  };
  EXPECT_NEAR(score(2, 0, 0), 85, 1e-9);               // half of 30
  EXPECT_NEAR(score(1, 22.5 * kDegree, 0), 85, 1e-9);  // half of 30
  EXPECT_NEAR(score(1, 0, 0.15e-3), 92.5, 1e-9);       // half of 15
  EXPECT_EQ(score(5, 80 * kDegree, 0.3e-3), 40);       // passed is never less
}

TEST(InsertionJudge, TheForceSignStaysAWhile) {
  Attempt a;
  a.hold(2);
  EXPECT_TRUE(a.go().too_hard);
  a.now.force = 0.5;
  EXPECT_TRUE(a.go(200).too_hard);
  EXPECT_FALSE(a.go(200).too_hard);
}

}  // namespace
}  // namespace swage::lesson_insertion
