// SPDX-License-Identifier: Apache-2.0
//
// Recorded attempts again: bit for bit, to any step, in another place.
#include <swage/display.hpp>

#include <algorithm>

#include "host/sentences.hpp"
#include "host/services.hpp"
#include "session/playback.hpp"
#include "session/sentences.hpp"
#include "session_bed.hpp"
#include "test_places.hpp"

namespace swage::session {
namespace {

// Where the replay of an attempt leaves it; UINT64_MAX when it does not.
uint64_t differs_at(const record::Recording& attempt, const std::vector<std::string>& plugin_dirs) {
  Replay again;
  Problems problems;
  EXPECT_TRUE(replay(attempt, plugin_dirs, again, problems)) << told(problems);
  return again.identical ? UINT64_MAX : again.first_difference;
}

TEST_F(SessionTest, ARecordedAttemptReplaysBitForBit) {
  options.store_path = folder + "/attempts.db";
  options.device = "mouse";  // nobody moves it: the attempt lasts until it is stopped
  auto session = open();
  session->start();
  const auto step = [&] {
    snapshot::Snapshot s;
    return session->latest(s) ? s.step : 0;
  };
  until([&] { return step() >= 1000; });
  session->reset_object("needle");
  session->mark("look here");
  // two snapshots later (64 steps apart when there is no clock) both commands have been carried out
  const uint64_t commanded = step();
  until([&] { return step() >= std::max<uint64_t>(commanded + 128, 2000); });
  session->stop();
  const Result result = session->result();
  ASSERT_NE(result.attempt_id, "") << told(result.problems);

  record::Recording attempt = recording(result.attempt_id);
  EXPECT_EQ(attempt.step.size(), result.steps);
  EXPECT_EQ(attempt.commands.size(), 2u);
  EXPECT_EQ(attempt.hash.back(), result.hash);
  Replay again;
  Problems problems;
  ASSERT_TRUE(replay(attempt, options.plugin_dirs, again, problems)) << told(problems);
  EXPECT_TRUE(again.identical) << again.first_difference << " " << again.reason;
  EXPECT_EQ(again.steps, result.steps);
  EXPECT_EQ(told(problems), "");

  // a nanometre in one sample is found at that very step
  attempt.sample[1500].pose.p.y += 1e-9;
  EXPECT_EQ(differs_at(attempt, options.plugin_dirs), 1500u);

  // and so is a command that is missing, or is carried out one step late
  attempt.sample[1500].pose.p.y = recording(result.attempt_id).sample[1500].pose.p.y;
  const uint64_t when = attempt.commands[0].step;
  attempt.commands[0].step += 1;
  EXPECT_EQ(differs_at(attempt, options.plugin_dirs), when);
  attempt.commands.clear();
  EXPECT_EQ(differs_at(attempt, options.plugin_dirs), when);
}

// winding to any step, forwards or backwards, gives the state that was recorded there
TEST_F(SessionTest, ARecordedAttemptCanBeWoundToAnyStep) {
  options.store_path = folder + "/attempts.db";
  options.max_time_s = 2.5;
  const Result result = run();
  const record::Recording attempt = recording(result.attempt_id);
  Problems problems;
  const auto playback = Playback::open(attempt, options.plugin_dirs, problems);
  ASSERT_NE(playback, nullptr) << told(problems);
  EXPECT_EQ(playback->count(), result.steps);
  EXPECT_EQ(playback->card().objects.size(), open()->card().objects.size());
  for (const uint64_t target : {0u, 1u, 700u, 2400u, 1000u, 999u, 3u, 2499u, 0u, 1501u}) {
    // in small portions, as a window does
    int portions = 0;
    while (!playback->toward(target, 250)) ++portions;
    EXPECT_LE(portions, 11) << target;
    ASSERT_EQ(playback->at(), target);
    if (target == 0) continue;
    EXPECT_EQ(playback->engine().hash(), attempt.hash[target - 1]) << target;
    snapshot::Snapshot shown;
    playback->fill(shown);
    EXPECT_EQ(shown.step, target);
  }
  EXPECT_EQ(playback->first_difference(), playback->count());
  // beyond the end is the end
  while (!playback->toward(1'000'000, 1000)) {
  }
  EXPECT_EQ(playback->at(), result.steps);
  EXPECT_FALSE(playback->step());
}

TEST_F(SessionTest, APlaybackKnowsWhereItLeavesTheAttempt) {
  options.store_path = folder + "/attempts.db";
  options.max_time_s = 1;
  record::Recording attempt = recording(run().attempt_id);
  attempt.sample[600].pose.p.y += 1e-9;
  attempt.step[900] = 950;  // 50 steps were not recorded
  Problems problems;
  const auto playback = Playback::open(attempt, options.plugin_dirs, problems);
  ASSERT_NE(playback, nullptr) << told(problems);
  EXPECT_EQ(playback->count(), 900u);
  playback->toward(900, 900);
  EXPECT_EQ(playback->first_difference(), 600u);
}

// The lesson and its hand on file are gone: the attempt carries what its replay needs.
TEST_F(SessionTest, AReplayNeedsNoFileBesideIt) {
  fs::create_directories(folder + "/school/series");
  fs::create_directories(folder + "/school/hands");
  fs::copy(kGrasp, folder + "/school/series");
  fs::copy(SWAGE_SOURCE_DIR "/lessons/hands/020_expert.json", folder + "/school/hands");
  options.lesson_path = folder + "/school/series/020_grasp_basic.json";
  options.store_path = folder + "/attempts.db";
  options.max_time_s = 3;
  record::Recording attempt = recording(run().attempt_id);
  ASSERT_EQ(attempt.info.hands.size(), 1u);
  EXPECT_EQ(attempt.info.hands[0].choice, "expert");
  EXPECT_NE(attempt.info.hands[0].params.find("020_expert.json"), std::string::npos);
  ASSERT_EQ(attempt.info.files.size(), 1u);
  EXPECT_EQ(attempt.info.files[0].name, "../hands/020_expert.json");

  fs::remove_all(folder + "/school");
  Replay again;
  Problems problems;
  ASSERT_TRUE(replay(attempt, options.plugin_dirs, again, problems)) << told(problems);
  EXPECT_TRUE(again.identical) << again.first_difference << " " << again.reason;
  EXPECT_EQ(again.steps, 3000u);
  EXPECT_EQ(told(problems), "");

  // who does not say what the hand was, as format 1, has the device made: with the file that is carried, or not at all
  attempt.info.hands.clear();
  ASSERT_TRUE(replay(attempt, options.plugin_dirs, again, problems)) << told(problems);
  EXPECT_TRUE(again.identical);
  attempt.info.files.clear();
  EXPECT_FALSE(replay(attempt, options.plugin_dirs, again, problems));
  EXPECT_NE(told(problems).find(host::say::kNoFile.words(1) + folder + "/school/hands/020_expert.json"),
            std::string::npos)
      << told(problems);
}

// A lesson that asks how many eyes see the scene is told the same in a replay.
TEST_F(SessionTest, TheDisplayIsKeptAndTheReplayHasIt) {
  options.store_path = folder + "/attempts.db";
  options.max_time_s = 0.05;
  options.display = {"side", true, true, "up_down", 1};
  const record::Recording attempt = recording(run().attempt_id);
  EXPECT_EQ(attempt.info.display, options.display);
  Problems problems;
  const auto eyes_in = [&](const record::Recording& r) {
    const auto again = Playback::open(r, options.plugin_dirs, problems);
    EXPECT_NE(again, nullptr) << told(problems);
    return again ? eyes(*again->rig().lesson.instance->services->abi()) : -1;
  };
  EXPECT_EQ(eyes_in(attempt), SWAGE_EYES_STEREO);
  options.display = {"mono"};
  EXPECT_EQ(eyes_in(recording(run().attempt_id)), SWAGE_EYES_MONO);
  options.display = {};
  EXPECT_EQ(eyes_in(recording(run().attempt_id)), SWAGE_EYES_NONE) << "nobody looked";
}

TEST_F(SessionTest, ReplaySaysWhatItCannotDo) {
  options.store_path = folder + "/attempts.db";
  options.max_time_s = 0.1;
  record::Recording attempt = recording(run().attempt_id);
  Replay again;
  Problems problems;
  attempt.step[50] = 60;
  ASSERT_TRUE(replay(attempt, options.plugin_dirs, again, problems));
  EXPECT_FALSE(again.identical);
  EXPECT_EQ(again.reason, say::kNotRecorded(50));
  attempt.info.plugins[0].second = "0.0.1";
  attempt.step[50] = 50;
  ASSERT_TRUE(replay(attempt, options.plugin_dirs, again, problems));
  EXPECT_NE(told(problems).find(say::kRecordedWith.words(0) + "swage.object.jaws 0.0.1"), std::string::npos)
      << told(problems);
  attempt.info.descriptor_text = "{}";
  EXPECT_FALSE(replay(attempt, options.plugin_dirs, again, problems));
}

}  // namespace
}  // namespace swage::session
