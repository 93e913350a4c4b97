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
      EXPECT_EQ(a.go(1000).end, End::kRunning) << "the loop is long still";
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

}  // namespace
}  // namespace swage::lesson_insertion
