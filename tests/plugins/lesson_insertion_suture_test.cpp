// SPDX-License-Identifier: Apache-2.0
//
// The insertion lesson with a thread: grasps at the swage, the tail, and what pulls the thread off.
#include <gtest/gtest.h>

#include "insertion_attempt.hpp"

namespace swage::lesson_insertion {
namespace {

/// Each grasp at the swage is one, however long it lasts; it costs 15 points.
TEST(InsertionJudge, AGraspAtTheSwageDamagesTheSuture) {
  Rules rules;
  rules.suture.there = true;  // 0.5 mm of 4 mm: from s = 0.875 on
  Attempt a(rules);
  a.hold();
  a.now.grip_s = 0.87;
  EXPECT_FALSE(a.go().damaged);
  a.now.grip_s = 0.88;
  EXPECT_TRUE(a.go().damaged);
  const Finding still = a.go(100);
  EXPECT_FALSE(still.damaged);
  EXPECT_TRUE(still.swage_held);
  a.now.grip_s = 0.5;
  EXPECT_FALSE(a.go().swage_held);
  EXPECT_EQ(a.memory.suture.grasps, 1);
  a.enter();
  const Finding end = a.drive(0.36, 200, 0);
  EXPECT_EQ(end.end, End::kPassed);
  EXPECT_EQ(end.lost.suture, 15);
  EXPECT_EQ(end.score, 85);
}

/// The tail must keep its length for half a second; drawn too far, or out of the needle, the attempt fails.
TEST(InsertionJudge, AStitchWithThreadEndsWithItsTail) {
  Rules rules;
  rules.task = Task::kStitch;
  rules.suture.there = true;
  rules.suture.tail = 10e-3;
  const auto through = [&] {
    Attempt a(rules);
    a.stitch();
    a.now.suture.state = 2, a.now.suture.tail = 20e-3;
    return a;
  };
  Attempt done = through();
  EXPECT_EQ(done.go(1000).end, End::kRunning);
  EXPECT_EQ(done.go().stage, Stage::kDraw) << "the needle is through, its thread is not";
  done.now.suture.tail = 10.5e-3;
  EXPECT_EQ(done.go(499).end, End::kRunning);
  EXPECT_EQ(done.go(2).end, End::kPassed);
  EXPECT_EQ(done.memory.suture.tail, 10.5e-3);
  Attempt far = through();
  far.now.suture.tail = 8.9e-3;
  EXPECT_EQ(far.go().end, End::kTailLost);
  Attempt off = through();
  off.now.suture.pulled_off = true;
  EXPECT_EQ(off.go().end, End::kPulledOff);
}

/// Each loop must keep its length for half a second before the next bite is asked for; unequal ones and a hard pull cost points.
TEST(InsertionJudge, ARunningSutureIsDrawnLoopByLoop) {
  const auto sewn = [](double second_loop, double tension) {
    Rules rules;
    rules.task = Task::kStitch;
    rules.stitches = 2;
    rules.suture.there = true;
    rules.suture.loop = 4e-3, rules.suture.tension = 10e-3;
    Attempt a(rules);
    Finding f;
    int done = 0;
    for (const double loop : {4e-3, second_loop}) {
      a.stitch();
      a.now.in_tissue = false;
      a.now.suture.state = 2, a.now.suture.loop = a.now.suture.loop_most = 9e-3;
      f = a.go(1000);
      EXPECT_EQ(f.end, End::kRunning) << "the loop is long still";
      EXPECT_EQ(f.stage, Stage::kDraw);
      a.now.suture.loop = loop, a.now.suture.tension = tension;
      a.now.suture.loop_most = 4e-3, a.now.suture.loop_least = std::min(4e-3, loop);
      f = a.go(499);
      EXPECT_EQ(f.taut, tension > 10e-3);
      EXPECT_TRUE(f.loop_good);
      EXPECT_FALSE(f.stitched);
      for (int i = 0; i < 2 && a.memory.stitch.count == done; ++i) f = a.go();
      EXPECT_EQ(a.memory.stitch.count, ++done);
      EXPECT_EQ(f.stitched, done == 1) << "the last one ends the attempt";
    }
    return f;
  };
  const Finding even = sewn(4e-3, 9e-3), uneven = sewn(3.6e-3, 15e-3);
  EXPECT_EQ(even.end, End::kPassed);
  EXPECT_EQ(even.lost.loops + even.lost.tension, 0);
  EXPECT_EQ(uneven.end, End::kPassed);
  EXPECT_NEAR(uneven.lost.loops, 15 * 2 * 0.1, 1e-9);
  EXPECT_NEAR(uneven.lost.tension, 15 * 0.5, 1e-9);
}

/// Stitches that are cut off one thread of 30 mm: both tails are judged, the second stitch begins where the first was cut off.
struct CutOff : Attempt {
  CutOff() : Attempt(asked()) {
    now.suture.length = 30e-3;
    sew(27e-3);
  }
  static Rules asked() {
    Rules rules;
    rules.task = Task::kStitch;
    rules.stitches = 2;
    rules.suture.there = rules.suture.cut = true;
    rules.suture.tail = 3e-3;
    return rules;
  }
  /// Through, and drawn until the entry is `entry` [m] from the needle; the wound is 1 mm wide.
  void sew(double entry) {
    now.suture.state = 1, now.suture.entry = now.suture.exit = 0;
    go();
    stitch();
    now.in_tissue = false;
    now.suture.state = 2, now.suture.entry = entry, now.suture.exit = entry - 1e-3;
  }
  Finding cut(double at) {
    now.suture.parted = true, now.suture.parted_at = at;
    const Finding f = go();
    now.suture.parted = false;
    return f;
  }
};

TEST(InsertionJudge, StitchesAreCutOffWithTheirTails) {
  CutOff a;
  EXPECT_EQ(a.go(600).stage, Stage::kCutOff);
  const Finding first = a.cut(23e-3);
  EXPECT_TRUE(first.stitched) << "26 - 23: 3 mm beyond the exit";
  EXPECT_NEAR(first.cut_tail, 3e-3, 1e-12);
  a.sew(20.2e-3);
  EXPECT_EQ(a.go(600).stage, Stage::kCutOff) << "23 - 20.2: 2.8 mm before the entry";
  const Finding last = a.cut(15.5e-3);
  EXPECT_EQ(last.end, End::kPassed);
  EXPECT_NEAR(a.memory.suture.cut_off.least, 2.8e-3, 1e-12);
  EXPECT_NEAR(a.memory.suture.cut_off.most, 3.7e-3, 1e-12);
  EXPECT_NEAR(last.lost.tails, 10 * (2 * 0.7 - 1), 1e-9);
}

TEST(InsertionJudge, ATailIsCutAgainWhereItIsTooLongAndLostWhereItIsTooShort) {
  CutOff longer;
  longer.go(600);
  EXPECT_FALSE(longer.cut(20e-3).stitched) << "6 mm";
  const Finding again = longer.cut(23e-3);
  EXPECT_TRUE(again.stitched);
  EXPECT_NEAR(longer.memory.suture.cut_off.end, 20e-3, 1e-12) << "the needle keeps what was cut off first";
  CutOff shorter;
  shorter.go(600);
  EXPECT_EQ(shorter.cut(24.5e-3).end, End::kTailLost) << "1.5 mm";
  CutOff entry;
  entry.now.suture.entry = 24e-3, entry.now.suture.exit = 23e-3;
  EXPECT_EQ(entry.go(600).stage, Stage::kDraw) << "6 mm before the entry";
  entry.cut(27e-3);
  EXPECT_EQ(entry.go(600).stage, Stage::kCutOff) << "cut to 3 mm";
  EXPECT_EQ(entry.memory.suture.cut_off.astray, 0);
}

TEST(InsertionJudge, ACutAstrayCostsPointsOrTheStitch) {
  CutOff within;
  within.go(600);
  within.cut(26.5e-3);  // between entry and exit
  EXPECT_EQ(within.memory.suture.cut_off.astray, 1);
  Attempt early{CutOff::asked()};
  early.now.suture.length = 30e-3, early.now.suture.state = 1, early.now.suture.entry = 5e-3;
  early.go();
  early.now.suture.parted = true, early.now.suture.parted_at = 2e-3;
  EXPECT_EQ(early.go().end, End::kTailLost) << "the needle is cut off before it is through";
}

}  // namespace
}  // namespace swage::lesson_insertion
