// SPDX-License-Identifier: Apache-2.0
//
// The jaw sensor's driver against a simulated sensor on a pseudo terminal: absent, silent, wrong, unplugged and put back.
#include "jaw_sensor/jaw_sensor.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <swage/testbed.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <random>

#include "jaw_sensor/sentences.hpp"
#include "sensor/calibration_file.hpp"
#include "sensor/sentences.hpp"
#include "sensor_thread.hpp"
#include "temp_folder.hpp"

namespace swage::jaw_sensor {
namespace {

using sensor::now_s;
using sensor::SimulatedSensor;
using test::nap;
using test::SensorThread;
using testing::HasSubstr;

class Driver : public testing::Test {
 protected:
  using Bench = testbed::DeviceBench<JawSensor>;
  Driver() {
    setenv("XDG_DATA_HOME", folder_.path().c_str(), 1);
    options_.rate_hz = 500;
  }
  /// A sensor whose volts are `volts_`.
  std::unique_ptr<SensorThread> plug() {
    return std::make_unique<SensorThread>(
        options_, [this](double) { return SimulatedSensor::Measured{volts_, newtons_, status_}; }, folder_ / "port");
  }
  bool start(Bench& bench) {
    bench.set_text("port", folder_ / "port");
    return bench.start();
  }
  /// Asks every millisecond for a while; how many new samples came.
  int ask(Bench& bench, double seconds) {
    int came = 0;
    for (const double until = now_s() + seconds; now_s() < until; nap(1e-3)) {
      const swage_sample last = bench.sample;
      EXPECT_GE(bench.exchange(now_s()), 0);
      const swage_sample& s = bench.sample;
      if (s.sequence == last.sequence) {
        EXPECT_EQ(s.closure, last.closure) << "nothing new came, nothing changes";
        continue;
      }
      ++came;
      EXPECT_TRUE(std::isfinite(s.closure) && std::isfinite(s.grip_force) && std::isfinite(s.time_s));
      EXPECT_GE(s.time_s, last.time_s);
      EXPECT_LE(s.time_s, now_s());
      most_age_ = std::max(most_age_, now_s() - s.time_s);
    }
    return came;
  }
  /// Asks until so many new samples have come, however busy the machine is.
  int ask_for(Bench& bench, int samples) {
    int came = 0;
    for (const double until = now_s() + 60; came < samples && now_s() < until;) came += ask(bench, 5e-3);
    EXPECT_GE(came, samples);
    return came;
  }
  static std::string said(Bench& bench) {
    std::string out;
    for (const std::string& r : bench.host.reports) out += r + "\n";
    return out;
  }
  static std::string calibration_of(Bench& bench) {
    return std::string(view(bench.get<swage_device_calibration>(SWAGE_EXT_CALIBRATION)->text(bench.raw)));
  }
  static bool closed(const Bench& bench) { return (bench.sample.valid & SWAGE_VALID_CLOSURE) != 0; }

