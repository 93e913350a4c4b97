// SPDX-License-Identifier: Apache-2.0
//
// The law of lost hands finds a leap when there is one: traces that follow it, and the same with the catching up turned off.
#include "lost_hand_law.hpp"

#include <gtest/gtest.h>

namespace swage::test {
namespace {

constexpr double kSwing = 1.5e-3, kTop = kSwing * 3.2;  // m, m/s
constexpr double kGain = 5;                               // N per unit of closure
double x_of(double t) { return kSwing * std::sin(3.14 * t); }
double closure_of(double t) { return 0.5 + 0.5 * std::cos(3.14 * t); }

/// Four seconds of a hand that goes to and fro and is not heard from 1.6 s on for `gap`; a tool and jaws that follow it.
struct Trace {
  HeardHand hand;
  std::vector<ToolLook> looks;
  std::vector<LedPoint> path;
  std::vector<double> grip;

  enum class Follows { kLaw, kHandAtOnce };
  Trace(double gap, Follows how) {
    double offset = 0, tool = 0, held = 0, gone = 0;
    bool meeting = false;
    swage_sample last{};
    for (uint64_t step = 0; step < 4000; ++step) {
      const double t = 1e-3 * static_cast<double>(step);
      path.push_back({t, x_of(t), closure_of(t)});
      swage_sample s = last;
      s.valid = 0;
      if (t < 1.6 || t >= 1.6 + gap) {
        s.sequence += 1;
        s.time_s = t;
        s.pose.p.x = x_of(t);
        s.closure = closure_of(t);
        s.valid = SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE;
        const bool again = gone >= kLostS && how == Follows::kLaw;
        if (again) offset = tool - x_of(t), meeting = true;
        gone = 0;
        tool = x_of(t) + offset;
        if (std::abs(s.closure - held) <= kMetWithin) meeting = false;
        if (!meeting) held = s.closure;
      } else {
        gone += 1e-3;
      }
      last = s;
      hand.sample.push_back(s);
      if (step % 2 == 1) looks.push_back({step + 1, t, {tool, 0, 0}});
      grip.push_back(kGain * held);
    }
  }
  int beside_x() const {
    return beside_the_way(hand, SWAGE_VALID_POSE, path, looks, 1e-6, [](const swage_sample& s) { return s.pose.p.x; },
                          [](const LedPoint& p) { return p.x; });
  }
};

TEST(LostHandLaw, NothingLeapsInATraceThatKeepsIt) {
  for (const double gap : {0.0, 0.03, 0.09, 0.2, 0.7}) {
    const Trace trace(gap, Trace::Follows::kLaw);
    EXPECT_LT(tool_leap(trace.hand, trace.looks), 1e-9) << gap;
    EXPECT_LT(grip_leap(trace.hand, trace.grip, kGain), 0.05) << gap;
    EXPECT_EQ(faster_than_led(trace.hand, gap < 0.05 ? kTop : 1e3), 0) << gap;
    EXPECT_EQ(trace.beside_x(), 0) << gap;
  }
}

// A look that came 200 ms late is no leap: the samples that were heard meanwhile explain it.
TEST(LostHandLaw, AnOnlookerThatWasHeldUpFindsNothing) {
  Trace trace(0.2, Trace::Follows::kLaw);
  std::vector<ToolLook> few;
  for (std::size_t i = 0; i < trace.looks.size(); i += i % 3 == 0 ? 100 : 1) few.push_back(trace.looks[i]);
  EXPECT_LT(tool_leap(trace.hand, few), 1e-9);
}

TEST(LostHandLaw, AHandThatIsNotMetAgainLeaps) {
  const Trace trace(0.2, Trace::Follows::kHandAtOnce);
  EXPECT_GT(tool_leap(trace.hand, trace.looks), 0.3e-3) << "m: 0.2 s of the hand at once";
  EXPECT_GT(grip_leap(trace.hand, trace.grip, kGain), 0.5) << "N";
}

TEST(LostHandLaw, JawsThatSpringOpenWhileNobodyIsHeardLeap) {
  Trace trace(0.2, Trace::Follows::kLaw);
  for (std::size_t i = 1700; i < 1800; ++i) trace.grip[i] = 0;
  EXPECT_GT(grip_leap(trace.hand, trace.grip, kGain), 0.5) << "N";
}

TEST(LostHandLaw, AToolThatGoesOnWhileNobodyIsHeardLeaps) {
  Trace trace(0.2, Trace::Follows::kLaw);
  for (ToolLook& look : trace.looks)
    if (look.step > 1700) look.p.x += 0.05e-3;
  EXPECT_GT(tool_leap(trace.hand, trace.looks), 0.03e-3);
}

// A driver that says, for one sample, that its arm is in the middle: every sample in its turn is a place of the person, and that one is not.
TEST(LostHandLaw, ADriverThatMakesUpAPlaceIsFound) {
  Trace trace(0.03, Trace::Follows::kLaw);
  trace.hand.sample[2400].pose.p.x = 0;
  EXPECT_GT(trace.beside_x(), 0);
  EXPECT_GT(faster_than_led(trace.hand, kTop), 0);
}

// Nor may it be where the person was before: a driver that repeats an old place goes back in time.
TEST(LostHandLaw, ADriverThatGoesBackIsFound) {
  Trace trace(0.03, Trace::Follows::kLaw);
  for (std::size_t i = 2400; i < 2420; ++i) trace.hand.sample[i].pose.p.x = x_of(1.9);
  EXPECT_GT(trace.beside_x(), 0);
}

}  // namespace
}  // namespace swage::test
