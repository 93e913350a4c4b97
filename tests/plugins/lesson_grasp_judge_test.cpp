// SPDX-License-Identifier: Apache-2.0
//
// What counts as a good grasp: the four meanings, holds and their breaks, drops, limits, metrics and score.
#include <gtest/gtest.h>

#include <numbers>

#include "grasp_attempt.hpp"

namespace swage::lesson_grasp {
namespace {

TEST(Judge, FourMeanings) {
  const double tips = 1e-3, deep = 4e-3;
  EXPECT_EQ(Attempt().take(0.6, tips, 0.6).grade, Grade::kGood);
  EXPECT_EQ(Attempt().take(0.6, deep, 0.6).grade, Grade::kPointOnly);
  EXPECT_EQ(Attempt().take(0.3, tips, 0.6).grade, Grade::kTipsOnly);
  EXPECT_EQ(Attempt().take(0.3, deep, 0.6).grade, Grade::kWrong);
  Attempt none;
  none.now.s = 0.6;
  EXPECT_EQ(none.go().grade, Grade::kNone);
}

// where any tilt counts the cue still tells one that the other lessons would not allow
TEST(Judge, TellsATiltWhereItOnlyCostsPoints) {
  Attempt a;
  a.now.tilt_plane = 0.6;
  const Finding f = a.take(0.6, 1e-3, 0.6);
  EXPECT_EQ(f.grade, Grade::kTilted);
  EXPECT_EQ(f.stage, Stage::kHold);
  a.now.tilt_plane = 0.3;
  EXPECT_EQ(a.go().grade, Grade::kGood);
}

// the phases of practice tell what to do next; a test does not tell that the place is wrong
TEST(Judge, SaysWhatToDoAfterAWrongGraspAndAfterADrop) {
  Rules practice;
  practice.ends = false;
  Attempt a(practice);
  EXPECT_EQ(a.go().stage, Stage::kApproach);
  EXPECT_EQ(a.take(0.3, 1e-3, 0.6).stage, Stage::kRegrasp);
  EXPECT_EQ(Attempt().take(0.3, 1e-3, 0.6).stage, Stage::kGrasp);
  a.let_go();
  a.now.needle_W = Vec3(0, 0, -5e-3);
  a.go();
  EXPECT_EQ(a.go().stage, Stage::kDropped);
  a.now.needle_W.setZero();
  EXPECT_EQ(a.go().stage, Stage::kApproach) << "put back";
}

// M02: to the first touch, however often it is dropped after that
TEST(Judge, TheTimeToTheFirstTouchEndsThere) {
  Attempt a;
  for (int i = 0; i < 1000; ++i) {
    a.now.tip_W.x() = 5e-6 * i;  // 5 mm/s
    a.go();
  }
  EXPECT_LT(a.memory.touched_s, 0);
  a.take(0.6, 1e-3, 0.6);
  const double first = approach_time(a.memory);
  EXPECT_NEAR(first, 1 - a.memory.path.set_off_s, 2e-3);
  a.let_go();
  a.go(500);
  a.take(0.6, 1e-3, 0.6);
  EXPECT_EQ(approach_time(a.memory), first);
}

TEST(Judge, PassesAfterAnUnbrokenHold) {
  Attempt a;
  Finding f = a.take(0.6, 1e-3, 0.6);
  EXPECT_EQ(f.stage, Stage::kHold);
  EXPECT_TRUE(f.hold_began);
  f = a.go(2990);
  EXPECT_EQ(f.end, End::kRunning);
  f = a.go(20);
  EXPECT_EQ(f.end, End::kPassed);
  EXPECT_EQ(f.stage, Stage::kDone);
  EXPECT_NEAR(f.score, 100, 1e-9);
}

TEST(Judge, AWrongGraspEndsTheAttemptInTheEnd) {
  Attempt a;
  EXPECT_EQ(a.take(0.3, 1e-3, 0.6).end, End::kRunning);
  EXPECT_EQ(a.go(19990).end, End::kRunning);
  EXPECT_EQ(a.go(20).end, End::kWrongGrasp);
  // letting go in between starts the time again; 0 is never
  Attempt b;
  b.take(0.3, 1e-3, 0.6);
  b.go(15000);
  b.let_go();
  b.go(10);
  b.take(0.3, 1e-3, 0.6);
  EXPECT_EQ(b.go(15000).end, End::kRunning);
  Rules patient;
  patient.max_wrong_time = 0;
  Attempt c(patient);
  c.take(0.3, 1e-3, 0.6);
  EXPECT_EQ(c.go(60000).end, End::kRunning);
}

TEST(Judge, ANeedleOutOfReachEndsItAndOneThatIsBroughtBackCounts) {
  Attempt a;
  a.go(10);
  a.now.needle_W = {0, 0, -5e-3};
  EXPECT_TRUE(a.go().dropped);
  a.now.needle_W.setZero();
  a.now.reset = true;
  a.go();
  a.now.reset = false;
  EXPECT_EQ(a.memory.resets, 1);
  a.now.needle_W = {0, 0, -5e-3};
  EXPECT_TRUE(a.go().dropped) << "it lay at its start again";
  a.now.needle_W = {0, 0, -31e-3};
  EXPECT_EQ(a.go().end, End::kLost);
}

/// Held well, at a distance from the target.
struct Carried : Attempt {
  explicit Carried(Leave leave) : Attempt(rules(leave)) {
    now.target_distance = 3e-3;
    take(0.6, 1e-3, 0.6);
  }
  static Rules rules(Leave leave) {
    Rules r;
    r.target = {true, 0.5e-3, leave};
    return r;
  }
  Finding at(double distance, int n) {
    now.target_distance = distance;
    return go(n);
  }
};

TEST(Target, CarriedThenHeldAtTheTarget) {
  Carried a(Leave::kRestart);
  EXPECT_EQ(a.at(3e-3, 100).stage, Stage::kCarry);
  Finding f = a.at(0.4e-3, 1);
  EXPECT_TRUE(f.near_target && f.hold_began);
  f = a.at(0.54e-3, 500);
  EXPECT_EQ(f.stage, Stage::kHold) << "once in, a tenth more";
  EXPECT_EQ(a.at(0.4e-3, 3000).end, End::kPassed);
  EXPECT_NEAR(hold_error(a.memory.target), std::sqrt((0.501 * 0.54 * 0.54 + 2.5 * 0.4 * 0.4) / 3.001) * 1e-3,
              2e-6);
  EXPECT_EQ(in_target(a.memory.target), 1);
  EXPECT_EQ(a.memory.target.breaks, 0);
}

TEST(Target, LeavingStartsAgainPausesOrFails) {
  for (const Leave leave : {Leave::kRestart, Leave::kPause, Leave::kFail}) {
    Carried a(leave);
    a.at(0.1e-3, 2000);
    Finding f = a.at(0.6e-3, 1);
    EXPECT_TRUE(f.hold_broke);
    EXPECT_EQ(f.end, leave == Leave::kFail ? End::kLeftTarget : End::kRunning);
    if (leave == Leave::kFail) continue;
    f = a.at(0.1e-3, 1100);
    EXPECT_EQ(f.end, leave == Leave::kPause ? End::kPassed : End::kRunning);
    if (leave == Leave::kRestart) {
      EXPECT_EQ(a.at(0.1e-3, 2000).end, End::kPassed);
    }
    EXPECT_EQ(a.memory.target.breaks, 1);
    EXPECT_LT(in_target(a.memory.target), 1);
  }
}

TEST(Target, ABreakCostsFivePoints) {
  Carried smooth(Leave::kRestart), broken(Leave::kRestart);
  const double best = smooth.at(0.1e-3, 4000).score;
  broken.at(0.1e-3, 500);
  broken.at(1e-3, 10);
  EXPECT_NEAR(broken.at(0.1e-3, 4000).score, best - 5, 1e-9);
}

TEST(Judge, ABreakStartsTheHoldAgain) {
  Attempt a;
  a.take(0.6, 1e-3, 0.6);
  a.go(2900);
  a.now.s = 0.4;  // it slides out of the region
  Finding f = a.go();
  EXPECT_TRUE(f.hold_broke);
  a.now.s = 0.6;
  f = a.go(2900);
  EXPECT_EQ(f.end, End::kRunning);
  EXPECT_NEAR(a.memory.best_hold_s, 2.901, 1e-9);
  EXPECT_EQ(a.go(200).end, End::kPassed);
}

TEST(Judge, BendingTheNeedleCostsPoints) {
  for (const auto& [bending, lost] : {std::pair{0.7, 0.0}, {0.85, 10.0}, {3.0, 20.0}}) {
    Rules rules;
    rules.hold_time = 0.1;
    Attempt a(rules);
    a.go();
    a.now.bending = bending;
    a.take(0.6, 1e-3, 0.6);
    a.now.bending = 0;
    const Finding end = a.go(300);
    EXPECT_EQ(end.end, End::kPassed);
    EXPECT_NEAR(end.lost.bending, lost, 1e-12);
    EXPECT_NEAR(end.score, 100 - lost, 1e-9);
  }
}

TEST(Judge, PerpendicularityCanBeRequired) {
  Rules rules;
  rules.max_tilt = 0.3;
  Attempt a(rules);
  a.go();
  a.now.tilt_plane = -0.31;
  const Finding askew = a.take(0.6, 1e-3, 0.6);
  EXPECT_EQ(askew.grade, Grade::kTilted);
  EXPECT_EQ(askew.stage, Stage::kGrasp);
  a.now.tilt_plane = 0.29;
  EXPECT_EQ(a.go().grade, Grade::kGood);
  EXPECT_EQ(a.go().stage, Stage::kHold);
  a.now.tilt_axis = 0.32;  // in a hold a tenth more
  EXPECT_EQ(a.go().stage, Stage::kHold);
  a.now.tilt_axis = 0.34;
  EXPECT_TRUE(a.go().hold_broke);
  Attempt any;
  any.go();
  any.now.tilt_plane = 1;
  EXPECT_EQ(any.take(0.6, 1e-3, 0.6).stage, Stage::kHold) << "not asked: it is told, and the hold counts";
}

TEST(Judge, TheSignForTooMuchForceStaysAWhile) {
  Attempt a;
  EXPECT_TRUE(a.take(0.6, 1e-3, 1.1).too_hard);
  a.now.force = 0.5;
  EXPECT_TRUE(a.go(290).too_hard) << "less than 0.3 s";
  EXPECT_FALSE(a.go(20).too_hard);
  a.now.force = 1.1;
  a.go(400);
  a.now.force = 0.95;  // above nine tenths
  EXPECT_TRUE(a.go(400).too_hard);
  a.now.force = 0.85;
  EXPECT_FALSE(a.go().too_hard);
}

TEST(Judge, TooHardTooLongFails) {
  Attempt a;
  a.take(0.6, 1e-3, 1.5);
  const Finding f = a.go(2200);
  EXPECT_EQ(f.end, End::kTooHard);
  EXPECT_EQ(f.score, 0);
  // the filter needs some milliseconds to believe it
  EXPECT_NEAR(a.memory.over_s, 2.0, 2e-3);
  EXPECT_NEAR(a.memory.over_dose, 0.5 * 2.0, 0.03);
}

TEST(Judge, DropsAreCountedOnceEachAndEndTheAttempt) {
  Rules rules;
  rules.max_drops = 1;
  Attempt a(rules);
  a.go(10);
  a.take(0.6, 1e-3, 0.6);
  a.go(100);
  a.let_go();
  EXPECT_FALSE(a.go(100).dropped) << "let go, but it stays";
  a.now.needle_W = Vec3(0, 0, -3e-3);
  EXPECT_TRUE(a.go().dropped);
  a.now.needle_W = Vec3(0, 0, -30e-3);
  a.go(100);
  EXPECT_EQ(a.memory.drops, 1);
  // taken up again and dropped again
  a.take(0.6, 1e-3, 0.6);
  a.let_go();
  a.now.needle_W = Vec3(0, 0, -40e-3);
  EXPECT_EQ(a.go().end, End::kDropped);
}

TEST(Judge, KnockingItAwayIsADropAndPuttingItBackArmsAgain) {
  Attempt a;
  a.go(10);
  a.now.needle_W = Vec3(5e-3, 0, 0);
  EXPECT_TRUE(a.go().dropped);
  a.now.needle_W = Vec3::Zero();
  a.go(10);
  a.now.needle_W = Vec3(5e-3, 0, 0);
  EXPECT_TRUE(a.go().dropped);
  EXPECT_EQ(a.memory.drops, 2);
}

TEST(Judge, TimeRunsOut) {
  Rules rules;
  rules.max_time = 1;
  Attempt a(rules);
  a.take(0.6, 1e-3, 0.6);
  a.go(500);
  a.let_go();
  const Finding f = a.go(600);
  EXPECT_EQ(f.end, End::kOutOfTime);
  EXPECT_NEAR(f.score, 40 * 0.501 / 3, 0.1);
}

TEST(Judge, TriesEndWithTheFirstGoodGrasp) {
  Attempt a;
  for (int i = 0; i < 2; ++i) {
    a.take(0.3, 1e-3, 0.6);
    a.go(50);
    a.let_go();
    a.go(200);
  }
  a.take(0.6, 1e-3, 0.6);
  a.go(50);
  a.let_go();
  a.go(200);
  a.take(0.65, 1e-3, 0.6);
  EXPECT_EQ(a.memory.tries, 3);
  EXPECT_EQ(a.memory.grasps, 4);
  EXPECT_EQ(a.memory.good_grasps, 2);
  EXPECT_EQ(a.memory.regrasps, 1);
  EXPECT_NEAR(a.memory.spot_error_sum, 2 * 0.2, 1e-12);
}

TEST(Judge, TouchingAgainInOneClosingIsOneTry) {
  Attempt a;
  a.now.opening = 0.3;
  a.go(10);
  for (const double opening : {0.1, 0.08, 0.1, 0.05}) {
    a.now.opening = opening;
    a.now.touched = true;
    a.go(200);
  }
  EXPECT_EQ(a.memory.tries, 1);
  a.now.opening = 0.2;
  a.go(10);
  a.now.opening = 0.1;
  a.now.touched = true;
  a.go(10);
  EXPECT_EQ(a.memory.tries, 2);
}

TEST(Judge, SnapIsTheTurnFromTouchToJustAfterTheGrasp) {
  Attempt a;
  a.now.touched = true;
  a.now.q_WN = toolkit::exp_rotation({0, 0, 0.1});
  a.go(20);
  a.now.taken = a.now.held = true;
  a.now.s = 0.6;
  a.now.force = 0.6;
  a.now.q_WN = toolkit::exp_rotation({0, 0, 0.35});
  a.go(99);
  EXPECT_EQ(a.memory.snap_sum, 0);
  a.go(3);
  EXPECT_NEAR(a.memory.snap_sum, 0.25, 1e-12);
}

TEST(Judge, ScoreTakesOffWhatItSays) {
  Rules rules;
  rules.par_time = 2;
  Attempt a(rules);
  // sets off, comes late: 3 s of the way, so that the hold ends after 1.5 times the par and more
  for (int i = 0; i < 1000; ++i) {
    a.now.tip_W = Vec3(5e-3 * 1e-3 * i, 0, 0);
    a.go();
  }
  a.take(0.3, 1e-3, 0.6);  // a wrong try: minus 8
  a.go(50);
  a.let_go();
  a.go(200);
  a.now.tilt_axis = 0.2;
  a.now.tilt_plane = -0.1;
  a.take(0.6, 1e-3, 0.6);
  const Finding f = a.go(4000);
  ASSERT_EQ(f.end, End::kPassed);
  const double time = task_time(a.memory, a.now.time_s);
  EXPECT_NEAR(time, 4.25 - 0.1, 0.15);
  const double lean =
      0.5 * (0.2 + 0.1) * 3.0 / (3.0 + 0.05);  // mean over the held time, the first try was straight
  const double lost = 8 + 20 * lean / (0.25 * std::numbers::pi) + 15 * std::min(1.0, time / 2 - 1);
  EXPECT_NEAR(f.score, 100 - lost, 0.1);
}

}  // namespace
}  // namespace swage::lesson_grasp
