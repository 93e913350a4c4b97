// SPDX-License-Identifier: Apache-2.0
//
// What counts as a right answer about a knot, what its pull says, and what an attempt is worth.
#include "lessons/fault/judge.hpp"

#include <gtest/gtest.h>

namespace swage::lesson_fault {
namespace {

/// An attempt told step by step.
struct Attempt {
  explicit Attempt(const Rules& rules = {}) : judge(rules, 1e-3) {
    now.opening = 0.2;
    for (size_t i = 0; i < kKnots; ++i) now.answer_W[i] = Vec3(0, -2e-3 * static_cast<double>(i), 0);
  }
  Finding step() {
    now.time_s += 1e-3;
    return judge.look(memory, now);
  }
  Finding go(double s) {
    Finding finding;
    for (double until = now.time_s + s; now.time_s < until && finding.end == End::kRunning;) finding = step();
    return finding;
  }
  /// Waits for the question, then closes the jaws at an answer and opens them again.
  Finding answer(Knot said) {
    while (step().stage != Stage::kAsk) {}
    now.tip_W = now.answer_W[static_cast<size_t>(said)];
    now.opening = 0;
    const Finding finding = step();
    now.opening = 0.2;
    return finding;
  }
  /// The instrument draws at 2 mm/s until the pull ends; the knot bears so much.
  Finding pull(double borne) {
    Finding finding;
    while (!finding.pulled) {
      if (now.tension < borne) now.tension += 1e-3;
      if (borne < 0.095) now.puller_W.x() += 2e-6;
      finding = step();
    }
    now.tension = 0;
    return finding;
  }
  Finding question(Knot is, Knot said, double borne) {
    now.knot = static_cast<int>(is);
    answer(said);
    return pull(borne);
  }

  Judge judge;
  Memory memory;
  Look now;
};

TEST(FaultJudge, AllRightIsWorthAllPoints) {
  Attempt a;
  for (const Knot knot : {Knot::kLoose, Knot::kSquare, Knot::kGranny, Knot::kSliding}) a.question(knot, knot, knot == Knot::kSquare ? 0.1 : 0.01);
  const Finding end = a.go(1.1);
  EXPECT_EQ(end.end, End::kPassed);
  EXPECT_EQ(end.score, 100);
  EXPECT_EQ(a.memory.rights, 4);
  EXPECT_EQ(a.memory.false_alarms + a.memory.missed, 0);
}

TEST(FaultJudge, AFalseAlarmAMissedFaultAndAWrongNameAreToldApart) {
  Attempt a;
  a.question(Knot::kSquare, Knot::kGranny, 0.1);
  EXPECT_EQ(a.memory.false_alarms, 1);
  a.question(Knot::kGranny, Knot::kSquare, 0.01);
  EXPECT_EQ(a.memory.missed, 1);
  a.question(Knot::kSliding, Knot::kLoose, 0.01);
  a.question(Knot::kLoose, Knot::kLoose, 0.01);
  EXPECT_EQ(a.memory.false_alarms, 1);
  EXPECT_EQ(a.memory.missed, 1);
  const Finding end = a.go(1.1);
  EXPECT_EQ(end.end, End::kWrong);
  EXPECT_EQ(end.score, 0) << "as good as guessing";
}

TEST(FaultJudge, AMissedFaultCostsMoreThanAFalseAlarm) {
  double score[2];
  for (int missed = 0; missed < 2; ++missed) {
    Attempt a;
    a.question(missed != 0 ? Knot::kGranny : Knot::kSquare, missed != 0 ? Knot::kSquare : Knot::kGranny, 0.1);
    for (int i = 0; i < 3; ++i) a.question(Knot::kSquare, Knot::kSquare, 0.1);
    const Finding end = a.go(1.1);
    EXPECT_EQ(end.end, End::kPassed);
    score[missed] = end.score;
  }
  EXPECT_EQ(score[0], 85);
  EXPECT_EQ(score[1], 75);
}

TEST(FaultJudge, AKnotHoldsThatBearsTheLoadForLongEnough) {
  Attempt a;
  const Finding held = a.question(Knot::kSquare, Knot::kSquare, 0.1);
  EXPECT_EQ(a.memory.held, 1);
  EXPECT_LT(held.result, 0.1e-3) << "m";
  EXPECT_NEAR(a.memory.pulled[0].borne, 0.1, 1e-6);
  const Finding gone = a.question(Knot::kGranny, Knot::kSquare, 0.01);
  EXPECT_EQ(a.memory.held, 0);
  EXPECT_NEAR(gone.result, 0.01, 1e-6) << "N";
  EXPECT_GE(a.memory.pulled[1].opening, a.judge.rules().most_opening);
}

TEST(FaultJudge, JawsThatCloseElsewhereOrTooEarlyAnswerNothing) {
  Attempt a;
  a.now.opening = 0;
  EXPECT_FALSE(a.go(0.5).answered);
  a.now.opening = 0.2;
  while (a.step().stage != Stage::kAsk) {}
  a.now.tip_W = Vec3(5e-3, 0, 0);
  a.now.opening = 0;
  EXPECT_EQ(a.go(0.2).stage, Stage::kAsk);
  EXPECT_EQ(a.memory.answers, 0);
  a.now.tip_W = a.now.answer_W[1];  // they have not been open since
  EXPECT_EQ(a.go(0.2).stage, Stage::kAsk);
}

TEST(FaultJudge, TheTimeLimitEndsATestAndNoPractice) {
  for (const bool ends : {true, false}) {
    Rules rules;
    rules.max_time = 2, rules.ends = ends;
    Attempt a(rules);
    EXPECT_EQ(a.go(3).end, ends ? End::kOutOfTime : End::kRunning);
  }
}

}  // namespace
}  // namespace swage::lesson_fault
