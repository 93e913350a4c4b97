// SPDX-License-Identifier: Apache-2.0
//
// The thesis' instrument without its hardware: the pose from a game pad, the jaws from a displacement sensor, both on threads of their
// own, in real time. Somebody who sees where the tool is moves the sticks and squeezes the handle.
#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <nlohmann/json.hpp>
#include <random>

#include "jaw_sensor/sentences.hpp"
#include "live_lesson.hpp"
#include "record/export.hpp"
#include "sensor/calibration_file.hpp"
#include "sensor_thread.hpp"
#include "toolkit/math.hpp"
#include "virtual_pad.hpp"

namespace swage::session {
namespace {

using sensor::SimulatedSensor;
using test::nap;
using test::SensorThread;
using test::VirtualPad;
using toolkit::Vec3;

constexpr double kMove = 20e-3;  // m/s of the pad at its end

// what the expert of 020 does, without its turning: it never turns
struct Key {
  double t;     // s
  Vec3 p_W;     // m
  double wish;  // closure
};
const Key kKeys[] = {{0, {6e-3, 0, 3.4e-3}, 0.15},       {0.5, {6e-3, 0, 3.4e-3}, 0.15},    {2, {2.5e-3, 0, 2.392e-3}, 0.15},
                     {3.5, {-1e-3, 0, 2.392e-3}, 0.15},  {4.3, {-1e-3, 0, 2.392e-3}, 0.57}, {5.3, {-1e-3, 0, 2.392e-3}, 0.687},
                     {5.6, {-1e-3, 0, 2.392e-3}, 0.687}, {7.6, {-1e-3, 0, 5.4e-3}, 0.687},  {1e9, {-1e-3, 0, 5.4e-3}, 0.687}};

Key wanted(double t) {
  std::size_t i = 0;
  while (kKeys[i + 1].t <= t) ++i;
  const double share = (t - kKeys[i].t) / (kKeys[i + 1].t - kKeys[i].t);
  return {t, kKeys[i].p_W + share * (kKeys[i + 1].p_W - kKeys[i].p_W), kKeys[i].wish + share * (kKeys[i + 1].wish - kKeys[i].wish)};
}

// of an uncalibrated sensor: 2 V open, -1 V just closed at 0.6, -2 V squeezed
double volts_for(double closure) { return closure < 0.6 ? 2 - 3 * closure / 0.6 : -1 - (closure - 0.6) / 0.4; }

// the axis that gives this speed
double stick_for(double v) {
  const double share = std::min(std::abs(v) / kMove, 1.0);
  return share < 1e-4 ? 0 : std::copysign(0.1 + 0.9 * std::sqrt(share), v);
}

class JawAndPad : public test::LiveLesson {
 protected:
  void SetUp() override {
    ASSERT_TRUE(VirtualPad::possible()) << "the package libsdl2-2.0-0 is missing";
    pad_ = std::make_unique<VirtualPad>();
    SimulatedSensor::Options options;
    options.faults = {0.003, 0, 50, 70};  // a poor clock, a wrong bit now and then
    sensor_ = std::make_unique<SensorThread>(
        options, [this](double) { return SimulatedSensor::Measured{volts_, 0, 0}; }, folder_ / "port");
    // device frame: x right, y up, z towards the user; in the world the user sits at -y
    auto devices = test::Json::parse(R"([
      { "name": "arm", "plugin": "swage.device.gamepad", "pose": { "rpy": ["90 deg", "0 deg", "0 deg"] },
        "params": { "start": ["6 mm", "3.4 mm", "0 mm"], "start_axis": [-1, 0, 0], "start_closing": [0, 0.7730, 0.6344] } },
      { "name": "handle", "plugin": "swage.device.jaw_sensor", "params": { "port": "" } } ])");
    devices[1]["params"]["port"] = sensor_->port();
    write_lesson(devices, "arm", "handle");
  }

