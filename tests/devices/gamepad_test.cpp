// SPDX-License-Identifier: Apache-2.0
//
// The game pad's driver against a pad that SDL makes up: every axis, two halves, pulled out and put back.
#include "gamepad/gamepad.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <swage/testbed.hpp>
#include <time.h>

#include <cmath>
#include <random>

#include "gamepad/sentences.hpp"
#include "virtual_pad.hpp"

namespace swage::gamepad {
namespace {

using test::VirtualPad;
using testing::HasSubstr;
using toolkit::Vec3;
using Bench = testbed::DeviceBench<Gamepad>;

double now_s() {
  timespec t;
  clock_gettime(CLOCK_MONOTONIC, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

void nap(double seconds) {
  const timespec pause{0, static_cast<long>(1e9 * seconds)};
  nanosleep(&pause, nullptr);
}

class Pad : public testing::Test {
 protected:
  void SetUp() override { ASSERT_TRUE(VirtualPad::possible()) << "the package libsdl2-2.0-0 is missing"; }
  /// Asks for a while; how many new samples came.
  static int ask(Bench& bench, double seconds) {
    int came = 0;
    int asked = 0;  // a busy machine asks as often as a quick one
    for (const double until = now_s() + seconds; now_s() < until || asked < 200 * seconds; nap(2e-3), ++asked) {
      const swage_sample last = bench.sample;
      EXPECT_GE(bench.exchange(now_s()), 0);
      came += bench.sample.sequence != last.sequence;
      EXPECT_LT((p(bench) - toolkit::vec(last.pose.p)).norm(), 50e-3 * 25e-3 + 1e-9) << "never farther than 50 ms at full speed";
    }
    return came;
  }
  static Vec3 p(const Bench& bench) { return toolkit::vec(bench.sample.pose.p); }
  static Vec3 turned(const Bench& bench) { return toolkit::log_rotation(toolkit::quat(bench.sample.pose.q)); }
  static void start_flat(Bench& bench) {
    bench.set("start_axis", 1, 0, 0);
    bench.set("start_closing", 0, 0, 1);
    ASSERT_TRUE(bench.start()) << (bench.host.reports.empty() ? "" : bench.host.reports[0]);
    ask(bench, 0.05);
  }
};

// The levels of SDL (SDL_joystick.h): each is the upper end of its range, and a wire needs no charge.
TEST_F(Pad, TellsItsBatteryByTheLevelsOfSdl) {
  EXPECT_EQ(battery_of(0), 0.05);
  EXPECT_EQ(battery_of(1), 0.2);
  EXPECT_EQ(battery_of(2), 0.7);
  EXPECT_EQ(battery_of(3), 1);
  EXPECT_TRUE(std::isnan(battery_of(4)));
  EXPECT_TRUE(std::isnan(battery_of(-1)));
  VirtualPad pad;
  Bench bench;
  start_flat(bench);
  const auto* signals = bench.get<swage_device_signals>(SWAGE_EXT_DEVICE_SIGNALS);
  ASSERT_NE(signals, nullptr);
  ASSERT_EQ(signals->count, 1u);
  EXPECT_STREQ(signals->signal[0].id, "pad.battery");
  double told = 0;
  ASSERT_EQ(signals->read(bench.raw, &told), SWAGE_OK);
  EXPECT_TRUE(std::isnan(told)) << "SDL does not know that of a pad that it makes up";
}

TEST_F(Pad, NoneIsToldWithTheRemedy) {
  Bench bench;
  EXPECT_FALSE(bench.start());
  ASSERT_FALSE(bench.host.reports.empty());
  EXPECT_THAT(bench.host.reports[0], HasSubstr(say::kNoPad()));
  VirtualPad pad;
  Bench other;
  other.set_text("pad", "Nobody's");
  EXPECT_FALSE(other.start());
  EXPECT_THAT(other.host.reports[0], HasSubstr(say::kNoSuchPad.words(0) + "Nobody's" + say::kNoSuchPad.words(1)));
}

TEST_F(Pad, EveryAxisGoesItsWay) {
  VirtualPad pad;
  const auto moved = [&](auto press, auto release) {
    Bench bench;
    start_flat(bench);
    press();
    ask(bench, 0.3);
    release();
    ask(bench, 0.3);
    return std::pair{p(bench), turned(bench)};
  };
  const auto stick = [&](Axis a, double value) {
    return moved([&] { pad.axis(a, value); }, [&] { pad.axis(a, 0); });
  };
  const auto button = [&](Button b) {
    return moved([&] { pad.button(b, true); }, [&] { pad.button(b, false); });
  };
  const auto mostly = [](const Vec3& v, int axis, int sign) {
    Vec3 rest = v;
    rest[axis] = 0;
    return sign * v[axis] > 1e-3 && rest.norm() < 1e-9;
  };
  EXPECT_TRUE(mostly(stick(kLeftX, 1).first, 0, 1)) << "right";
  EXPECT_TRUE(mostly(stick(kLeftY, -1).first, 1, 1)) << "a stick pushed away goes up";
  EXPECT_TRUE(mostly(button(kLeftShoulder).first, 2, 1)) << "towards the user";
  EXPECT_TRUE(mostly(button(kRightShoulder).first, 2, -1)) << "away";
  EXPECT_TRUE(mostly(stick(kRightX, 1).second, 1, 1));
  EXPECT_TRUE(mostly(stick(kRightY, 1).second, 0, 1));
  EXPECT_TRUE(mostly(button(kLeft).second, 2, 1)) << "rolls left";
}

TEST_F(Pad, SpeedIsWhatTheParametersSay) {
  VirtualPad pad;
  Bench bench;
  bench.set("move", 10e-3);
  bench.set("smoothing", 0);
  start_flat(bench);
  const auto speed = [&](double value) {
    pad.axis(kLeftX, value);
    ask(bench, 0.05);
    return bench.sample.twist.v.x;
  };
  EXPECT_NEAR(speed(1), 10e-3, 1e-9);
  EXPECT_NEAR(speed(0.55), 10e-3 * 0.25, 1e-6) << "half of the way beyond the dead zone, squared";
  EXPECT_NEAR(speed(-0.55), -10e-3 * 0.25, 1e-5);
  EXPECT_EQ(speed(0.09), 0) << "a worn stick rests there";
  pad.button(kLeftStick, true);
  EXPECT_NEAR(speed(1), 2.5e-3, 1e-9) << "fine";
  pad.button(kLeftStick, false);
}

TEST_F(Pad, TriggersAreJaws) {
  VirtualPad pad;
  Bench follows, stays;
  stays.set("trigger", 1);
  stays.set("close_time", 0.5);
  start_flat(follows);
  start_flat(stays);
  EXPECT_NEAR(follows.sample.closure, 0, 1e-3);
  pad.axis(kRightTrigger, 0);
  ask(follows, 0.02);
  EXPECT_NEAR(follows.sample.closure, 0.5, 1e-3);
  EXPECT_EQ(follows.sample.valid, SWAGE_VALID_POSE | SWAGE_VALID_TWIST | SWAGE_VALID_CLOSURE | SWAGE_VALID_BUTTONS);
  pad.axis(kRightTrigger, 1);
  ask(stays, 0.25);
  EXPECT_GT(stays.sample.closure, 0.3);
  pad.axis(kRightTrigger, -1);
  ask(stays, 0.02);
  const double left = stays.sample.closure;
  ask(stays, 0.1);
  EXPECT_EQ(stays.sample.closure, left) << "the jaws stay";
  pad.axis(kLeftTrigger, 1);
  for (const double until = now_s() + 60; stays.sample.closure > 0 && now_s() < until;) ask(stays, 0.1);
  EXPECT_EQ(stays.sample.closure, 0) << "and open with the other one";
}

TEST_F(Pad, TwoHalvesLeadTwoInstruments) {
  VirtualPad pad;
  Bench left, right;
  left.set("half", 1);
  right.set("half", 2);
  start_flat(left);
  start_flat(right);
  pad.axis(kLeftX, 1);
  pad.axis(kRightY, 1);
  pad.axis(kLeftTrigger, 0);
  pad.axis(kRightTrigger, 1);
  for (int i = 0; i < 20; ++i) ask(left, 5e-3), ask(right, 5e-3);
  EXPECT_GT(p(left).x(), 0.2e-3);
  EXPECT_EQ(p(left).y(), 0);
  EXPECT_LT(p(right).y(), -0.2e-3);
  EXPECT_EQ(p(right).x(), 0);
  EXPECT_NEAR(left.sample.closure, 0.5, 1e-3);
  EXPECT_NEAR(right.sample.closure, 1, 1e-3);
  // with the shoulder button the stick goes in depth and rolls
  const Vec3 before = p(right);
  pad.button(kRightShoulder, true);
  ask(right, 0.3);
  EXPECT_GT(p(right).z(), before.z() + 1e-3) << "pulled back is towards the user";
}

TEST_F(Pad, APulledPadIsSilenceAndComesBackWhereItsToolStands) {
  VirtualPad pad;
  Bench bench;
  start_flat(bench);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> moment(0.002, 0.08);
  for (int round = 0; round < 100; ++round) {
    pad.axis(kLeftX, round % 2 == 0 ? 1 : -1);
    pad.axis(kRightTrigger, 0);
    ask(bench, moment(random));
    pad.unplug();
    const swage_sample held = bench.sample;
    EXPECT_EQ(ask(bench, moment(random)), 0) << "round " << round;
    EXPECT_EQ(bench.sample.pose.p.x, held.pose.p.x);
    pad.plug();
    pad.axis(kRightTrigger, 0);
    const double until = now_s() + 60;
    while (bench.sample.sequence == held.sequence && now_s() < until) ask(bench, 2e-3);
    ASSERT_LT(now_s(), until) << "round " << round;
    // the stick rests after it was plugged in: nothing but the low pass of before could move it
    EXPECT_LT((p(bench) - toolkit::vec(held.pose.p)).norm(), 1e-9) << "round " << round;
  }
}

TEST(RateHand, NothingMovesFartherThanItsSpeedWhateverItIsTold) {
  std::mt19937 random(1);
  const double odd[] = {0, 1, -1, 2, -1e300, std::nan(""), INFINITY, 0.3};
  rate::RateHand hand;
  const rate::Speeds speeds;
  for (int i = 0; i < 100000; ++i) {
    const auto any = [&] { return odd[random() % 8]; };
    const Vec3 before = hand.pose().p;
    hand.step({any(), any(), any()}, {any(), any(), any()}, speeds, random() % 7 == 0 ? any() : 1e-3);
    ASSERT_TRUE(hand.pose().p.allFinite() && hand.pose().q.coeffs().allFinite()) << i;
    ASSERT_LT((hand.pose().p - before).norm(), 0.05 * speeds.move * std::sqrt(3.0) + 1e-12);
  }
}

}  // namespace
}  // namespace swage::gamepad
