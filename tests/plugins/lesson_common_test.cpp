// SPDX-License-Identifier: Apache-2.0
//
// What several lessons measure: filters, the way of a hand, spread, quantile, rest, tremor. And the rules that they share.
#include <gtest/gtest.h>

#include <numbers>

#include "lessons/common/measures.hpp"
#include "lessons/common/rules.hpp"
#include "lessons/common/watches.hpp"

namespace swage::lessons {
namespace {

TEST(Measures, QuantileSpreadIdleAndTremor) {
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
  for (int i = 0; i < 2000; ++i) IdleWatch::look(idle, {i < 1000 ? 0 : 2e-6 * (i - 1000), 0, 0}, 0.2, 0, 1e-3, true);
  EXPECT_NEAR(IdleWatch::share(idle), 0.525, 2e-3) << "it has left its place after 0.1 mm, 50 ms";

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

TEST(PathWatch, CountsTheWayWithoutTheTremor) {
  const PathWatch watch(1e-3);
  PathState state;
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
  const LowPass4 motion(6, 1e-3);
  const auto g4 = [&](double f) { return gain<LowPass4, LowPass4State>(motion, f); };
  EXPECT_NEAR(g4(0.5), 1, 1e-3);
  EXPECT_NEAR(g4(6), std::sqrt(0.5), 2e-3);
  EXPECT_NEAR(g4(12), 1 / std::sqrt(1 + 256.0), 2e-3);  // 1 / sqrt(1 + (f / 6)^8)

  const LowPass force(20, 1e-3, LowPass::kCritical);
  const auto g2 = [&](double f) { return gain<LowPass, LowPassState>(force, f); };
  EXPECT_NEAR(g2(1), 1, 5e-3);
  EXPECT_NEAR(g2(20), 0.5, 2e-3);
  EXPECT_NEAR(g2(80), 1.0 / 17, 4e-3);  // 1 / (1 + (f / 20)^2)
}

TEST(LowPass, NoOvershootAndNoStart) {
  const LowPass force(20, 1e-3, LowPass::kCritical);
  LowPassState state;
  EXPECT_NEAR(force.next(state, 3.0), 3.0, 1e-12) << "the first value has stood for ever";
  double most = 0;
  for (int i = 0; i < 500; ++i) most = std::max(most, force.next(state, 4.0));
  EXPECT_NEAR(most, 4, 1e-9);
  EXPECT_LE(most, 4 + 1e-12);
}

// M03: a hand that trembles where it waits is idle; one whose jaws close, that moves slowly or that holds is not
TEST(Measures, IdleIsWhatNeitherMovesNorCloses) {
  const auto share = [](auto&& place, auto&& opening, auto&& force, bool counts) {
    IdleState idle;
    PathState path;
    const PathWatch watch(1e-3);
    for (int i = 0; i < 3000; ++i) {
      const double t = 1e-3 * i;
      watch.look(path, {place(t), 0, 0}, t);
      IdleWatch::look(idle, Eigen::Map<const Vec3>(path.last), opening(t), force(t), 1e-3, counts);
    }
    return IdleWatch::share(idle);
  };
  const auto still = [](double) { return 0.2; };
  const auto grows = [](double t) { return 0.3 * t; };
  const auto trembles = [](double t) { return 140e-6 * std::sin(2 * std::numbers::pi * 8 * t); };  // 100 um, root mean square
  EXPECT_NEAR(share(trembles, still, still, true), 1, 1e-9);
  EXPECT_EQ(share(trembles, [](double t) { return 0.4 - 0.1 * t; }, still, true), 0) << "6 deg/s";
  EXPECT_EQ(share([](double t) { return 0.5e-3 * t; }, still, still, true), 0) << "0.5 mm/s";
  EXPECT_EQ(share(still, still, grows, true), 0) << "0.3 N/s";
  EXPECT_EQ(share(still, still, still, false), 0) << "a hold";
}

// the first force of a grasp at 5 kHz made the steadiness a NaN, and the lesson was blamed
TEST(Spread, OfOneValueIsNone) {
  for (int rate = 200; rate <= 10'000; rate += 7)
    for (int i = 1; i < 50; ++i) {
      SpreadState s;
      spread(s, 0.0123 * i, 1.0 / rate);
      ASSERT_NEAR(deviation(s), 0, 1e-8) << rate << " " << i;
    }
}

// each rule has the value of the parameter of its name, whatever the parameter's place in its struct
TEST(CommonRules, EachIsSetByTheParameterOfItsName) {
  struct Params {
    double lost_distance = 1, drop_distance = 2, max_over_time = 3, max_time = 4, par_time = 5, hold_time = 6;
    int max_drops = 7;
    struct {
      double low = 8, high = 9;
    } force;
  };
  struct Rules {
    double force_low = 0, force_high = 0, hold_time = 0, par_time = 0, max_time = 0, max_over_time = 0;
    int max_drops = 0;
    double drop_distance = 0, lost_distance = 0, own = 10;
    bool ends = false;
  } rules;
  set_common_rules(Params(), false, rules);
  EXPECT_EQ(rules.lost_distance, 1);
  EXPECT_EQ(rules.drop_distance, 2);
  EXPECT_EQ(rules.max_over_time, 3);
  EXPECT_EQ(rules.max_time, 4);
  EXPECT_EQ(rules.par_time, 5);
  EXPECT_EQ(rules.hold_time, 6);
  EXPECT_EQ(rules.max_drops, 7);
  EXPECT_EQ(rules.force_low, 8);
  EXPECT_EQ(rules.force_high, 9);
  EXPECT_EQ(rules.own, 10) << "what a lesson alone has stays";
  EXPECT_TRUE(rules.ends);

  // a judge without the others has no need of their parameters
  struct Times {
    double par_time = 20, max_time = 30;
  };
  struct Few {
    double par_time = 0, max_time = 0;
    bool ends = true;
  } few;
  set_common_rules(Times(), true, few);
  EXPECT_EQ(few.par_time, 20);
  EXPECT_EQ(few.max_time, 30);
  EXPECT_FALSE(few.ends) << "practice ends no attempt";
}

}  // namespace
}  // namespace swage::lessons