  /// The person looks at the tool and moves the sticks; once. False before the first snapshot.
  bool lead(const Session& session, snapshot::Snapshot& now) {
    if (!session.latest(now)) return false;
    const Vec3 p_W = toolkit::vec(now.X_WB[0].p);
    const Key then = wanted(std::min(now.time_s, last_key_)), soon = wanted(std::min(now.time_s + 0.05, last_key_));
    const Vec3 v = (soon.p_W - then.p_W) / 0.05 + 5 * (then.p_W - p_W);
    pad_->axis(gamepad::kLeftX, stick_for(v.x()));
    pad_->axis(gamepad::kLeftY, -stick_for(v.z()));
    volts_ = volts_for(then.wish);
    return true;
  }

  std::atomic<double> volts_{2};
  std::unique_ptr<VirtualPad> pad_;
  std::unique_ptr<SensorThread> sensor_;
  double last_key_ = 1e8;  // s, after which the person stays
};

TEST_F(JawAndPad, PlayTheBasicGraspToAPassInRealTime) {
  auto session = open();
  ASSERT_NE(session, nullptr);
  EXPECT_NE(told_.find(jaw_sensor::say::kNotCalibrated("SIM1")), std::string::npos) << told_;
  session->start();
  snapshot::Snapshot now;
  for (; !session->finished(); nap(5e-3)) lead(*session, now);
  session->wait();
  const Result result = session->result();
  EXPECT_EQ(result.outcome, judge::Outcome::kPassed) << result.reason << " after " << result.simulated_s << " s";
  expect_kept(result, 5000);
  std::printf("score %g after %.1f s, speed %.2f\n", result.score, result.simulated_s, result.speed);
}

// The calibration that the sensor found by its serial number, and how the scene was seen, stay with the attempt.
TEST_F(JawAndPad, TheCalibrationInUseAndTheDisplayAreKept) {
  sensor::Calibration c;
  c.serial = "SIM1", c.date = "2026-11-01", c.by = "Ada", c.expires = "2099-01-01";
  c.displacement.slope = 1e-3, c.displacement.worst = 27e-6;
  c.poses = {2e-3, -1e-3, -2e-3};
  ASSERT_EQ(sensor::save_calibration(sensor::calibration_path("SIM1"), c), "");
  options_.display = {"side", true, true, "", 0};
  auto session = open();
  ASSERT_NE(session, nullptr);
  session->start();
  snapshot::Snapshot now;
  for (; now.step < 300 && !session->finished(); nap(5e-3)) lead(*session, now);
  session->stop();
  const std::string id = session->result().attempt_id;
  std::vector<record::Exported> kept;
  std::string error;
  ASSERT_TRUE(record::read_for_export(options_.store_path, {"", "", id}, kept, error)) << error;
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].display, "side, eyes swapped");
  const nlohmann::json used = nlohmann::json::parse(kept[0].calibration);
  ASSERT_EQ(used.size(), 1u) << kept[0].calibration;
  EXPECT_EQ(used[0]["file"], "swage:calibration:handle");
  EXPECT_EQ(used[0]["serial"], "SIM1");
  EXPECT_EQ(used[0]["date"], "2026-11-01");
  EXPECT_EQ(used[0]["residual"], 27e-6);
}

