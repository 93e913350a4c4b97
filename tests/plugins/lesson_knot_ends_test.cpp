// SPDX-License-Identifier: Apache-2.0
//
// Ends that a lesson wants cut to length: what counts as cut, what costs, and what ends the attempt.
#include <gtest/gtest.h>

#include <cmath>

#include "knot_attempt.hpp"

namespace swage::lesson_knot {
namespace {

Rules ends_are_cut() {
  Rules rules;
  rules.asked = word({1, -1}), rules.cut = true, rules.tail = 3e-3, rules.tail_tolerance = 1e-3;
  return rules;
}

TEST(KnotJudge, BothEndsAreCutToLengthAndTheKnotKeepsWithoutTheHands) {
  Attempt a(ends_are_cut());
  a.tie(word({1, -1}));
  EXPECT_EQ(a.go(900).stage, Stage::kHold);
  EXPECT_EQ(a.go(1000).stage, Stage::kCutEnds) << "kept, and not done";
  EXPECT_TRUE(a.cut(23e-3).cut);
  EXPECT_NEAR(a.memory.end[1], 3e-3, 1e-9) << "m, the tail";
  EXPECT_EQ(a.go(2000).stage, Stage::kCutEnds) << "the long end is still there";
  EXPECT_TRUE(a.cut(7.5e-3).cut);
  EXPECT_EQ(a.go(2000).stage, Stage::kCutEnds) << "4.5 mm are too long";
  EXPECT_FALSE(a.judge.end_good(a.memory, 0));
  EXPECT_TRUE(a.cut(9.2e-3).cut);
  EXPECT_NEAR(a.memory.end[0], 2.8e-3, 1e-9);
  a.hold(0);
  EXPECT_EQ(a.go(900).end, End::kRunning) << "it is to keep anew";
  const Finding end = a.go(200);
  EXPECT_EQ(end.end, End::kPassed);
  EXPECT_EQ(end.lost.tails, 0) << "half of the tolerance costs nothing";
  EXPECT_EQ(end.score, 100);
}

// the form is judged while hands draw the ends: ends that are slack or short tell none
TEST(KnotJudge, AKnotThatWasKeptFlatMayBeToldAsSlidingAsItsEndsAreCut) {
  for (const bool was_flat : {true, false}) {
    Attempt a(ends_are_cut());
    a.tie(word({1, -1}));
    a.now.sliding = was_flat ? 0 : 1;
    a.go(1100);
    a.now.sliding = 1;
    EXPECT_EQ(a.go(10).stage, was_flat ? Stage::kCutEnds : Stage::kLay);
    a.cut(23e-3), a.cut(9e-3);
    EXPECT_EQ(a.go(1100).end, was_flat ? End::kPassed : End::kRunning);
  }
}

TEST(KnotJudge, WhereACutEndsTheAttempt) {
  const auto end = [](double at, const Word& tied, const Rules& rules) {
    Attempt a(rules);
    a.tie(tied);
    a.go(500);
    const Finding finding = a.cut(at);
    EXPECT_TRUE(finding.end == End::kRunning || finding.score <= 40);
    return finding.end;
  };
  const Word square = word({1, -1});
  EXPECT_EQ(end(16e-3, square, ends_are_cut()), End::kSevered) << "in the loop";
  EXPECT_EQ(end(12.1e-3, square, ends_are_cut()), End::kSevered) << "in a throw";
  EXPECT_EQ(end(23e-3, word({1}), ends_are_cut()), End::kSevered) << "before all is tied";
  EXPECT_EQ(end(21.5e-3, square, ends_are_cut()), End::kTailShort);
  EXPECT_EQ(end(23e-3, square, ends_are_cut()), End::kRunning);
  Attempt torn(ends_are_cut());
  torn.tie(square), torn.go(500), torn.cut(23e-3);
  torn.now.parted = 2;
  EXPECT_EQ(torn.go(1).end, End::kBroken) << "more places have parted than were cut";
}

TEST(KnotJudge, AnEndOffByMoreThanHalfTheToleranceCosts) {
  Attempt a(ends_are_cut());
  a.tie(word({1, -1}));
  a.go(100), a.cut(23.75e-3), a.cut(9e-3);
  const Finding end = a.go(1100);
  EXPECT_EQ(end.end, End::kPassed);
  EXPECT_NEAR(end.lost.tails, 5, 1e-9);
  EXPECT_NEAR(end.score, 95, 1e-9);
}

// of an attempt that is not passed throws, hold and ends count a third each
TEST(KnotJudge, EndsCountWhereTheAttemptIsNotPassed) {
  Rules rules = ends_are_cut();
  rules.max_time = 2;
  Attempt a(rules);
  a.tie(word({1, -1}));
  a.go(1100), a.cut(23e-3), a.now.gap = 0.4e-3;
  const Finding end = a.go(2000);
  EXPECT_EQ(end.end, End::kOutOfTime);
  EXPECT_NEAR(end.score, 40 * (1 + 1 + 0.5) / 3, 1e-9);
}

}  // namespace
}  // namespace swage::lesson_knot
