// SPDX-License-Identifier: Apache-2.0
//
// Lesson 020 in real time with drivers against their fakes, in a home of its own; and what was kept of it.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "lost_hand_law.hpp"
#include "record/recorder.hpp"
#include "session/session.hpp"
#include "temp_folder.hpp"
#include "test_places.hpp"

namespace swage::test {

using Json = nlohmann::ordered_json;

// N per unit of closure of the jaws in 020: from open to squeezed, 15 deg, at the 2 N that 6 deg of them are worth (plugins/jaws/jaw_shape.hpp)
constexpr double kGripGain = 5;

/// What the step heard of one device. `scale`: hand over tool.
inline HeardHand heard_hand(const record::Recording& kept, std::size_t device, double scale = 1) {
  HeardHand out{kept.step.front(), kept.info.dt, scale, {}};
  for (std::size_t i = device; i < kept.sample.size(); i += kept.info.devices.size()) out.sample.push_back(kept.sample[i]);
  return out;
}

/// One signal, at every step; empty without it.
inline std::vector<double> kept_signal(const record::Recording& kept, const std::string& id) {
  const auto& signals = kept.info.script.signals;
  std::vector<double> out;
  for (std::size_t k = 0; k < signals.size(); ++k)
    if (signals[k].id == id)
      for (std::size_t i = k; i < kept.signal.size(); i += signals.size()) out.push_back(kept.signal[i]);
  return out;
}

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
  void expect_kept(const session::Result& result, uint64_t least_steps, record::Recording* kept = nullptr) {
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
    if (kept != nullptr) *kept = std::move(recording);
  }

  TempFolder folder_;
  session::Options options_;
  std::string told_;
};

}  // namespace swage::test
