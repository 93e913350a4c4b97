// SPDX-License-Identifier: Apache-2.0
//
// Lesson 020 in real time with drivers against their fakes, in a home of its own; and what is watched while plugs are pulled.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "record/recorder.hpp"
#include "session/session.hpp"
#include "temp_folder.hpp"
#include "test_places.hpp"
#include "toolkit/math.hpp"

namespace swage::test {

using Json = nlohmann::ordered_json;

/// Highest speed of the tool and fastest change of the grip's force between two looks; and the longest way of the tool beyond what a
/// hand that is as fast as `top` [m/s] goes meanwhile, twice over, as the clocks scatter.
class LeapWatch {
 public:
  explicit LeapWatch(double top = 0) : top_(top) {}
  void look(const session::Session& session, const snapshot::Snapshot& now) {
    const double dt = now.time_s - last_->time_s;
    // a scene that lost steps follows a hand that moved meanwhile
    if (now.health.dropped != last_->health.dropped) behind_until_ = now.time_s + kBehind;
    // after a step that came late the scene catches up, and then its time goes faster than the hand's
    if (seen_ && dt > 0 && now.health.late == last_->health.late && now.time_s > behind_until_) {
      const double way = (toolkit::vec(now.X_WB[0].p) - toolkit::vec(last_->X_WB[0].p)).norm();
      speed_ = std::max(speed_, way / std::max(dt, 5e-3));
      leap_ = std::max(leap_, way - 2 * top_ * dt);
      for (uint32_t i = 0; i < now.n_signal; ++i)
        if (session.card().script.signals[i].id == "grip.command")
          force_ = std::max(force_, std::abs(now.signal[i] - last_->signal[i]) / std::max(dt, 20e-3));
    }
    seen_ = true;
    *last_ = now;
  }
  double speed() const { return speed_; }  // m/s
  double force() const { return force_; }  // N/s
  double leap() const { return leap_; }    // m

 private:
  std::unique_ptr<snapshot::Snapshot> last_ = std::make_unique<snapshot::Snapshot>();
  static constexpr double kBehind = 0.1;  // s, as long as a hand may be silent and is caught up with (step/hands.cpp)
  bool seen_ = false;
  double behind_until_ = 0;
  double top_, speed_ = 0, force_ = 0, leap_ = 0;
};

class LiveLesson : public testing::Test {
 protected:
  LiveLesson() {
    for (const char* place : {"XDG_STATE_HOME", "XDG_DATA_HOME"}) setenv(place, folder_.path().c_str(), 1);
    unsetenv("SWAGE_PLUGIN_PATH");
    options_.lesson_path = folder_ / "grasp.json";
    options_.plugin_dirs = {SWAGE_BINARY_DIR "/plugins"};
    options_.store_path = folder_ / "attempts.db";
    options_.person = "Ada";
  }

  /// Lesson 020 with other instruments: `pose` leads the needleholder, `closure` its jaws.
  void write_lesson(const Json& devices, const std::string& pose, const std::string& closure) {
    auto lesson = Json::parse(std::ifstream(SWAGE_SOURCE_DIR "/lessons/series/020_grasp_basic.json"));
    lesson["requires"].erase("swage.device.mouse");
    lesson["requires"].erase("swage.device.scripted");
    for (const Json& device : devices) lesson["requires"][device["plugin"].get<std::string>()] = "^1";
    lesson["devices"] = devices;
    lesson["objects"][0]["follows"] = {{"pose", pose}, {"closure", closure}};
    std::ofstream(folder_ / "grasp.json") << lesson.dump(2);
  }

  std::unique_ptr<session::Session> open() {
    session::Problems problems;
    auto session = session::Session::open(options_, problems);
    told_.clear();
    for (const session::Problem& p : problems) told_ += p.where + ": " + p.message + "\n";
    EXPECT_NE(session, nullptr) << told_;
    return session;
  }

  /// The attempt is whole and kept, and the samples that the step saw are: without any device the same bits come again.
  void expect_kept(const session::Result& result, uint64_t least_steps) {
    EXPECT_EQ(result.health.quarantined, 0u);
    ASSERT_FALSE(result.attempt_id.empty()) << "the attempt is kept";
    record::Recording recording;
    std::string error;
    ASSERT_TRUE(record::read_recording(options_.store_path, result.attempt_id, recording, error)) << error;
    session::Replay again;
    session::Problems problems;
    ASSERT_TRUE(session::replay(recording, options_.plugin_dirs, again, problems));
    EXPECT_TRUE(again.identical) << again.reason << " step " << again.first_difference << " of " << again.steps;
    EXPECT_GT(again.steps, least_steps);
  }

  TempFolder folder_;
  session::Options options_;
  std::string told_;
};

}  // namespace swage::test
