// SPDX-License-Identifier: Apache-2.0
//
// The driver of arms against a libHD.so that checks its caller: life cycle, units, errors, calibration, forces.
#include "openhaptics/openhaptics.hpp"

#include <dlfcn.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <swage/testbed.hpp>
#include <time.h>

#include <cmath>
#include <limits>

#include "openhaptics/sentences.hpp"
#include "test_places.hpp"

namespace swage::openhaptics {
namespace {

using testing::HasSubstr;
using Bench = testbed::DeviceBench<Openhaptics>;

const std::string kFake = SWAGE_BINARY_DIR "/tests/fake_hd/libHD.so";

/// The fake's own door.
template <class R, class... A>
R fake(const char* name, A... arguments) {
  static void* const library = dlopen(kFake.c_str(), RTLD_NOW | RTLD_LOCAL);
  return reinterpret_cast<R (*)(A...)>(dlsym(library, name))(arguments...);
}

class Arm : public testing::Test {
 protected:
  Arm() {
    fake<void>("fake_reset");
    bench_.set_text("library", kFake);
  }
  void start() { ASSERT_TRUE(bench_.start()) << (bench_.host.reports.empty() ? "" : bench_.host.reports[0]); }
  static void stop(Bench& bench) {
    bench.host.role = SWAGE_THREAD_MAIN;
    bench.get<swage_device>(SWAGE_EXT_DEVICE)->close(bench.raw);
  }
  /// Asks until it is so; CTest's limit ends what never comes.
  template <class F>
  void until(F done) {
    while (!done()) {
      ask();
      const timespec pause{0, 1'000'000};
      nanosleep(&pause, nullptr);
    }
  }
  void ask() {
    command_.deadline_s = now_s() + deadline_;
    bench_.command = command_;
    EXPECT_GE(bench_.exchange(now_s()), 0);
  }
  void ticks(unsigned long n) {
    const auto from = fake<unsigned long>("fake_ticks");
    until([&] { return fake<unsigned long>("fake_ticks") >= from + n; });
  }
  static double force() { return fake<double>("fake_force"); }
  static std::string wrong() { return fake<const char*>("fake_wrong"); }

