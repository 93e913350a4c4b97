// SPDX-License-Identifier: Apache-2.0
//
// The thesis' instrument without its hardware: the pose from a game pad, the jaws from a displacement sensor, both on threads of their
// own, in real time. Somebody who sees where the tool is moves the sticks and squeezes the handle.
#include <gtest/gtest.h>
#include <stdlib.h>

#include <atomic>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>

#include "record/export.hpp"
#include "record/recorder.hpp"
#include "sensor/calibration_file.hpp"
#include "sensor_thread.hpp"
#include "session/session.hpp"
#include "temp_folder.hpp"
#include "test_places.hpp"
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

class JawAndPad : public testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(VirtualPad::possible()) << "the package libsdl2-2.0-0 is missing";
    for (const char* place : {"XDG_STATE_HOME", "XDG_DATA_HOME"}) setenv(place, folder_.path().c_str(), 1);
    unsetenv("SWAGE_PLUGIN_PATH");
    pad_ = std::make_unique<VirtualPad>();
    SimulatedSensor::Options options;
    options.faults = {0.003, 0, 50, 70};  // a poor clock, a wrong bit now and then
    sensor_ = std::make_unique<SensorThread>(
        options, [this](double) { return SimulatedSensor::Measured{volts_, 0, 0}; }, folder_ / "port");
    write_lesson();
    options_.lesson_path = folder_ / "grasp.json";
    options_.plugin_dirs = {SWAGE_BINARY_DIR "/plugins"};
    options_.store_path = folder_ / "attempts.db";
    options_.person = "Ada";
  }

  // lesson 020 with another instrument: two devices lead one needleholder
  void write_lesson() {
    auto lesson = nlohmann::ordered_json::parse(std::ifstream(SWAGE_SOURCE_DIR "/lessons/series/020_grasp_basic.json"));
    lesson["requires"].erase("swage.device.mouse");
    lesson["requires"].erase("swage.device.scripted");
    lesson["requires"]["swage.device.gamepad"] = lesson["requires"]["swage.device.jaw_sensor"] = "^1";
    // device frame: x right, y up, z towards the user; in the world the user sits at -y
    lesson["devices"] = nlohmann::ordered_json::parse(R"([
      { "name": "arm", "plugin": "swage.device.gamepad", "pose": { "rpy": ["90 deg", "0 deg", "0 deg"] },
        "params": { "start": ["6 mm", "3.4 mm", "0 mm"], "start_axis": [-1, 0, 0], "start_closing": [0, 0.7730, 0.6344] } },
      { "name": "handle", "plugin": "swage.device.jaw_sensor", "params": { "port": "" } } ])");
    lesson["devices"][1]["params"]["port"] = sensor_->port();
    lesson["objects"][0]["follows"] = {{"pose", "arm"}, {"closure", "handle"}};
    std::ofstream(folder_ / "grasp.json") << lesson.dump(2);
  }

  std::unique_ptr<Session> open() {
    Problems problems;
    auto session = Session::open(options_, problems);
    std::string told;
    for (const Problem& p : problems) told += p.where + ": " + p.message + "\n";
    EXPECT_NE(session, nullptr) << told;
    told_ = told;
    return session;
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

  /// The samples that the step saw are kept: without any device the same bits come again.
  void expect_replay(const std::string& attempt) {
    record::Recording recording;
    std::string error;
    ASSERT_TRUE(record::read_recording(options_.store_path, attempt, recording, error)) << error;
    Replay again;
    Problems problems;
    ASSERT_TRUE(replay(recording, options_.plugin_dirs, again, problems));
    EXPECT_TRUE(again.identical) << again.reason << " step " << again.first_difference << " of " << again.steps;
    EXPECT_GT(again.steps, 5000u);
  }

  test::TempFolder folder_;
  std::atomic<double> volts_{2};
  std::unique_ptr<VirtualPad> pad_;
  std::unique_ptr<SensorThread> sensor_;
  Options options_;
  std::string told_;
  double last_key_ = 1e8;  // s, after which the person stays
};

TEST_F(JawAndPad, PlayTheBasicGraspToAPassInRealTime) {
  auto session = open();
  ASSERT_NE(session, nullptr);
  EXPECT_NE(told_.find("SIM1: not calibrated"), std::string::npos) << told_;
  session->start();
  snapshot::Snapshot now;
  for (; !session->finished(); nap(5e-3)) lead(*session, now);
  session->wait();
  const Result result = session->result();
  EXPECT_EQ(result.outcome, judge::Outcome::kPassed) << result.reason << " after " << result.simulated_s << " s";
  EXPECT_FALSE(result.attempt_id.empty());
  EXPECT_EQ(result.health.quarantined, 0u);
  expect_replay(result.attempt_id);
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

TEST_F(JawAndPad, AHundredPulledPlugsLeaveNoLeapOfToolOrForce) {
  last_key_ = 5.5;  // holds the needle with 0.6 N and never lifts it, so that the lesson does not end
  auto session = open();
  ASSERT_NE(session, nullptr);
  session->start();
  std::mt19937 random(15);
  std::uniform_real_distribution<double> moment(0.02, 0.15), away(0.01, 0.3);
  snapshot::Snapshot now, last;
  double most_speed = 0, most_force = 0;
  bool seen = false;
  const auto watch = [&](double seconds, bool pad_there) {
    for (const double until = sensor::now_s() + seconds; sensor::now_s() < until && !session->finished(); nap(2e-3)) {
      if (pad_there ? !lead(*session, now) : !session->latest(now)) continue;
      const double dt = now.time_s - last.time_s;
      // after a step that came late the scene catches up, and then its time goes faster than the hand's
      if (seen && dt > 0 && now.health.late == last.health.late) {
        most_speed = std::max(most_speed, (toolkit::vec(now.X_WB[0].p) - toolkit::vec(last.X_WB[0].p)).norm() / std::max(dt, 5e-3));
        for (uint32_t i = 0; i < now.n_signal; ++i)
          if (session->card().script.signals[i].id == "grip.command")
            most_force = std::max(most_force, std::abs(now.signal[i] - last.signal[i]) / std::max(dt, 20e-3));
      }
      seen = true;
      last = now;
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
  std::printf("tool up to %.1f mm/s, force up to %.2f N/s, %.1f s simulated\n", 1e3 * most_speed, most_force, now.time_s);
  EXPECT_LT(most_speed, 2 * kMove * std::sqrt(2.0)) << "the tool goes no faster than the pad leads it; two axes, and some scatter of the clocks";
  EXPECT_LT(most_force, 8) << "N/s: the person squeezes with 2 N/s and is met within 0.02 of the closure, 0.1 N; jaws that sprang open or shut make 30";
  EXPECT_EQ(session->finished(), false);
  session->stop();
  session->wait();
  const Result result = session->result();
  EXPECT_EQ(result.outcome, judge::Outcome::kAborted) << result.reason;
  EXPECT_EQ(result.health.quarantined, 0u);
  EXPECT_FALSE(result.attempt_id.empty()) << "the attempt is kept";
  expect_replay(result.attempt_id);
}

}  // namespace
}  // namespace swage::session
