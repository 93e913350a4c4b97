// SPDX-License-Identifier: Apache-2.0
#include "judge/pass_rule.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace swage::judge {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;

std::vector<Scored> attempts(const std::string& said) {
  // "++-|+" : met, met, not met, next day, met
  std::vector<Scored> out;
  int32_t day = 0;
  for (const char c : said)
    if (c == '|')
      ++day;
    else
      out.push_back({day, c == '+'});
  return out;
}

PassRule streak(uint32_t n, uint32_t later = 0, uint32_t a_day = 0, uint32_t warm_up = 0) {
  PassRule r;
  r.in_a_row = n;
  r.later_day = later;
  r.a_day = a_day;
  r.warm_up = warm_up;
  return r;
}

PassRule cusum(double h) {
  PassRule r;
  r.kind = PassRule::Kind::kLcCusum;
  r.signal = h;
  r.a_day = 0;
  return r;
}

TEST(Limits, AreAllToBeMetAndSayWhichWereBroken) {
  const std::vector<Limit> limits = {{"angle", "rad", -1, 0.2, true, ""}, {"time", "s", -HUGE_VAL, 45, false, ""}, {"held", "s", 10, HUGE_VAL, false, ""}};
  using M = std::vector<std::pair<std::string, double>>;
  EXPECT_TRUE(meets(limits, M{{"angle", 0.2}, {"time", 45}, {"held", 10}}).all) << "the limit itself meets it";
  const Met slow = meets(limits, M{{"angle", 0.1}, {"time", 45.001}, {"held", 12}});
  EXPECT_FALSE(slow.all);
  EXPECT_TRUE(slow.gates);
  EXPECT_THAT(slow.broken, ElementsAre(1u));
  const Met steep = meets(limits, M{{"angle", 0.3}, {"time", NAN}});
  EXPECT_FALSE(steep.gates);
  EXPECT_THAT(steep.broken, ElementsAre(0u, 1u, 2u)) << "neither a missing metric nor one that is no number meets anything";
  EXPECT_TRUE(meets({}, M{}).all);
}

TEST(Limits, OfManyAttemptsTogether) {
  const std::vector<Limit> limits = {{"a", "", 0, 1, false, ""}, {"b", "", 0, 1, false, ""}};
  const std::vector<std::vector<std::pair<std::string, double>>> experts = {
      {{"a", 0.5}, {"b", 0.5}}, {{"a", 2}, {"b", 0.5}}, {{"a", 0.5}, {"b", 2}}, {{"a", 2}, {"b", 2}}};
  const MetTogether met = meet_together(limits, experts);
  EXPECT_EQ(met.attempts, 4u);
  EXPECT_EQ(met.all, 1u);
  EXPECT_THAT(met.each, ElementsAre(2u, 2u));
}

TEST(Rule, SoManyInARow) {
  EXPECT_FALSE(standing(streak(2), attempts("+-+-+-")).passed);
  const Standing s = standing(streak(2), attempts("+-++-"));
  EXPECT_TRUE(s.passed);
  EXPECT_EQ(s.at, 3u);
  EXPECT_EQ(standing(streak(3), attempts("++-++")).in_a_row, 2u);
  EXPECT_TRUE(standing(streak(2), attempts("+|+")).passed) << "in a row goes over the night";
}

TEST(Rule, ConfirmedOnALaterDay) {
  EXPECT_FALSE(standing(streak(2, 2), attempts("++++++")).passed) << "the same day confirms nothing";
  EXPECT_TRUE(standing(streak(2, 2), attempts("++++++")).is_earned);
  EXPECT_TRUE(standing(streak(2, 2), attempts("++|++")).passed);
  EXPECT_FALSE(standing(streak(2, 2), attempts("++|-++++")).passed) << "the first two of the day";
  EXPECT_FALSE(standing(streak(2, 2), attempts("++|+-+++")).passed);
  const Standing third = standing(streak(2, 2), attempts("++|+-|++"));
  EXPECT_TRUE(third.passed) << "what was earned stays earned";
  EXPECT_EQ(third.at, 5u);
  EXPECT_EQ(standing(streak(2, 2), attempts("++|+")).confirmed, 1u);
}

TEST(Rule, OnlySoManyADayCountAndNoWarmUp) {
  EXPECT_FALSE(standing(streak(2, 0, 2), attempts("--++++")).passed) << "the cap is two a day";
  EXPECT_TRUE(standing(streak(2, 0, 2), attempts("--++|++")).passed);
  EXPECT_TRUE(standing(streak(2, 0, 0, 1), attempts("-++")).passed);
  EXPECT_FALSE(standing(streak(2, 0, 0, 1), attempts("++")).passed) << "the first is warm-up";
  EXPECT_TRUE(standing(streak(2, 2, 0, 1), attempts("-++|-++")).passed) << "a failed warm-up breaks no confirmation";
  EXPECT_EQ(standing(streak(2, 0, 2, 1), attempts("+----|+----")).counted, 4u);
}

TEST(Rule, SaysWhatIsWrongWithIt) {
  EXPECT_EQ(problem_of(PassRule()), "");
  EXPECT_NE(problem_of(streak(0)), "");
  EXPECT_NE(problem_of(streak(2, 5, 3)), "");
  PassRule r = cusum(2.4);
  EXPECT_EQ(problem_of(r), "");
  r.adequate = 0.4;
  EXPECT_NE(problem_of(r), "");
  r = cusum(0);
  EXPECT_NE(problem_of(r), "");
}