// The raw volts are recorded beside the scene's signals and shown; a pad that SDL makes up has no battery. A replay repeats without them.
TEST_F(JawAndPad, WhatDevicesTellOfThemselvesIsShownAndKept) {
  last_key_ = 0;  // the handle rests
  auto session = open();
  ASSERT_NE(session, nullptr);
  const auto& names = session->card().script.signals;
  ASSERT_GE(names.size(), 2u);
  const std::size_t battery = names.size() - 2, volts = names.size() - 1;  // in the order of the devices, after the scene's
  EXPECT_EQ(names[battery].owner + " " + names[battery].id, "arm pad.battery");
  EXPECT_EQ(names[volts].owner + " " + names[volts].id + " " + names[volts].unit, "handle sensor.volts V");
  session->start();
  snapshot::Snapshot now;
  for (; now.step < 300 && !session->finished(); nap(5e-3)) lead(*session, now);
  ASSERT_EQ(now.n_signal, names.size());
  EXPECT_NEAR(now.signal[volts], volts_for(wanted(0).wish), 0.05) << "V";
  EXPECT_TRUE(std::isnan(now.signal[battery]));
  sensor_->unplug();
  for (; std::isfinite(now.signal[volts]) && now.step < 5000; nap(5e-3)) session->latest(now);
  EXPECT_TRUE(std::isnan(now.signal[volts])) << "a sensor that is away has no voltage";
  session->stop();
  record::Recording kept;
  expect_kept(session->result(), 200, &kept);
  const std::vector<double> told = test::kept_signal(kept, "sensor.volts");
  ASSERT_GT(told.size(), 250u);
  EXPECT_NEAR(told[250], volts_for(wanted(0).wish), 0.05);
}

TEST_F(JawAndPad, AHundredPulledPlugsLeaveNoLeapOfToolOrForce) {
  last_key_ = 5.5;  // holds the needle with 0.6 N and never lifts it, so that the lesson does not end
  auto session = open();
  ASSERT_NE(session, nullptr);
  session->start();
  std::mt19937 random(15);
  std::uniform_real_distribution<double> moment(0.02, 0.15), away(0.01, 0.3);
  snapshot::Snapshot now;
  std::vector<test::ToolLook> looks;
  std::vector<test::LedPoint> pressed = {{}};  // open before anybody presses
  const auto watch = [&](double seconds, bool pad_there) {
    for (const double until = sensor::now_s() + seconds; sensor::now_s() < until && !session->finished(); nap(2e-3)) {
      if (pad_there ? !lead(*session, now) : !session->latest(now)) continue;
      looks.push_back({now.step, sensor::now_s(), now.X_WB[0].p});
      if (pad_there) pressed.push_back({looks.back().wall_s, 0, wanted(std::min(now.time_s, last_key_)).wish});
    }
  };
  watch(1, true);
  int pulled = 0;
  for (; pulled < 100 && !session->finished(); ++pulled) {
    watch(moment(random), true);
    const bool pad = random() % 2 == 0;
    if (pad)
      pad_->unplug();
    else
      sensor_->unplug();
    watch(away(random), !pad);
    if (pad)
      pad_->plug();
    else
      sensor_->plug();
  }
  EXPECT_EQ(pulled, 100);
  EXPECT_EQ(session->finished(), false);
  session->stop();
  session->wait();
  const Result result = session->result();
  EXPECT_EQ(result.outcome, judge::Outcome::kAborted) << result.reason;
  record::Recording kept;
  expect_kept(result, 5000, &kept);
  ASSERT_FALSE(kept.step.empty());
  ASSERT_EQ(kept.step.back() - kept.step.front() + 1, kept.step.size()) << "a step was not recorded";
  const test::HeardHand pose = test::heard_hand(kept, 0), closure = test::heard_hand(kept, 1);
  const double tool = test::tool_leap(pose, looks), force = test::grip_leap(closure, test::kept_signal(kept, "grip.command"), test::kGripGain);
  std::printf("tool beyond its samples %.4f mm, grip beyond its samples %.3f N, %.1f s simulated\n", 1e3 * tool, force, now.time_s);
  EXPECT_LT(tool, 1e-6) << "m: the tool goes only where its samples lead";
  EXPECT_LT(force, 0.05) << "N: jaws that spring open or shut make more than 1";
  EXPECT_EQ(test::faster_than_led(pose, kMove * std::sqrt(2.0)), 0) << "samples further than two axes go";
  EXPECT_EQ(test::beside_the_way(closure, SWAGE_VALID_CLOSURE, pressed, looks, 0.02, [](const swage_sample& s) { return s.closure; },
                                 [](const test::LedPoint& p) { return p.closure; }),
            0)
      << "samples that the person did not press";
}

}  // namespace
}  // namespace swage::session
