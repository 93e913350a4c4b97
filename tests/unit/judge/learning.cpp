// SPDX-License-Identifier: Apache-2.0
#include "judge/learning.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "base/rng.hpp"

namespace swage::judge {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;

std::vector<double> exact(Law law, double a, double b, double c, int n) {
  std::vector<double> out;
  for (int i = 1; i <= n; ++i) out.push_back(a + b * (law == Law::kExponential ? std::exp(-(i - 1) / c) : std::pow(i, -c)));
  return out;
}

// Box-Muller
double normal(base::Xoshiro256& random) {
  return std::sqrt(-2 * std::log(1 - random.uniform())) * std::cos(2 * std::numbers::pi * random.uniform());
}

TEST(Curve, FindsTheTruthOfAnExactCurve) {
  for (const Law law : {Law::kExponential, Law::kPower})
    for (const double a : {0.1, 12.0})
      for (const double c : {0.7, 2.0, 3.5}) {
        const Curve fit = fit_curve(exact(law, a, 3, c, 20));
        ASSERT_TRUE(fit.fitted);
        EXPECT_EQ(fit.law, law) << a << " " << c;
        EXPECT_THAT(fit.a, DoubleNear(a, 1e-4)) << c;
        EXPECT_THAT(fit.b, DoubleNear(3, 1e-3));
        EXPECT_THAT(fit.c, DoubleNear(c, 1e-3));
        EXPECT_THAT(fit.low, DoubleNear(a, 0.01));
        EXPECT_THAT(fit.high, DoubleNear(a, 0.01));
      }
  const Curve fit = fit_curve(Law::kExponential, exact(Law::kExponential, 1, 3, 4, 20));
  EXPECT_THAT(fit.half_way, DoubleNear(4 * std::numbers::ln2, 1e-3));
  EXPECT_THAT(fit.at(1), DoubleNear(4, 1e-3));
}

TEST(Curve, LeftOutAttemptsKeepTheirNumbers) {
  std::vector<double> y = exact(Law::kExponential, 2, 5, 3, 14), n;
  for (int i = 1; i <= 14; ++i) n.push_back(i);
  y[4] = std::numeric_limits<double>::quiet_NaN();
  y.erase(y.begin() + 8);
  n.erase(n.begin() + 8);
  const Curve fit = fit_curve(Law::kExponential, y, n);
  EXPECT_THAT(fit.a, DoubleNear(2, 1e-4));
  EXPECT_THAT(fit.c, DoubleNear(3, 1e-3));
}

TEST(Curve, NeedsEightAttempts) {
  const Curve fit = fit_curve(exact(Law::kPower, 1, 2, 1, 5));
  EXPECT_FALSE(fit.fitted);
  EXPECT_THAT(fit.why_not, HasSubstr("8 attempts: 3 more"));
  EXPECT_TRUE(fit_curve(exact(Law::kPower, 1, 2, 1, 8)).fitted);
}

TEST(Curve, AFlatOneHasItsLevelAndNoWidth) {
  const Curve fit = fit_curve(std::vector<double>(10, 4.5));
  EXPECT_TRUE(fit.fitted);
  EXPECT_EQ(fit.low, 4.5);
  EXPECT_EQ(fit.high, 4.5);
}

TEST(Curve, ALineHasNoLevelBelow) {
  std::vector<double> line;
  base::Xoshiro256 random(3);
  for (int i = 0; i < 12; ++i) line.push_back(20.0 - i + 0.5 * normal(random));
  const Curve fit = fit_curve(Law::kExponential, line);
  EXPECT_LT(fit.low, 0) << "wherever it ends, it is not seen yet";
}

// The interval of the level holds the truth in 95 of 100 trainees; with a wrong interval (of two deviations of a mean, say) it does
// so in far fewer. 600 trainees: two standard errors are 1.8 points.
TEST(Curve, TheIntervalCoversTheTruth) {
  for (const int n : {8, 15, 40}) {
    base::Xoshiro256 random(static_cast<uint64_t>(100 + n));
    int covered = 0, naive = 0;
    constexpr int kTrainees = 600;
    for (int i = 0; i < kTrainees; ++i) {
      std::vector<double> y = exact(Law::kExponential, 10, 20, 3, n);
      for (double& v : y) v += 2 * normal(random);
      const Curve fit = fit_curve(Law::kExponential, y);
      covered += fit.low <= 10 && 10 <= fit.high;
      naive += std::abs(fit.a - 10) < 2 * fit.spread / std::sqrt(n);
    }
    const double share = static_cast<double>(covered) / kTrainees;
    EXPECT_GT(share, 0.925) << n;
    EXPECT_LT(share, 0.99) << n << ": an interval that always covers says nothing";
    EXPECT_LT(naive, covered) << n;
  }
}

TEST(Curve, ChoosesTheLawThatDrewIt) {
  base::Xoshiro256 random(11);
  for (const Law law : {Law::kExponential, Law::kPower}) {
    int right = 0;
    for (int i = 0; i < 100; ++i) {
      std::vector<double> y = exact(law, 10, 20, law == Law::kPower ? 0.8 : 4, 40);
      for (double& v : y) v += 0.5 * normal(random);
      right += fit_curve(y).law == law;
    }
    EXPECT_GT(right, 90);
  }
}

TEST(Recent, IsTheMedianOfTheLastFive) {
  const Recent r = recent(std::vector<double>{100, 90, 5, 1, 3, NAN, 2, 4});
  EXPECT_EQ(r.n, 5u);
  EXPECT_EQ(r.median, 3);
  EXPECT_EQ(r.low, 1);
  EXPECT_EQ(r.high, 5);
  EXPECT_EQ(recent({}).n, 0u);
}

TEST(Band, IsThatOfAllAttemptsAndNamesWhoIsAtypical) {
  std::vector<std::vector<double>> experts = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9, 10}, {11}, {}};
  Band band = expert_band(experts);
  EXPECT_EQ(band.people, 4u);
  EXPECT_EQ(band.attempts, 11u);
  EXPECT_EQ(band.median, 6);
  EXPECT_EQ(band.p10, 2);   // type 7: 1 + 0.1 x 10
  EXPECT_EQ(band.p90, 10);
  EXPECT_TRUE(band.left_out.empty());
  experts = {{1}, {1.1}, {0.9}, {1}, {1.05}, {0.95}, {5}};
  EXPECT_THAT(expert_band(experts).left_out, ElementsAre(6u));
  EXPECT_TRUE(std::isnan(expert_band({}).median));
}

}  // namespace
}  // namespace swage::judge