  test::TempFolder folder_;
  SimulatedSensor::Options options_;
  std::atomic<double> volts_{-1}, newtons_{0};
  std::atomic<uint8_t> status_{0};
  double most_age_ = 0;
};

TEST_F(Driver, ASensorThatIsAbsentIsNamedWithTheRemedy) {
  Bench bench;
  EXPECT_FALSE(start(bench));
  EXPECT_THAT(said(bench), HasSubstr(sensor::say::kNotThere.words(1)));
  Bench none;
  none.set_text("port", "/dev/null");
  EXPECT_FALSE(none.start());
  EXPECT_THAT(said(none), HasSubstr(sensor::say::kNoSerialPort("/dev/null")));
}

TEST_F(Driver, ASilentOneAndOneThatSpeaksOtherwiseAreToldApart) {
  auto sensor = plug();
  sensor->with([](SimulatedSensor& s) { s.silent(true); });
  // it answers who it is, and measures nothing
  Bench bench;
  EXPECT_FALSE(start(bench));
  EXPECT_THAT(said(bench), HasSubstr(say::kSilent.words(1) + "115200" + say::kSilent.words(2)));
  std::atomic<bool> stop{false};
  std::thread noise([&] {
    for (std::mt19937 random(1); !stop; nap(5e-3))
      sensor->with([&](SimulatedSensor& s) {
        std::string bytes;
        for (int i = 0; i < 40; ++i) bytes += static_cast<char>(random());
        s.raw(bytes + "\n");
      });
  });
  Bench other;
  EXPECT_FALSE(start(other));
  EXPECT_THAT(said(other), HasSubstr(say::kOtherDialect.words(1)));
  stop = true;
  noise.join();
}

TEST_F(Driver, VoltsBecomeClosureInLinesAndInFrames) {
  for (const bool binary : {false, true}) {
    auto sensor = plug();
    Bench bench;
    bench.set("dialect", binary ? 1 : 0);
    bench.set("rate", binary ? 1000 : 500);
    ASSERT_TRUE(start(bench)) << said(bench);
    EXPECT_THAT(said(bench), HasSubstr(say::kNotCalibrated("SIM1")));
    EXPECT_EQ(calibration_of(bench), "") << "volts as they are";
    for (const auto& [volts, closure] : {std::pair{2.0, 0.0}, {0.5, 0.3}, {-1.0, 0.6}, {-1.5, 0.8}, {-2.0, 1.0}}) {
      volts_ = volts;
      ask(bench, 0.05);  // what was on its way
      ask_for(bench, 100);  // 0.2 s at 500 Hz: the low pass has 5 ms
      ASSERT_TRUE(closed(bench));
      EXPECT_NEAR(bench.sample.closure, closure, 1e-4) << volts << " V";
      EXPECT_EQ(bench.sample.valid & SWAGE_VALID_GRIP, 0u) << "no table, no force";
    }
  }
}

TEST_F(Driver, AStrainGaugeIsForceAndStaysWhileTheJawsMove) {
  options_.grip = true;
  auto sensor = plug();
  newtons_ = 3.25;
  Bench bench;
  bench.set("force", 1);
  ASSERT_TRUE(start(bench));
  ask_for(bench, 20);
  EXPECT_EQ(bench.sample.valid, SWAGE_VALID_CLOSURE | SWAGE_VALID_GRIP);
  EXPECT_NEAR(bench.sample.grip_force, 3.25, 1e-9);
}

TEST_F(Driver, TheStoredCalibrationOfTheSensorIsUsedAndTold) {
  sensor::Calibration c;
  c.serial = "SIM1", c.date = "2026-11-01", c.by = "Ada", c.expires = "2000-01-01";
  c.displacement.slope = 1e-3, c.displacement.worst = 27e-6;
  c.geometry = {40e-3, 40e-3, 10e-3};
  c.poses = {4e-3, 1e-3, -1e-3};
  ASSERT_EQ(c.force.set({{0, 0.2}, {1e-3, 2.2}, {2e-3, 10}}), "");
  ASSERT_EQ(sensor::save_calibration(sensor::calibration_path("SIM1"), c), "");
  auto sensor = plug();
  Bench bench;
  bench.set("held", 0);
  volts_ = 1.001;
  ASSERT_TRUE(start(bench));
  EXPECT_THAT(said(bench), HasSubstr(say::kCalibrated.words(1) + "2026-11-01" + say::kCalibrated.words(2) + "Ada" + say::kCalibrated.words(3) + "27" + say::kCalibrated.words(4)));
  EXPECT_THAT(said(bench), HasSubstr(sensor::say::kExpired.words(1) + "2000-01-01"));
  EXPECT_EQ(calibration_of(bench), sensor::calibration_text(c)) << "what the host keeps with the attempt";
  ask_for(bench, 50);
  EXPECT_NEAR(bench.sample.closure, 0.6, 1e-3);
  EXPECT_EQ(bench.sample.grip_force, 0) << "the jaws have not met";
  EXPECT_EQ(bench.sample.valid, SWAGE_VALID_CLOSURE | SWAGE_VALID_GRIP);
  volts_ = 0;
  ask(bench, 0.05);
  ask_for(bench, 100);
  EXPECT_NEAR(bench.sample.grip_force, 2.0, 1e-3) << "1 mm of further travel: 2.2 N less the 0.2 N that close the jaws";
}

// At the start of a session, and once: a handle that rests beside its place, or a gauge that reads a force there.
TEST_F(Driver, AHandleThatDoesNotRestWhereItWasOpenIsToldOnce) {
  options_.grip = true;
  sensor::Calibration c;
  c.serial = "SIM1", c.date = c.poses_date = sensor::today(), c.by = "Ada", c.expires = "2099-01-01";
  c.displacement.slope = 1e-3, c.poses = {4e-3, 1e-3, -1e-3}, c.gauge_zero = 0.3;
  ASSERT_EQ(sensor::save_calibration(sensor::calibration_path("SIM1"), c), "");
  const auto told = [&](double volts, double newtons) {
    volts_ = volts, newtons_ = newtons;
    auto sensor = plug();
    Bench bench;
    bench.set("force", 1);
    EXPECT_TRUE(start(bench)) << said(bench);
    for (const double until = now_s() + 1; now_s() < until;) ask(bench, 0.1);
    ask_for(bench, 200);
    int times = 0;
    for (const std::string& r : bench.host.reports) times += r.find(sensor::say::kSetZero()) != std::string::npos;
    EXPECT_LE(times, 1);
    return times == 1 ? said(bench) : "";
  };
  EXPECT_EQ(told(4, 0.3), "");
  EXPECT_THAT(told(3.7, 0.3), HasSubstr(sensor::say::kReadsLess("0.30", "10")));
  EXPECT_THAT(told(4.4, 0.3), HasSubstr("0.40" + sensor::say::kReadsMore.words(1)));
  EXPECT_THAT(told(4, 0.8), HasSubstr(sensor::say::kGaugeReads("0.50")));
  EXPECT_EQ(told(1, 5), "") << "a hand holds it";
}

TEST_F(Driver, WrongBytesAndLostMessagesAreCountedAndNeverBelieved) {
  options_.faults.corrupt_each = 7;
  options_.faults.lose_each = 11;
  for (const bool binary : {false, true}) {
    auto sensor = plug();
    Bench bench;
    bench.set("dialect", binary ? 1 : 0);
    volts_ = 0.5;
    ASSERT_TRUE(start(bench)) << said(bench);
    for (int i = 0; i < 100; ++i) {
      ask_for(bench, 2);
      EXPECT_TRUE(closed(bench));
      EXPECT_NEAR(bench.sample.closure, 0.3, 1e-4);
    }
  }
}

TEST_F(Driver, ASensorOutOfItsStrokeMeasuresNothing) {
  auto sensor = plug();
  Bench bench;
  ASSERT_TRUE(start(bench));
  for (const uint8_t bad : {sensor::kOverRange, sensor::kUnderRange, sensor::kUnplugged}) {
    status_ = 0;
    ask(bench, 0.05);
    ask_for(bench, 20);
    EXPECT_TRUE(closed(bench));
    status_ = bad;
    ask(bench, 0.05);
    ask_for(bench, 20);
    EXPECT_EQ(bench.sample.valid, 0u) << "the host holds the jaws then";
  }
  status_ = sensor::kSupplyLow;
  ask(bench, 0.05);
  ask_for(bench, 20);
  EXPECT_TRUE(closed(bench));
}

TEST_F(Driver, ReadersOfOthersArePolledAndNanIsNoNumber) {
  auto sensor = plug();
  sensor->with([](SimulatedSensor& s) { s.silent(true); });
  std::atomic<bool> stop{false};
  std::atomic<int> n{0};
  std::thread reader([&] {
    for (; !stop; nap(2e-3))
      sensor->with([&](SimulatedSensor& s) { s.raw(++n % 3 == 0 ? "nan\r" : n % 3 == 1 ? "CH1 -1.000 V\r" : "1e30\r"); });
  });
  Bench bench;
  bench.set("dialect", 2);
  ASSERT_TRUE(start(bench)) << said(bench);
  int good = 0;
  for (const double until = now_s() + 60; good < 20 && now_s() < until;) {
    ask(bench, 3e-3);
    EXPECT_TRUE(!closed(bench) || std::abs(bench.sample.closure - 0.6) < 1e-6) << bench.sample.closure;
    good += closed(bench);
  }
  EXPECT_EQ(good, 20);
  stop = true;
  reader.join();
}

TEST_F(Driver, APulledPlugIsSilenceAndTheSensorIsFoundAgain) {
  // a hand that moves slowly: 1 V/s, 0.2 closures per second
  std::atomic<double> begun{0};
  const auto swing = [](double t) { return 0.5 + 0.5 * std::sin(2 * t); };
  SensorThread sensor(
      options_,
      [&](double t) {
        if (begun == 0) begun = now_s() - t;
        return SimulatedSensor::Measured{swing(t), 0, 0};
      },
      folder_ / "port");
  Bench bench;
  ASSERT_TRUE(start(bench));
  std::mt19937 random(5);
  std::uniform_real_distribution<double> moment(0.002, 0.12);
  ask_for(bench, 20);
  double most_off = 0;
  for (int round = 0; round < 100; ++round) {
    ask(bench, moment(random));
    sensor.unplug();
    ask(bench, 2e-3);  // what was on its way still comes
    const swage_sample held = bench.sample;
    EXPECT_EQ(ask(bench, moment(random)), 0);
    EXPECT_EQ(bench.sample.closure, held.closure);
    sensor.plug();
    const double until = now_s() + 60;
    for (uint64_t last = held.sequence; bench.sample.sequence < held.sequence + 20 && now_s() < until;) {
      ask(bench, 2e-3);
      if (bench.sample.sequence == last || !closed(bench)) continue;
      last = bench.sample.sequence;
      // no value of before, none that was made up: what the hand did when it was measured, 5 ms of low pass later
      EXPECT_TRUE(bench.sample.closure > 0.199 && bench.sample.closure < 0.401) << bench.sample.closure;
      most_off = std::max(most_off, std::abs(bench.sample.closure - 0.2 * (2 - swing(bench.sample.time_s - begun))));
    }
    ASSERT_LT(now_s(), until) << "round " << round;
  }
  // a message that waited while the machine was busy is stamped late by that much, until the clock is known again
  EXPECT_LT(most_off, 0.06) << "0.3 s of this hand";
  EXPECT_EQ(said(bench).find(say::kOtherSensor.words(1)), std::string::npos);
}

TEST_F(Driver, AnotherSensorInItsPlaceIsNotBelieved) {
  auto sensor = plug();
  Bench bench;
  ASSERT_TRUE(start(bench));
  ask_for(bench, 5);
  const uint64_t before = bench.sample.sequence;
  sensor->unplug();
  ask(bench, 0.05);
  sensor.reset();
  options_.serial = "SIM2";
  sensor = plug();
  const uint64_t then = bench.sample.sequence;
  EXPECT_GE(then, before);
  EXPECT_EQ(ask(bench, 1.0), 0);
  EXPECT_THAT(said(bench), HasSubstr(say::kOtherSensor("SIM2", "SIM1")));
  EXPECT_EQ(std::count_if(bench.host.reports.begin(), bench.host.reports.end(),
                          [](const std::string& r) { return r.find(say::kOtherSensor.words(1)) != std::string::npos; }),
            1)
      << "told once";
}

TEST_F(Driver, SilenceGivesNoSampleAndARestartNoLeapInTime) {
  auto sensor = plug();
  Bench bench;
  ASSERT_TRUE(start(bench));
  ask_for(bench, 5);
  sensor->with([](SimulatedSensor& s) { s.silent(true); });
  ask(bench, 50e-3);
  EXPECT_EQ(ask(bench, 0.2), 0);
  sensor->with([](SimulatedSensor& s) { s.silent(false); });
  ask_for(bench, 20);
  sensor->with([](SimulatedSensor& s) { s.restart(); });
  ask_for(bench, 20);
  EXPECT_TRUE(closed(bench));
}

TEST_F(Driver, OpensAndClosesAHundredTimes) {
  auto sensor = plug();
  Bench bench;
  ASSERT_TRUE(start(bench));
  const auto* table = bench.get<swage_device>(SWAGE_EXT_DEVICE);
  for (int i = 0; i < 100; ++i) {
    bench.host.role = SWAGE_THREAD_MAIN;
    table->close(bench.raw);
    ASSERT_GE(table->open(bench.raw), 0);
    bench.host.role = SWAGE_THREAD_IO;
    ask(bench, 4e-3);
  }
  ask_for(bench, 10);
}

}  // namespace
}  // namespace swage::jaw_sensor