  Bench bench_;
  swage_command command_{};
  double deadline_ = 10;  // s: a busy machine is no lost host
};

TEST_F(Arm, PosesAreInMetresAndTheInstrumentGoesWhereTheStylusPoints) {
  start();
  EXPECT_THAT(bench_.host.reports.at(0), HasSubstr(say::kArm("Fake arm", "F-1")));
  fake<void>("fake_move", 12.0);
  until([&] { return std::abs(bench_.sample.pose.p.x - 12e-3) < 1e-9; });
  EXPECT_NEAR(bench_.sample.pose.p.y, 20e-3, 1e-12);
  EXPECT_NEAR(bench_.sample.pose.p.z, 30e-3, 1e-12);
  EXPECT_NEAR(bench_.sample.twist.v.x, 5e-3, 1e-12);
  const toolkit::Quat q = toolkit::quat(bench_.sample.pose.q);
  EXPECT_LT((q * Vec3::UnitX() + Vec3::UnitY()).norm(), 1e-3) << "the stylus points down";
  EXPECT_NEAR(q.norm(), 1, 1e-12);
  EXPECT_NE(bench_.sample.valid & SWAGE_VALID_CLOSURE, 0u);
  stop(bench_);
  EXPECT_EQ(wrong(), "");
}

TEST_F(Arm, ButtonsCloseTheJaws) {
  start();
  fake<void>("fake_press", 1);
  until([&] { return bench_.sample.closure > 0.3; });
  EXPECT_EQ(bench_.sample.buttons, 1u);
  fake<void>("fake_press", 2);
  until([&] { return bench_.sample.closure < 0.1; });
  stop(bench_);
}

TEST_F(Arm, GivesWhatTheGuardLetsThroughAndNoMore) {
  start();
  command_.force = {-1, 0, 0};
  until([&] { return force() == -1; });
  command_.force = {100, 0, 0};
  until([&] { return std::abs(force() - 3.3) < 1e-9; });
  command_.force = {std::numeric_limits<double>::quiet_NaN(), 0, 0};
  until([&] { return force() == 0; });
  EXPECT_LE(fake<double>("fake_most"), 3.3 + 1e-9);
  EXPECT_LE(fake<double>("fake_jump"), 300 * 5e-3 + 1e-9) << "a tick after a gap of 5 ms and more";
  stop(bench_);
  EXPECT_EQ(wrong(), "");
}

// the servo goes on from the force that was for where the hand was
TEST_F(Arm, ClosesTheLoopOnTheAnchorBetweenTwoCommands) {
  start();
  ticks(20);
  command_.stiffness = 200;
  until([&] { return true; });
  ticks(5);
  const double before = force();
  deadline_ = 1e6;
  ask();
  // nobody asks any more; the hand moves by 5 mm, and the force with it
  fake<void>("fake_move", 5.0);
  const auto from = fake<unsigned long>("fake_ticks");
  while (fake<unsigned long>("fake_ticks") < from + 50) {
    const timespec pause{0, 1'000'000};
    nanosleep(&pause, nullptr);
  }
  EXPECT_NEAR(force(), before - 200 * 5e-3, 1e-6);
  stop(bench_);
  EXPECT_EQ(wrong(), "") << "and no force is left when it is disabled";
}

TEST_F(Arm, AnOldCommandIsNotObeyed) {
  start();
  command_.force = {1, 0, 0};
  until([&] { return force() == 1; });
  deadline_ = -1;
  until([&] { return force() == 0; });
  stop(bench_);
}

TEST_F(Arm, WarmMotorsLoseTheirForceAndNotThePose) {
  start();
  command_.force = {1, 0, 0};
  until([&] { return force() == 1; });
  fake<void>("fake_raise", 0x200u);
  until([&] { return force() == 0; });
  const uint64_t last = bench_.sample.sequence;
  until([&] { return bench_.sample.sequence > last + 5; });
  EXPECT_EQ(force(), 0) << "until the next start";
  stop(bench_);
  EXPECT_EQ(wrong(), "");
}

TEST_F(Arm, AnArmThatIsPulledOutIsSilentAndComesBack) {
  start();
  until([&] { return bench_.sample.sequence > 5; });
  fake<void>("fake_plug", 0);
  uint64_t last = 0;
  // silent: no new sample in a hundred questions
  for (int same = 0; same < 100; same = bench_.sample.sequence == last ? same + 1 : 0) {
    last = bench_.sample.sequence;
    ask();
    const timespec pause{0, 1'000'000};
    nanosleep(&pause, nullptr);
  }
  fake<void>("fake_plug", 1);
  fake<void>("fake_move", 3.0);
  until([&] { return bench_.sample.sequence > last + 5; });
  EXPECT_NEAR(bench_.sample.pose.p.x, 3e-3, 1e-9);
  stop(bench_);
  EXPECT_EQ(wrong(), "");
}

TEST_F(Arm, IsTakenOverFromAProgramThatCrashed) {
  fake<void>("fake_busy", 3);
  start();
  stop(bench_);
  EXPECT_EQ(wrong(), "");
}

TEST_F(Arm, CalibrationNeedsTheInkwell) {
  fake<void>("fake_calibration", 0x5002u, 0);
  EXPECT_FALSE(bench_.start());
  EXPECT_THAT(bench_.host.reports.at(0), HasSubstr(say::kNotCalibrated()));
  EXPECT_EQ(wrong(), "");
}

TEST_F(Arm, AnUpdateOfTheCalibrationIsMadeInTheServo) {
  fake<void>("fake_calibration", 0x5001u, 1);
  start();
  until([&] { return fake<int>("fake_calibrated") > 0; });
  stop(bench_);
  EXPECT_EQ(fake<int>("fake_calibrated"), 1);
}

TEST_F(Arm, AbsentThingsAreToldWithTheRemedy) {
  fake<void>("fake_plug", 0);
  EXPECT_FALSE(bench_.start());
  EXPECT_THAT(bench_.host.reports.at(0), HasSubstr(say::kNoArm("device fault")));
  Bench none;
  none.set_text("library", "/no/such/libHD.so");
  EXPECT_FALSE(none.start());
  EXPECT_THAT(none.host.reports.at(0), HasSubstr(say::kNoLibrary.words(0) + "/no/such/libHD.so"));
  Bench other;
  other.set_text("library", "libm.so.6");
  EXPECT_FALSE(other.start());
  EXPECT_THAT(other.host.reports.at(0), HasSubstr(say::kLacks("hdInitDevice")));
}

TEST_F(Arm, OpensAndClosesAHundredTimes) {
  for (int i = 0; i < 100; ++i) {
    Bench bench;
    bench.set_text("library", kFake);
    ASSERT_TRUE(bench.start()) << i;
    bench.exchange(now_s());
    stop(bench);
  }
  EXPECT_EQ(wrong(), "");
}

}  // namespace
}  // namespace swage::openhaptics
