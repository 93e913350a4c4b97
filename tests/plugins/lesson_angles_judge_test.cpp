// SPDX-License-Identifier: Apache-2.0
//
// Judging angles: the staircase against the level that theory gives it, the curve through the answers against closed forms, the
// order of questions, each way to end.
#include <gtest/gtest.h>

#include <cstdio>

#include <random>

#include "lessons/angles/judge.hpp"

namespace swage::lesson_angles {
namespace {

double phi(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

TEST(Staircase, TwoDownOneUpWithHalvedSteps) {
  const Track track(16 * kDegree, 1 * kDegree);
  TrackState s;
  track.begin(s);
  const auto after = [&](bool agrees) {
    track.answer(s, agrees);
    return s.level / kDegree;
  };
  EXPECT_NEAR(after(true), 10, 1e-9);  // one is enough before the first reversal
  EXPECT_NEAR(after(true), 4, 1e-9);
  EXPECT_NEAR(after(true), -2, 1e-9);  // to the other side
  EXPECT_NEAR(after(false), 1, 1e-9);  // reversal: steps of 3
  EXPECT_NEAR(after(true), 1, 1e-9);   // now it takes two
  EXPECT_NEAR(after(true), -0.5, 1e-9);
  EXPECT_NEAR(after(true), -0.5, 1e-9);
  EXPECT_NEAR(after(false), 0.5, 1e-9);  // steps of 1, and never less
  EXPECT_NEAR(after(false), 1.5, 1e-9);
  EXPECT_EQ(s.reversals, 3);
  for (int i = 0; i < 100; ++i) track.answer(s, false);
  EXPECT_NEAR(s.level / kDegree, 32, 1e-9) << "never wider than twice the first lean";
}

// p^2 = 1/2 is where a step up and a step down are equally likely: Phi(z) = 0.7071, z = 0.545 (Levitt 1971)
TEST(Staircase, SettlesWhereSeventyOnePercentAreRight) {
  const Track track(16 * kDegree, 0.25 * kDegree);
  std::mt19937 random(1);
  std::normal_distribution<double> noise(0, 4 * kDegree);
  TrackState s;
  track.begin(s);
  double sum = 0;
  constexpr int kSkip = 500, kTrials = 60000;
  for (int i = 0; i < kTrials; ++i) {
    track.answer(s, s.level + noise(random) > 0);
    if (i >= kSkip) sum += s.level;
  }
  EXPECT_NEAR(sum / (kTrials - kSkip) / kDegree, 0.545 * 4, 0.1);
}

TEST(Curve, ThroughSharesThatAreKnown) {
  // twenty answers each at -8, 0 and 8 deg, of which 3, 10 and 17 to the other side: Phi(8 deg / spread) = 0.85
  AnswersState s;
  for (const auto& [lean, others] : {std::pair{-8.0, 3}, {0.0, 10}, {8.0, 17}})
    for (int i = 0; i < 20; ++i) Answers::add(s, lean * kDegree, i < others, 32 * kDegree);
  const double spread = 8 / 1.03643;  // Phi(1.03643) = 0.85
  EXPECT_NEAR(phi(1.03643), 0.85, 1e-5);
  EXPECT_NEAR(s.spread / kDegree, spread, 0.02 * spread);
  EXPECT_NEAR(s.bias, 0, 1e-9);
  EXPECT_NEAR(Answers::jnd(s), 0.6745 * s.spread, 1e-4);

  // the same 3 deg further: what leans by -3 deg looks upright
  AnswersState off;
  for (const auto& [lean, others] : {std::pair{-11.0, 3}, {-3.0, 10}, {5.0, 17}})
    for (int i = 0; i < 20; ++i) Answers::add(off, lean * kDegree, i < others, 32 * kDegree);
  EXPECT_NEAR(off.bias / kDegree, 3, 0.1);
  EXPECT_NEAR(off.spread / kDegree, spread, 0.02 * spread);
}

TEST(Curve, HasAValueWhenAllIsRightAndWhenNothingIs) {
  AnswersState right, blind;
  for (int i = 0; i < 10; ++i) {
    const double lean = (i % 2 == 0 ? 4 : -4) * kDegree;
    Answers::add(right, lean, lean > 0, 32 * kDegree);
    Answers::add(blind, lean, lean < 0, 32 * kDegree);
  }
  EXPECT_TRUE(std::isfinite(right.spread) && right.spread > 0 && right.spread < 4 * kDegree);
  EXPECT_NEAR(blind.spread / kDegree, 64, 1e-9);
}

/// An eye with bias and noise, and a hand that answers at once.
struct Attempt {
  Attempt(double bias, double noise, const Rules& rules = {}, unsigned seed = 7)
      : judge(rules, 1e-3), bias_(bias), random_(seed), noise_(0, noise) {
    now.one_W = Vec3(-2e-3, 0, 0);
    now.other_W = Vec3(2e-3, 0, 0);
    now.opening = 0.2;
  }
  Finding go() {
    Finding f;
    std::uniform_real_distribution<double> even(0, 1);
    while (f.end == End::kRunning) {
      now.time_s = 1e-3 * step++;
      now.lean[0] = now.lean[1] = 0;
      if (memory.begun != 0) now.lean[Judge::axis_of(memory)] = Judge::lean_of(memory);
      f = judge.look(memory, now);
      if (f.draw) judge.draw(memory, even(random_), now.time_s);
      if (f.stage == Stage::kAsk && now.opening > 0.1) {
        const bool other = now.lean[Judge::axis_of(memory)] + bias_ + noise_(random_) > 0;
        now.tip_W = other ? now.other_W : now.one_W;
        now.opening = 0.01;
      }
      if (f.stage == Stage::kTell) now.opening = 0.2;
    }
    return f;
  }
  Judge judge;
  Memory memory;
  Look now;
  int step = 0;

 private:
  double bias_;
  std::mt19937 random_;
  std::normal_distribution<double> noise_;
};

TEST(AngleJudge, AGoodEyePassesWithFullMarks) {
  Attempt a(0, 1 * kDegree);
  const Finding f = a.go();
  EXPECT_EQ(f.end, End::kPassed);
  EXPECT_EQ(f.score, 100);
  EXPECT_EQ(Judge::answers(a.memory), 40);
  for (const TrackState& track : a.memory.track) EXPECT_EQ(track.count, 10);
  EXPECT_EQ(a.memory.axis[0].n, 20);
}

TEST(AngleJudge, FindsBiasAndSpreadOfAnEye) {
  Rules rules;
  rules.questions = 120;
  rules.max_bias = rules.max_jnd = 1;
  Attempt a(6 * kDegree, 4 * kDegree, rules);
  EXPECT_EQ(a.go().end, End::kPassed);
  for (const AnswersState& axis : a.memory.axis) {
    EXPECT_NEAR(axis.bias / kDegree, 6, 2);  // three times its standard error with sixty answers
    EXPECT_NEAR(axis.spread / kDegree, 4, 2.5);
  }
}

TEST(AngleJudge, EachWayToFail) {
  EXPECT_EQ(Attempt(14 * kDegree, 1 * kDegree).go().end, End::kBiased);
  const Finding unsure = Attempt(0, 60 * kDegree).go();
  EXPECT_EQ(unsure.end, End::kUnsure);
  EXPECT_LT(unsure.score, 15);
  Rules rules;
  rules.max_time = 5;
  EXPECT_EQ(Attempt(0, 0.01, rules).go().end, End::kOutOfTime);
}

/// Share of 200 eyes that pass the lesson as it is.
double passing(double bias_deg, double noise_deg) {
  int passed = 0;
  for (unsigned seed = 1; seed <= 200; ++seed)
    passed += Attempt(bias_deg * kDegree, noise_deg * kDegree, {}, seed).go().end == End::kPassed;
  std::printf("bias %4.0f deg, noise %5.1f deg: %5.1f %% pass\n", bias_deg, noise_deg, passed / 2.0);
  return passed / 200.0;
}

// the rules of angles.md by simulation: who sees well passes, who guesses or is off by more than the limit does not
TEST(AngleJudge, WhoPasses) {
  EXPECT_GT(passing(0, 1.5), 0.99);
  EXPECT_GT(passing(5, 4), 0.9);
  EXPECT_LT(passing(15, 1.5), 0.05);
  EXPECT_LT(passing(0, 25), 0.15);
  EXPECT_LT(passing(0, 1000), 0.02) << "answers at random";
  EXPECT_EQ(passing(80, 1.5), 0) << "always the same side";
}

TEST(AngleJudge, ClosingElsewhereIsNoAnswerAndJawsMustOpenInBetween) {
  Attempt a(0, 0.01);
  Finding f;
  const auto wait = [&](int n) {
    for (int i = 0; i < n; ++i) {
      a.now.time_s = 1e-3 * a.step++;
      f = a.judge.look(a.memory, a.now);
      if (f.draw) a.judge.draw(a.memory, 0.1, a.now.time_s);
    }
  };
  wait(800);
  EXPECT_EQ(f.stage, Stage::kAsk);
  a.now.tip_W = Vec3(0, 0, 5e-3);
  a.now.opening = 0.01;
  wait(10);
  EXPECT_EQ(Judge::answers(a.memory), 0);
  a.now.tip_W = a.now.one_W;  // there, but not opened since
  wait(10);
  EXPECT_EQ(Judge::answers(a.memory), 0);
  a.now.opening = 0.2;
  wait(10);
  a.now.opening = 0.01;
  wait(1);
  EXPECT_TRUE(f.answered);
  wait(2000);  // still closed: the next question is not answered
  EXPECT_EQ(Judge::answers(a.memory), 1);
}

}  // namespace
}  // namespace swage::lesson_angles
