// SPDX-License-Identifier: Apache-2.0
//
// What counts as a thread wound about an instrument: turns kept on and drawn; slips, drops, pulls, limits, score.
#include "lessons/loop/judge.hpp"

#include <gtest/gtest.h>

namespace swage::lesson_loop {
namespace {

/// An attempt told step by step.
struct Attempt {
  explicit Attempt(const Rules& rules = {}) : judge(rules, 1e-3) {}

  Finding go(int n) {
    Finding finding;
    for (int i = 0; i < n; ++i) {
      now.time_s = 1e-3 * step++;
      finding = judge.look(memory, now);
      if (finding.end != End::kRunning) break;
    }
    return finding;
  }
  void hold(double force = 0.3) { now.held = force > 0, now.force = force; }
  void wind(double turns, double draw = 1e-3) { now.turns = now.whole = turns, now.draw = draw, now.tension = draw; }

  Judge judge;
  Memory memory;
  Look now;
  int step = 0;
};

TEST(LoopJudge, TurnsThatAreKeptDrawnPass) {
  for (const double sign : {1.0, -1.0}) {
    Attempt a;
    EXPECT_EQ(a.go(10).stage, Stage::kTake);
    a.hold();
    EXPECT_EQ(a.go(10).stage, Stage::kWind);
    a.wind(sign);
    const Finding on = a.go(1900);
    EXPECT_TRUE(on.on);
    EXPECT_EQ(on.stage, Stage::kHold);
    EXPECT_EQ(on.end, End::kRunning);
    const Finding end = a.go(200);
    EXPECT_EQ(end.end, End::kPassed);
    EXPECT_EQ(end.score, 100);
  }
}

TEST(LoopJudge, OneIsNotTwoAndThreeAreNotEither) {
  Rules rules;
  rules.turns = 2;
  Attempt a(rules);
  a.hold();
  a.wind(1);
  EXPECT_FALSE(a.go(5000).on);
  a.wind(3);
  const Finding many = a.go(5000);
  EXPECT_TRUE(many.too_many);
  EXPECT_FALSE(many.on);
  a.wind(2);
  EXPECT_EQ(a.go(2100).end, End::kPassed);
  EXPECT_EQ(a.memory.slips, 0) << "one too many taken off is no slip";
}

TEST(LoopJudge, TheSenseThatIsAskedFor) {
  Rules rules;
  rules.sense = -1;
  Attempt a(rules);
  a.hold();
  a.wind(1);
  EXPECT_FALSE(a.go(5000).on);
  a.wind(-1);
  EXPECT_EQ(a.go(2100).end, End::kPassed);
}

TEST(LoopJudge, SlackOrLetGoIsNotKept) {
  Attempt slack;
  slack.hold();
  slack.wind(1, 0.05e-3);
  EXPECT_EQ(slack.go(5000).end, End::kRunning);
  EXPECT_EQ(slack.memory.best_hold_s, 0);
  Attempt alone;
  alone.wind(1);
  EXPECT_EQ(alone.go(5000).end, End::kRunning);
}

TEST(LoopJudge, ATurnThatSlidesOffCosts) {
  Attempt a;
  a.hold();
  a.wind(1);
  a.go(1000);
  a.wind(0.2);
  a.now.whole = 0;
  EXPECT_TRUE(a.go(1).slipped);
  EXPECT_FALSE(a.go(1).slipped);
  a.wind(1);
  const Finding end = a.go(3000);
  EXPECT_EQ(end.end, End::kPassed);
  EXPECT_EQ(end.score, 90);
}

TEST(LoopJudge, PullingTooHardIsShownAndCosts) {
  Attempt a;
  a.hold();
  a.wind(1, 50e-3);
  EXPECT_TRUE(a.go(2000).taut);
  EXPECT_LT(a.memory.best_hold_s, 0.2) << "until it is seen";
  a.wind(1);
  const Finding end = a.go(4000);
  EXPECT_EQ(end.end, End::kPassed);
  EXPECT_NEAR(end.lost.tension, 40 * 2.0 / 4.3, 3);
}

TEST(LoopJudge, WhatEndsAnAttempt) {
  Attempt broken;
  broken.hold();
  broken.now.parted = 1;
  EXPECT_EQ(broken.go(1).end, End::kBroken);
  Attempt passage;
  passage.hold();
  passage.wind(1);
  passage.go(1000);
  passage.now.passages = 1;
  const Finding end = passage.go(1);
  EXPECT_EQ(end.end, End::kPassage) << "and is never passed";
  EXPECT_LE(end.score, 40);
  for (const bool ends : {true, false}) {
    Rules rules;
    rules.ends = ends;
    Attempt lost(rules);
    for (int i = 0; i < 3; ++i) {
      lost.hold();
      lost.go(100);
      lost.hold(0);
      lost.go(100);
    }
    EXPECT_EQ(lost.memory.drops, 3);
    EXPECT_EQ(lost.go(1).end, ends ? End::kDropped : End::kRunning);
  }
}

TEST(LoopJudge, GrippingTooHardEndsATestAndNotPractice) {
  for (const bool ends : {true, false}) {
    Rules rules;
    rules.ends = ends;
    Attempt a(rules);
    a.hold(1.5);
    a.wind(1);
    const Finding finding = a.go(4000);
    EXPECT_EQ(finding.end, ends ? End::kTooHard : End::kRunning);
    EXPECT_TRUE(finding.too_hard);
  }
}

}  // namespace
}  // namespace swage::lesson_loop
