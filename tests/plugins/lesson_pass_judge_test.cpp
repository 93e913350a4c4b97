// SPDX-License-Identifier: Apache-2.0
//
// What counts as a pass from one gripper to the other: shared at the place for long enough, else snatched; drops, limits, score.
#include "lessons/pass/judge.hpp"

#include <gtest/gtest.h>

namespace swage::lesson_pass {
namespace {

/// An attempt told step by step.
struct Attempt {
  explicit Attempt(const Rules& rules = {}) : judge(rules, 1e-3) { now.place_distance = 1; }

  Finding go(int n) {
    Finding finding;
    for (int i = 0; i < n; ++i) {
      now.time_s = 1e-3 * step++;
      finding = judge.look(memory, now);
      if (finding.end != End::kRunning) break;
    }
    return finding;
  }
  void hold(int hand, double force = 0.6) { now.hand[hand].held = force > 0, now.hand[hand].force = force; }
  void let_go(int hand) { hold(hand, 0); }
  /// To the place with the one, and there for so many steps with both.
  Finding share(int from, int steps) {
    hold(from);
    go(100);
    now.place_distance = 0.5e-3;
    go(100);
    hold(1 - from);
    return go(steps);
  }

  Judge judge;
  Memory memory;
  Look now;
  int step = 0;
};

TEST(PassJudge, FromEitherHandToTheOtherThenHeldAlone) {
  for (const int from : {0, 1}) {
    Attempt a;
    EXPECT_EQ(a.go(10).stage, Stage::kTake);
    a.hold(from);
    EXPECT_EQ(a.go(10).stage, Stage::kBring);
    a.let_go(from);
    EXPECT_FALSE(a.share(from, 299).may_let_go);
    EXPECT_TRUE(a.go(2).may_let_go);
    EXPECT_EQ(a.go(1).stage, Stage::kPass);
    a.let_go(from);
    EXPECT_TRUE(a.go(1).passed_on);
    EXPECT_EQ(a.memory.owner, 2 - from);
    EXPECT_EQ(a.go(1990).end, End::kRunning);
    const Finding end = a.go(100);
    EXPECT_EQ(end.end, End::kPassed);
    EXPECT_EQ(end.score, 100);
    EXPECT_EQ(a.memory.passes, 1);
    EXPECT_EQ(a.memory.snatches, 0);
  }
}

TEST(PassJudge, TooShortOrNotAtThePlaceIsSnatched) {
  Attempt brief;
  brief.share(0, 200);
  brief.let_go(0);
  EXPECT_TRUE(brief.go(1).snatched);
  EXPECT_EQ(brief.memory.passes, 0);
  Attempt elsewhere;
  elsewhere.hold(0);
  elsewhere.go(10);
  elsewhere.hold(1);
  EXPECT_FALSE(elsewhere.go(1000).may_let_go);
  elsewhere.let_go(0);
  EXPECT_TRUE(elsewhere.go(1).snatched);
  // and back again at the place: that is a pass, with points lost
  EXPECT_TRUE(elsewhere.share(1, 400).may_let_go);
  elsewhere.let_go(1);
  elsewhere.go(1);
  const Finding end = elsewhere.go(3000);
  EXPECT_EQ(end.end, End::kPassed);
  EXPECT_EQ(end.score, 90);
}

TEST(PassJudge, ABentNeedleCostsPoints) {
  Attempt a;
  a.now.bending = 1;
  a.share(0, 400);
  a.let_go(0);
  EXPECT_EQ(a.go(3000).score, 80);
}

TEST(PassJudge, ThrownAndCaughtIsNoPass) {
  Attempt a;
  a.hold(0);
  a.now.place_distance = 0;
  a.go(500);
  a.let_go(0);
  a.go(100);
  a.hold(1);
  EXPECT_TRUE(a.go(1).snatched);
}

TEST(PassJudge, ADropBeginsAnew) {
  Attempt a;
  a.share(0, 200);
  a.let_go(0);
  a.let_go(1);
  a.now.needle_W = {0, 0, -5e-3};
  EXPECT_TRUE(a.go(1).dropped);
  EXPECT_EQ(a.memory.owner, 0);
  EXPECT_EQ(a.go(10).stage, Stage::kTake);
  a.hold(1);
  EXPECT_FALSE(a.go(1).snatched) << "whoever picks it up has taken it";
}

TEST(PassJudge, BothPassesAreAskedFor) {
  Rules rules;
  rules.passes = 2;
  Attempt a(rules);
  a.share(0, 400);
  a.let_go(0);
  EXPECT_EQ(a.go(3000).end, End::kRunning);
  a.share(1, 400);
  a.let_go(1);
  EXPECT_EQ(a.go(3000).end, End::kPassed);
}

TEST(PassJudge, TooHardEndsATestAndNotPractice) {
  for (const bool ends : {true, false}) {
    Rules rules;
    rules.ends = ends;
    Attempt a(rules);
    a.hold(1, 1.5);
    const Finding finding = a.go(4000);
    EXPECT_EQ(finding.end, ends ? End::kTooHard : End::kRunning);
    EXPECT_TRUE(finding.too_hard[1]);
    EXPECT_FALSE(finding.too_hard[0]);
  }
}

}  // namespace
}  // namespace swage::lesson_pass
