// SPDX-License-Identifier: Apache-2.0
//
// The grasp lesson: the four meanings, holds and their breaks, drops, limits, metrics and score; then through the boundary.
#include "lessons/grasp/judge.hpp"

#include <numbers>

#include "lesson_stage.hpp"

namespace swage::lesson_grasp {
namespace {

/// An attempt told step by step.
struct Attempt {
  explicit Attempt(const Rules& rules = {}) : judge(rules, 1e-3) {}

  /// n steps as `now` says; returns the last finding.
  Finding go(int n = 1) {
    Finding finding;
    for (int i = 0; i < n; ++i) {
      now.time_s = 1e-3 * step++;
      finding = judge.look(memory, now);
      now.touched = now.taken = false;
      if (finding.end != End::kRunning) break;
    }
    return finding;
  }
  Finding take(double s, double reach, double force) {
    now.touched = now.taken = now.held = true;
    now.opening = 0.01;
    now.s = s;
    now.tip_reach = reach;
    now.force = force;
    return go();
  }
  void let_go() {
    now.held = false;
    now.force = 0;
    now.opening = 0.2;
  }

  Judge judge;
  Memory memory;
  Look now;
  int step = 0;
};

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

TEST(Measures, QuantileSpreadIdleAndTremor) {
  using namespace lessons;
  const Quantile quantile(4);
  QuantileState q;
  for (int i = 0; i < 1000; ++i) quantile.look(q, i < 990 ? 0.5 : 1.5, 1e-3);  // 1 % above
  EXPECT_NEAR(quantile.at(q, 0.995), 1.5, 4.0 / 128);
  EXPECT_NEAR(quantile.at(q, 0.9), 0.5, 4.0 / 128);
  EXPECT_EQ(quantile.at(QuantileState(), 0.5), 0);

  SpreadState s;
  for (int i = 0; i < 1000; ++i) spread(s, i % 2 == 0 ? 0.9 : 1.1, 1e-3);
  EXPECT_NEAR(s.mean, 1, 1e-12);
  EXPECT_NEAR(deviation(s), 0.1, 1e-12);

  IdleState idle;
  for (int i = 0; i < 2000; ++i) IdleWatch::look(idle, {i < 1000 ? 0 : 2e-6 * (i - 1000), 0, 0}, 1e-3, true);
  EXPECT_NEAR(IdleWatch::share(idle), 0.5, 2e-3);

  // 10 Hz of 30 um is in the band, a slow movement of 1 mm is not
  const double pi = std::numbers::pi;
  TremorState shaking, reaching;
  const TremorWatch watch(1e-3);
  for (int i = 0; i < 20000; ++i) {
    const double t = 1e-3 * i;
    watch.look(shaking, {30e-6 * std::sqrt(2.0) * std::sin(2 * pi * 9.8 * t), 0, 0}, t > 2);
    watch.look(reaching, {1e-3 * std::sin(2 * pi * 0.5 * t), 0, 0}, t > 2);
  }
  EXPECT_NEAR(TremorWatch::rms(shaking), 30e-6, 0.3e-6);
  EXPECT_LT(TremorWatch::rms(reaching), 1.5e-6);
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

TEST(PathWatch, CountsTheWayWithoutTheTremor) {
  const lessons::PathWatch watch(1e-3);
  lessons::PathState state;
  for (int i = 0; i < 3000; ++i) {
    const double t = i * 1e-3, shake = 50e-6 * std::sin(2 * std::numbers::pi * 10 * t);
    watch.look(state, Vec3(10e-3 * std::min(t, 2.0), shake, 0), t);
  }
  // 20 mm of way; unfiltered, the shaking alone would be 30 * 4 * 50 um = 6 mm at right angles to it
  EXPECT_NEAR(state.length, 20e-3, 0.4e-3);
  EXPECT_NEAR(state.set_off_s, 0.05, 0.1);
}

template <class Filter, class State>
double gain(const Filter& filter, double f) {
  State state;
  double most = 0;
  for (int i = 0; i < 4000; ++i) {
    const double y = filter.next(state, std::sin(2 * std::numbers::pi * f * i * 1e-3));
    if (i > 2000) most = std::max(most, std::abs(y));
  }
  return most;
}

TEST(LowPass, PassesBelowAndStopsAbove) {
  const lessons::LowPass4 motion(6, 1e-3);
  const auto g4 = [&](double f) { return gain<lessons::LowPass4, lessons::LowPass4State>(motion, f); };
  EXPECT_NEAR(g4(0.5), 1, 1e-3);
  EXPECT_NEAR(g4(6), std::sqrt(0.5), 2e-3);
  EXPECT_NEAR(g4(12), 1 / std::sqrt(1 + 256.0), 2e-3);  // 1 / sqrt(1 + (f / 6)^8)

  const lessons::LowPass force(20, 1e-3, lessons::LowPass::kCritical);
  const auto g2 = [&](double f) { return gain<lessons::LowPass, lessons::LowPassState>(force, f); };
  EXPECT_NEAR(g2(1), 1, 5e-3);
  EXPECT_NEAR(g2(20), 0.5, 2e-3);
  EXPECT_NEAR(g2(80), 1.0 / 17, 4e-3);  // 1 / (1 + (f / 20)^2)
}

TEST(LowPass, NoOvershootAndNoStart) {
  const lessons::LowPass force(20, 1e-3, lessons::LowPass::kCritical);
  lessons::LowPassState state;
  EXPECT_NEAR(force.next(state, 3.0), 3.0, 1e-12) << "the first value has stood for ever";
  double most = 0;
  for (int i = 0; i < 500; ++i) most = std::max(most, force.next(state, 4.0));
  EXPECT_NEAR(most, 4, 1e-9);
  EXPECT_LE(most, 4 + 1e-12);
}

/// The plugin on a small scene.
class OnStage : public ::testing::Test, public stage::LessonStage {
 protected:
  OnStage() : LessonStage("swage.lesson.grasp", {"needle"}) {}
};

TEST_F(OnStage, PassesAndSaysSo) {
  ASSERT_EQ(bind({{"hold_time", 0.5}}), SWAGE_OK);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_EQ(marks[0].kind, SWAGE_MARK_ARC_RANGE);
  EXPECT_EQ(marks[0].object, 1u);
  EXPECT_EQ(marks[0].number[1], 0.75);
  start();
  observe(100);
  EXPECT_EQ(phase, stage.index_of(SWAGE_DECLARE_PHASE, "approach"));
  EXPECT_EQ(cues[1], SWAGE_NONE);
  hold(0, 0.6, 0.6);
  observe(10);
  EXPECT_EQ(cues[1], cue("grasp.good"));
  EXPECT_EQ(phase, stage.index_of(SWAGE_DECLARE_PHASE, "hold"));
  observe(600);
  EXPECT_EQ(ends, 1);
  EXPECT_EQ(passed, 1);
  EXPECT_EQ(reason, SWAGE_NONE);
  EXPECT_NEAR(score, 100, 1e-9);
  EXPECT_EQ(metric("grasp.tries"), 1);
  EXPECT_EQ(metric("hold.progress"), 1);
  EXPECT_NEAR(metric("force.mean"), 0.6, 0.02);  // the filter needs its time at the start
}

TEST_F(OnStage, FailsWithAReason) {
  ASSERT_EQ(bind({{"max_over_time", 0.2}}), SWAGE_OK);
  start();
  hold(0, 0.6, 1.5);
  observe(1000);
  EXPECT_EQ(ends, 1);
  EXPECT_EQ(passed, 0);
  EXPECT_EQ(reason, stage.index_of(SWAGE_DECLARE_EVENT, "failed.too_hard"));
  EXPECT_EQ(cues[0], cue("grip.too_hard"));
}

TEST_F(OnStage, SaysWhatTheSceneLacks) {
  signals.pop_back();
  EXPECT_LT(bind({{"needle", std::string("nadle")}}), 0);
  EXPECT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0], "there is no object \"nadle\" in the scene; it has: holder, needle");
  problems.clear();
  EXPECT_LT(bind({{"gripper", std::string("needle")}}), 0);
  EXPECT_EQ(problems.size(), 1u);
  problems.clear();
  EXPECT_LT(bind(), 0);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0], "\"grasp\" has no signal \"grasp.balance\", which this lesson watches");
  problems.clear();
  signals.clear();
  EXPECT_LT(bind(), 0);
  EXPECT_EQ(problems.size(), 1u);
}

TEST_F(OnStage, RefusesAnEmptyRegion) {
  EXPECT_LT(stage.configure({{"region", std::vector<double>{0.75, 0.5}}}), 0);
  ASSERT_EQ(stage.errors.size(), 1u);
}

}  // namespace
}  // namespace swage::lesson_grasp
