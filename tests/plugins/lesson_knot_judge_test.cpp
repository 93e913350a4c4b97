// SPDX-License-Identifier: Apache-2.0
//
// What counts as a knot on a wound: the word that is asked for or its mirror image, flat, drawn down, with the edges together; limits, score.
#include "lessons/knot/judge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "knot_attempt.hpp"

namespace swage::lesson_knot {
namespace {

TEST(KnotJudge, AKnotThatIsKeptDrawnDownPasses) {
  for (const double sign : {1.0, -1.0}) {
    Attempt a;
    a.tie(word({sign}));
    EXPECT_EQ(a.go(900).stage, Stage::kHold);
    const Finding end = a.go(200);
    EXPECT_EQ(end.end, End::kPassed);
    EXPECT_EQ(end.score, 100);
  }
}

TEST(KnotJudge, PhasesFollowWhatTheHandsHave) {
  Attempt a;
  a.hold(0);
  EXPECT_EQ(a.go(5).stage, Stage::kTake);
  a.now.grip[0] = 0.3, a.now.held[0] = true;
  EXPECT_EQ(a.go(5).stage, Stage::kWind);
  a.now.turns = -0.9;
  EXPECT_EQ(a.go(5).stage, Stage::kTail);
  a.now.grip[1] = 0.3, a.now.held[1] = true;
  EXPECT_EQ(a.go(5).stage, Stage::kDraw);
  a.now.word = word({1}), a.now.loop = 9e-3;
  EXPECT_EQ(a.go(5).stage, Stage::kLay);
}

TEST(KnotJudge, WhatIsLooseOpenOrSlidesIsNotKept) {
  const auto held = [](auto&& spoil) {
    Attempt a;
    a.tie(word({1}));
    spoil(a.now);
    a.go(3000);
    return a.memory.best_hold_s;
  };
  EXPECT_GT(held([](Look&) {}), 0.9);
  EXPECT_EQ(held([](Look& now) { now.gap = 0.2e-3; }), 0);
  EXPECT_EQ(held([](Look& now) { now.loop = 8e-3; }), 0);
  EXPECT_EQ(held([](Look& now) { now.sliding = 1; }), 0);
  EXPECT_EQ(held([](Look& now) { now.tangled = true; }), 0);
  EXPECT_LT(held([](Look& now) { now.tension = 50e-3; }), 0.2) << "until it is seen";
  EXPECT_LT(held([](Look& now) { now.grip[1] = 2; }), 0.2);
}

// turns slide off one by one: with another one still on the instrument a double throw is tied as a single one for a while
TEST(KnotJudge, AThrowWhoseTurnsAreStillOnTheInstrumentIsNotWrong) {
  Rules rules;
  rules.asked = word({2, -1, 1});
  for (const double side : {1.0, -1.0}) {
    Attempt a(rules);
    a.now.word = word({side}), a.now.turns = -1.5;
    EXPECT_FALSE(a.go(300).wrong);
    EXPECT_EQ(a.memory.wrong, 0);
    a.now.turns = -0.1;
    EXPECT_FALSE(a.go(500).wrong) << "the turn that has just slid off is not told yet";
    EXPECT_TRUE(a.go(600).wrong) << "a single throw is all there is";
    EXPECT_EQ(a.memory.wrong, 1);
    a.now.word = word({2 * side});
    EXPECT_FALSE(a.go(10).wrong);
  }
  for (const auto& [tied, wrong] : {std::pair{word({2, 1}), true}, {word({-2, 1}), false}, {word({3}), true}, {word({1, -1}), true}}) {
    Attempt a(rules);
    a.now.word = tied, a.now.turns = -1.5;
    EXPECT_EQ(a.go(10).wrong, wrong) << tied.turns[0] << " " << tied.turns[1];
  }
}

// a turn that still lies on the instrument is told as a throw one time and not the next; a throw below it that comes undone meanwhile counts
TEST(KnotJudge, OnlyAThrowWhoseTurnsHaveLeftTheInstrumentComesUndone) {
  Rules rules;
  rules.asked = word({2, -1, 1});
  Attempt a(rules);
  a.now.word = word({2, -1});
  a.go(10);
  a.now.turns = -1.4;
  a.go(10);
  for (int i = 0; i < 2; ++i) {
    a.now.word = word({2, -1, 1});
    a.go(100);
    a.now.word = word({2, -1});
    EXPECT_FALSE(a.go(1).undone) << "its turn is still wound";
  }
  a.now.word = word({2});
  EXPECT_TRUE(a.go(1).undone) << "the second throw was tied before";
  a.now.word = word({2, -1, 1}), a.now.turns = 0;
  a.go(1100);
  a.now.word = word({2, -1});
  EXPECT_TRUE(a.go(1).undone);
  EXPECT_EQ(a.memory.undone, 2);
}

// of the throws of a surgeon's knot one may slide
TEST(KnotJudge, AKnotMayHaveAsManySlidingThrowsAsItsLessonAllows) {
  Rules rules;
  rules.asked = word({2, -1, 1}), rules.most_sliding = 1;
  for (const double sliding : {0.0, 1.0, 2.0}) {
    Attempt a(rules);
    a.tie(word({2, -1, 1}));
    a.now.sliding = sliding;
    EXPECT_EQ(a.go(1200).end, sliding < 2 ? End::kPassed : End::kRunning) << sliding;
  }
}

// before its last draw a square knot has both throws, closed edges and a short loop, with the second throw open or off the first one
TEST(KnotJudge, AKnotWithALooseThrowIsNotKept) {
  Rules rules;
  rules.asked = word({1, -1});
  Attempt a(rules);
  a.tie(word({1, -1}));
  a.now.loosest = 4.5e-3;
  const Finding loose = a.go(5000);
  EXPECT_EQ(loose.end, End::kRunning);
  EXPECT_EQ(loose.stage, Stage::kLay);
  EXPECT_TRUE(loose.tied && loose.together && loose.loose);
  EXPECT_EQ(a.memory.best_hold_s, 0);
  a.now.loosest = 1.5e-3;
  EXPECT_EQ(a.go(1100).end, End::kPassed);
}

TEST(KnotJudge, AGrannyIsNoSquareKnot) {
  Rules rules;
  rules.asked = word({1, -1});
  for (const double sign : {1.0, -1.0}) {
    Attempt square(rules), granny(rules);
    square.tie(word({sign, -sign}));
    EXPECT_EQ(square.go(1100).end, End::kPassed);
    granny.tie(word({sign, sign}));
    const Finding finding = granny.go(1100);
    EXPECT_EQ(finding.end, End::kRunning);
    EXPECT_TRUE(finding.wrong);
    EXPECT_EQ(granny.memory.wrong, 1);
    EXPECT_EQ(granny.memory.most_like, 1);
  }
}

// a wrong throw may be undone while others are to come, and a knot with all its throws for ten seconds
TEST(KnotJudge, AnotherKnotThatStaysFailsATest) {
  for (const bool ends : {true, false}) {
    Rules rules;
    rules.asked = word({1, -1}), rules.ends = ends;
    Attempt a(rules);
    a.tie(word({2}));
    EXPECT_EQ(a.go(12000).end, End::kRunning);
    a.tie(word({1, 1}));
    EXPECT_EQ(a.go(9000).end, End::kRunning);
    a.tie(word({1}));
    a.go(10);
    a.tie(word({1, 1}));
    EXPECT_EQ(a.go(9990).end, End::kRunning);
    const Finding finding = a.go(20);
    EXPECT_EQ(finding.end, ends ? End::kWrong : End::kRunning);
    EXPECT_LE(finding.score, 40);
  }
}

TEST(KnotJudge, AThrowThatComesUndoneCosts) {
  Attempt a;
  a.tie(word({1}));
  a.go(500);
  a.now.word = {};
  EXPECT_TRUE(a.go(1).undone);
  EXPECT_FALSE(a.go(1).undone);
  a.tie(word({1}));
  const Finding end = a.go(1100);
  EXPECT_EQ(end.end, End::kPassed);
  EXPECT_EQ(end.score, 90);
}

TEST(KnotJudge, WhatEndsAnAttempt) {
  const auto end = [](auto&& spoil) {
    Attempt a;
    a.tie(word({1}));
    a.go(500);
    spoil(a.now);
    const Finding finding = a.go(1);
    EXPECT_LE(finding.score, 40);
    return finding.end;
  };
  EXPECT_EQ(end([](Look& now) { now.passages = 1; }), End::kPassage);
  EXPECT_EQ(end([](Look& now) { now.parted = 1; }), End::kBroken);
  EXPECT_EQ(end([](Look& now) { now.through = false; }), End::kDrawnOut);
  EXPECT_EQ(end([](Look& now) { now.cut = 0.5e-3; }), End::kCut);
}

TEST(KnotJudge, LettingGoOfATiedThreadIsNoDrop) {
  Attempt a;
  for (int i = 0; i < 2; ++i) {
    a.hold(0.3), a.go(100);
    a.hold(0), a.go(100);
  }
  EXPECT_EQ(a.memory.drops, 2);
  a.hold(0.3), a.go(100);
  a.tie(word({1})), a.now.gap = 0.4e-3;
  a.go(100);
  a.hold(0), a.go(100);
  EXPECT_EQ(a.memory.drops, 2);
}

// jaws that stay closed with nothing left between them have lost the thread: by what they hold and not by what they do
TEST(KnotJudge, ALongEndThatIsDrawnOutOfClosedJawsIsADrop) {
  const auto drops = [](const Word& tied, int jaws) {
    Attempt a;
    a.now.word = tied;
    a.go(100);
    for (const double force : {0.2, 0.1, 0.05, 0.01}) a.now.grip[jaws] = force, a.go(1);  // as it slips out
    a.now.grip[jaws] = 0, a.now.held[jaws] = false;
    a.go(500);
    EXPECT_EQ(a.memory.has[jaws], 0);
    return a.memory.drops;
  };
  EXPECT_EQ(drops(word({}), 0), 1);
  EXPECT_EQ(drops(word({1}), 0), 0) << "all is tied";
  EXPECT_EQ(drops(word({}), 1), 0) << "of the tail no drop is told";
  // told while it is still said to be held, without force
  Attempt a;
  a.go(100);
  a.now.grip[0] = 0;
  EXPECT_TRUE(a.go(1).dropped);
  EXPECT_EQ(a.go(100).stage, Stage::kTake);
  EXPECT_EQ(a.memory.drops, 1);
}

/// Both ends held and the first of two throws tied; the jaws that wind then let go with what the hand and the thread did, for `away` ms.
Attempt let_go(double squeeze, double tension, double turns, double throws, int away) {
  Rules rules;
  rules.asked = word({2, -1});
  Attempt a(rules);
  a.now.squeeze = 0.3;
  if (throws > 0) a.now.word = word({2});
  a.now.tension_grip = tension, a.now.turns = turns;
  a.go(100);
  for (const double force : {0.2, 0.1, 0.04, 0.0}) a.now.grip[0] = force, a.now.squeeze = std::min(0.3, squeeze + force), a.go(1);
  a.now.held[0] = false, a.now.tension_grip = 0;
  a.go(away);
  return a;
}

// a surgeon lays the long end down between two throws and takes it nearer to the knot
TEST(KnotJudge, ALongEndLaidDownBetweenTwoThrowsAndTakenAnewIsNoDrop) {
  Attempt a = let_go(0, 1e-3, 0.1, 1, 14000);
  EXPECT_EQ(a.memory.drops, 0);
  EXPECT_EQ(a.memory.regrasps, 0);
  a.hold(0.3), a.go(100);
  EXPECT_EQ(a.memory.drops, 0);
  EXPECT_EQ(a.memory.regrasps, 1);
  a.go(20000);
  EXPECT_EQ(a.memory.drops, 0) << "taken anew";
  EXPECT_EQ(a.memory.regrasps, 1);
  Attempt gone = let_go(0, 1e-3, 0.1, 1, 16000);
  EXPECT_EQ(gone.memory.drops, 1) << "not taken anew within 15 s";
  gone.hold(0.3), gone.go(100);
  EXPECT_EQ(gone.memory.drops, 1);
  EXPECT_EQ(gone.memory.regrasps, 0);
}

TEST(KnotJudge, ALongEndThatSlipsOutOrIsDrawnOrWoundIsADrop) {
  EXPECT_EQ(let_go(0.3, 1e-3, 0, 1, 10).memory.drops, 1) << "the jaws stayed closed";
  EXPECT_EQ(let_go(0, 8e-3, 0, 1, 10).memory.drops, 1) << "it was drawn, and springs";
  EXPECT_EQ(let_go(0, 1e-3, -0.9, 1, 10).memory.drops, 1) << "wound about the holder";
  EXPECT_EQ(let_go(0, 1e-3, 0, 0, 10).memory.drops, 1) << "nothing is tied that would stay";
  // a gripper that does not tell what the hand puts on its jaws
  EXPECT_EQ(let_go(1e300, 1e-3, 0, 1, 10).memory.drops, 1);
}

TEST(KnotJudge, GrippingTooHardEndsATestAndNotPractice) {
  for (const bool ends : {true, false}) {
    Rules rules;
    rules.ends = ends;
    Attempt a(rules);
    a.hold(1.5);
    const Finding finding = a.go(4000);
    EXPECT_EQ(finding.end, ends ? End::kTooHard : End::kRunning);
    EXPECT_TRUE(finding.too_hard[0] && finding.too_hard[1]);
  }
}

}  // namespace
}  // namespace swage::lesson_knot
