// SPDX-License-Identifier: Apache-2.0
#include "session/cue_force.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "fake_device.hpp"
#include "session/device_ports.hpp"

namespace swage::session {
namespace {

constexpr double kDt = 1e-3;
constexpr uint32_t kGood = 0, kWrong = 1;
const CuePulse kTwoPulses{"grasp.good", 2, 160, 0.1, 0.03};
const CuePulse kOnePulse{"grasp.wrong", 1, 60, 0.2, 0.06};

judge::Script script() {
  judge::Script out;
  out.cues.resize(2);
  out.cues[kGood].id = "grasp.good";
  out.cues[kWrong].id = "grasp.wrong";
  out.marks.resize(1);
  return out;
}

judge::Verdict nothing() {
  judge::Verdict out;
  out.object_cue = {SWAGE_NONE, SWAGE_NONE};
  out.mark_cue = {SWAGE_NONE};
  return out;
}

// greatest force of so many steps
double strongest(CueForce& cue, const judge::Verdict& verdict, int steps) {
  double most = 0;
  for (int i = 0; i < steps; ++i) most = std::max(most, std::abs(cue.tick(verdict, kDt)));
  return most;
}

TEST(PulseForce, IsATrainThatBeginsAndEndsAtNothing) {
  const double end = length(kTwoPulses);
  EXPECT_DOUBLE_EQ(end, 0.12);
  double most = 0;
  for (double t = 0; t < end; t += 1e-5) {
    const double f = pulse_force(kTwoPulses, t);
    most = std::max(most, std::abs(f));
    const bool pause = std::fmod(t, 0.06) >= 0.03;
    if (pause) {
      EXPECT_EQ(f, 0) << t;
    }
  }
  EXPECT_NEAR(most, 0.1, 0.01);
  EXPECT_EQ(pulse_force(kTwoPulses, 0), 0);
  EXPECT_EQ(pulse_force(kTwoPulses, end), 0);
  EXPECT_EQ(pulse_force(kTwoPulses, -1), 0);
  // the two pulses are alike
  EXPECT_NEAR(pulse_force(kTwoPulses, 0.011), pulse_force(kTwoPulses, 0.071), 1e-12);
}

TEST(PulseForce, GrowsNoFasterThanAGuardLetsThrough) {
  // |dF/dt| <= peak (2 pi f + pi / length); the guard's slew is 300 N/s
  const double bound = kTwoPulses.peak * (2 * M_PI * kTwoPulses.frequency + M_PI / kTwoPulses.length);
  EXPECT_LT(bound, ForceLimits().slew);
  for (double t = 0; t < length(kTwoPulses); t += 1e-5)
    EXPECT_LE(std::abs(pulse_force(kTwoPulses, t + 1e-5) - pulse_force(kTwoPulses, t)), bound * 1e-5 * 1.001);
}

TEST(CueForce, PlaysACueOnceWhenItComesOn) {
  CueForce cue(script(), {true, true}, {kTwoPulses, kOnePulse}, 2);
  judge::Verdict v = nothing();
  EXPECT_EQ(strongest(cue, v, 50), 0);
  v.object_cue[1] = kGood;
  EXPECT_NEAR(strongest(cue, v, 130), 0.1, 0.02);
  EXPECT_EQ(strongest(cue, v, 500), 0);  // still on: no news
  v.object_cue[1] = SWAGE_NONE;
  EXPECT_EQ(strongest(cue, v, 50), 0);
  v.mark_cue[0] = kWrong;
  EXPECT_NEAR(strongest(cue, v, 130), 0.2, 0.02);
}

TEST(CueForce, ACueThatFlickersIsNoRattle) {
  CueForce cue(script(), {true, true}, {kTwoPulses, kOnePulse}, 2);
  judge::Verdict v = nothing();
  double last = 0, jump = 0;
  for (int i = 0; i < 1000; ++i) {
    v.object_cue[0] = i % 2 == 0 ? kGood : kWrong;
    const double f = cue.tick(v, kDt);
    jump = std::max(jump, std::abs(f - last));
    last = f;
  }
  // no train is cut: the greatest step is that of the steeper train, 0.1 N 2 pi 160 Hz 1 ms
  EXPECT_LT(jump, 0.11);
  // a cue that comes on while another plays follows it whole
  strongest(cue, nothing(), 400);
  v = nothing();
  v.object_cue[0] = kGood;
  strongest(cue, v, 10);
  v.object_cue[0] = kWrong;
  strongest(cue, v, 111);
  EXPECT_NEAR(strongest(cue, v, 121), 0.2, 0.02);
}

TEST(CueForce, WhatTheLessonDoesNotLetFeelIsNotFelt) {
  CueForce none(script(), {false, false}, {kTwoPulses, kOnePulse}, 2), unknown(script(), {true, true}, {}, 2);
  judge::Verdict v = nothing();
  v.object_cue[0] = kGood;
  EXPECT_EQ(strongest(none, v, 200), 0);
  EXPECT_EQ(strongest(unknown, v, 200), 0);
}

TEST(CueForce, ReachesTheHandThroughTheGuard) {
  FakeDevice device(SWAGE_DEVICE_FORCE | SWAGE_DEVICE_LOCKSTEP, 0.05);  // bears half of the pulse
  host::DeviceSlot slot = device.slot();
  StepPort port(slot, kDt, true);
  CueForce cue(script(), {true, true}, {kTwoPulses}, 2);
  swage_sample sample{};
  const auto steps = [&](const judge::Verdict& verdict, int count) {
    for (int i = 0; i < count; ++i) {
      port.set_cue_force(cue.tick(verdict, kDt));
      port.read(0, 0, sample);
      port.send({});
    }
  };
  judge::Verdict v = nothing();
  v.object_cue[0] = kGood;
  steps(v, 200);
  EXPECT_EQ(device.most_y.load(), 0);  // nobody has armed it
  port.arm();
  steps(nothing(), 600);
  EXPECT_EQ(device.most_y.load(), 0);
  steps(v, 200);
  EXPECT_GT(device.most_y.load(), 0.03);
  EXPECT_LE(device.most_y.load(), 0.05 + 1e-12);
}

}  // namespace
}  // namespace swage::session