// Biau, Williams, Schlup, Nizard, Porcher: Quantitative and individualized assessment of the learning curve using LC-CUSUM, Br J
// Surg 2008;95:925. With rates of 10 and 30 %: +0.251 and -1.099.
TEST(LcCusum, WeightsAreThoseOfThePaper) {
  const CusumWeights w = lc_cusum_weights(0.10, 0.30);
  EXPECT_THAT(w.success, DoubleNear(0.2513144282809062, 1e-15));  // ln(9/7)
  EXPECT_THAT(w.failure, DoubleNear(-1.0986122886681098, 1e-15));  // -ln 3
}

TEST(LcCusum, HoldsAtNoughtAndSignalsAtItsLimit) {
  const double s = std::log(9.0 / 7), f = -std::log(3.0);
  const Standing some = standing(cusum(2.4), attempts("-+++-++++++"));
  EXPECT_THAT(some.sums, ElementsAre(0.0, DoubleNear(s, 1e-12), DoubleNear(2 * s, 1e-12), DoubleNear(3 * s, 1e-12),
                                     DoubleNear(std::max(0.0, 3 * s + f), 1e-12), testing::_, testing::_, testing::_, testing::_,
                                     testing::_, DoubleNear(std::max(0.0, 3 * s + f) + 6 * s, 1e-12)));
  EXPECT_FALSE(some.passed);
  // ten successes at once: 10 x 0.2513 = 2.513, nine are 2.262
  EXPECT_FALSE(standing(cusum(2.4), attempts("+++++++++")).passed);
  const Standing ten = standing(cusum(2.4), attempts("++++++++++"));
  EXPECT_TRUE(ten.passed);
  EXPECT_EQ(ten.at, 9u);
}

TEST(LcCusum, ARelapseIsSeenAfterwards) {
  EXPECT_FALSE(standing(cusum(2.4), attempts("++++++++++" "+-+++++-++++++")).relapsed);
  EXPECT_TRUE(standing(cusum(2.4), attempts("++++++++++" "+--+-")).relapsed);
  EXPECT_TRUE(standing(cusum(2.4), attempts("++++++++++" "+--+-")).passed) << "passed stays passed";
}

// The exact probability that the chain of S (a walk on finitely many values) has met its limit within n attempts.
double exact_lc_cusum(double p, double h, int n) {
  std::vector<std::pair<double, double>> now = {{0.0, 1.0}};  // S, probability
  const CusumWeights w = lc_cusum_weights(0.10, 0.30);
  double passed = 0;
  for (int i = 0; i < n; ++i) {
    std::vector<std::pair<double, double>> next;
    const auto add = [&](double s, double q) {
      if (s >= h) {
        passed += q;
        return;
      }
      for (auto& [at, sum] : next)
        if (std::abs(at - s) < 1e-9) return void(sum += q);
      next.emplace_back(s, q);
    };
    for (const auto& [s, q] : now) add(s + w.success, q * p), add(std::max(0.0, s + w.failure), q * (1 - p));
    now = next;
  }
  return passed;
}

TEST(Simulation, IsExactWhereTheChainCanBeCounted) {
  for (const double h : {1.6, 2.4, 3.0})
    for (const double p : {0.5, 0.7, 0.9})
      EXPECT_THAT(simulate(cusum(h), p).passed, DoubleNear(exact_lc_cusum(p, h, 30), 0.01)) << h << " " << p;
  // three in a row: a chain of three states
  for (const double p : {0.5, 0.7}) {
    double state[4] = {1, 0, 0, 0};
    for (int i = 0; i < 30; ++i) {
      const double fail = (state[0] + state[1] + state[2]) * (1 - p);
      state[3] += state[2] * p, state[2] = state[1] * p, state[1] = state[0] * p, state[0] = fail;
    }
    EXPECT_THAT(simulate(streak(3), p).passed, DoubleNear(state[3], 0.01));
  }
  EXPECT_EQ(simulate(streak(2), 0).passed, 0.0);
  EXPECT_TRUE(std::isnan(simulate(streak(2), 0).typical));
  EXPECT_EQ(simulate(streak(2), 1).passed, 1.0);
  EXPECT_EQ(simulate(streak(2), 1).typical, 2.0);
}

// The published table of rules (30 attempts, 10 a session, 40 000 trainees): within 2 points.
TEST(Simulation, GivesTheTableOfRules) {
  struct Entry {
    PassRule rule;
    double at_5, at_7, at_9, typical;
  };
  const std::vector<Entry> table = {{streak(1), 1, 1, 1, 1},           {streak(2), 1, 1, 1, 2},
                                    {streak(3), 0.91, 1, 1, 3},        {streak(2, 2, 10), 0.41, 0.73, 0.97, 12},
                                    {cusum(1.6), 0.10, 0.57, 0.99, 8}, {cusum(2.4), 0.01, 0.23, 0.93, 15},
                                    {cusum(3.0), 0.003, 0.11, 0.85, 18}};
  for (const Entry& e : table) {
    SCOPED_TRACE(static_cast<int>(&e - table.data()));
    EXPECT_THAT(simulate(e.rule, 0.5).passed, DoubleNear(e.at_5, 0.02));
    EXPECT_THAT(simulate(e.rule, 0.7).passed, DoubleNear(e.at_7, 0.02));
    EXPECT_THAT(simulate(e.rule, 0.9).passed, DoubleNear(e.at_9, 0.02));
    EXPECT_THAT(simulate(e.rule, 0.9).typical, DoubleNear(e.typical, 1));
  }
}

TEST(Simulation, TheSameSeedGivesTheSameNumbers) {
  EXPECT_EQ(simulate(PassRule(), 0.7, 30, 10, 1000, 5).passed, simulate(PassRule(), 0.7, 30, 10, 1000, 5).passed);
  EXPECT_NE(simulate(PassRule(), 0.7, 30, 10, 1000, 5).passed, simulate(PassRule(), 0.7, 30, 10, 1000, 6).passed);
}

}  // namespace
}  // namespace swage::judge
