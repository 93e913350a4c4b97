// SPDX-License-Identifier: Apache-2.0
//
// Whole attempts with the stock plugins: threads, record, replay.
#include "session/session.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>
#include <thread>

#include "record/recorder.hpp"
#include "record/store.hpp"
#include "session/playback.hpp"

namespace swage::session {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

const std::string kGrasp = SWAGE_SOURCE_DIR "/lessons/series/020_grasp_basic.json";

// waits for a condition, not for a time: CTest's limit ends what never comes
template <class F>
void until(F done) {
  while (!done()) std::this_thread::sleep_for(1ms);
}

std::string told(const Problems& problems) {
  std::string out;
  for (const Problem& p : problems) out += p.where + ": " + p.message + "\n";
  return out;
}

// everything of a person's home that a session touches lies in a folder of its own
class SessionTest : public ::testing::Test {
 protected:
  SessionTest() {
    char name[] = "/tmp/swage-session-XXXXXX";
    folder = mkdtemp(name);
    setenv("XDG_STATE_HOME", folder.c_str(), 1);
    setenv("XDG_DATA_HOME", folder.c_str(), 1);
    unsetenv("SWAGE_PLUGIN_PATH");
    options.lesson_path = kGrasp;
    options.plugin_dirs = {SWAGE_BINARY_DIR "/plugins"};
    options.device = "expert";
    options.store_path = ":none:";
    options.pace = Pace::kFastest;
  }
  ~SessionTest() override { fs::remove_all(folder); }

  std::unique_ptr<Session> open() {
    Problems problems;
    auto session = Session::open(options, problems);
    EXPECT_NE(session, nullptr) << told(problems);
    return session;
  }
  Result run() {
    auto session = open();
    if (!session) return {};
    session->start();
    session->wait();
    return session->result();
  }
  record::Recording recording(const std::string& attempt) {
    record::Recording out;
    std::string error;
    EXPECT_TRUE(record::read_recording(options.store_path, attempt, out, error)) << error;
    return out;
  }

  std::string folder;
  Options options;
};

TEST_F(SessionTest, TheExpertPassesHeadless) {
  const Result result = run();
  EXPECT_EQ(result.outcome, judge::Outcome::kPassed) << result.reason << "\n" << told(result.problems);
  EXPECT_GT(result.score, 50);
  EXPECT_GT(result.steps, 1000u);
  EXPECT_DOUBLE_EQ(result.simulated_s, static_cast<double>(result.steps) * 1e-3);
  EXPECT_FALSE(result.metrics.empty());
  EXPECT_EQ(result.attempt_id, "");
  EXPECT_EQ(result.health.executed, result.steps);
  EXPECT_EQ(result.health.dropped, 0u);
}

TEST_F(SessionTest, TheSameAttemptTwiceGivesTheSameBits) {
  options.max_time_s = 3;
  const Result a = run(), b = run();
  EXPECT_EQ(a.steps, 3000u);
  EXPECT_EQ(a.hash, b.hash);
  EXPECT_NE(a.hash, 0u);
  options.device = "novice";
  EXPECT_NE(run().hash, a.hash);
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
  ASSERT_TRUE(replay(attempt, options.plugin_dirs, again, problems));
  EXPECT_FALSE(again.identical);
  EXPECT_EQ(again.first_difference, 1500u);

  // and so is a command that is missing, or is carried out one step late
  attempt.sample[1500].pose.p.y = recording(result.attempt_id).sample[1500].pose.p.y;
  const uint64_t when = attempt.commands[0].step;
  attempt.commands[0].step += 1;
  ASSERT_TRUE(replay(attempt, options.plugin_dirs, again, problems));
  EXPECT_FALSE(again.identical);
  EXPECT_EQ(again.first_difference, when);
  attempt.commands.clear();
  ASSERT_TRUE(replay(attempt, options.plugin_dirs, again, problems));
  EXPECT_FALSE(again.identical);
  EXPECT_EQ(again.first_difference, when);
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

TEST_F(SessionTest, ReplaySaysWhatItCannotDo) {
  options.store_path = folder + "/attempts.db";
  options.max_time_s = 0.1;
  record::Recording attempt = recording(run().attempt_id);
  Replay again;
  Problems problems;
  attempt.step[50] = 60;
  ASSERT_TRUE(replay(attempt, options.plugin_dirs, again, problems));
  EXPECT_FALSE(again.identical);
  EXPECT_EQ(again.reason, "step 50 was not recorded");
  attempt.info.plugins[0].second = "0.0.1";
  attempt.step[50] = 50;
  ASSERT_TRUE(replay(attempt, options.plugin_dirs, again, problems));
  EXPECT_NE(told(problems).find("Recorded with swage.object.jaws 0.0.1"), std::string::npos)
      << told(problems);
  attempt.info.descriptor_text = "{}";
  EXPECT_FALSE(replay(attempt, options.plugin_dirs, again, problems));
}

TEST_F(SessionTest, StopsWhenToldAndSaysSo) {
  options.device = "mouse";
  auto session = open();
  session->start();
  snapshot::Snapshot s;
  until([&] { return session->latest(s) && s.step > 100; });
  session->stop();
  EXPECT_TRUE(session->finished());
  const Result result = session->result();
  EXPECT_EQ(result.outcome, judge::Outcome::kAborted);
  EXPECT_EQ(result.reason, "stopped");
  EXPECT_GT(result.steps, 100u);
}

TEST_F(SessionTest, ASessionThatIsLeftAloneEndsInOrder) {
  options.device = "mouse";
  options.store_path = folder + "/attempts.db";
  {
    auto session = open();
    session->start();
    snapshot::Snapshot s;
    until([&] { return session->latest(s) && s.step > 50; });
  }
  { auto never_started = open(); }
  std::string error;
  auto store = record::Store::open(options.store_path, error);
  ASSERT_NE(store, nullptr) << error;
  for (const record::AttemptRow& row : store->attempts("")) EXPECT_NE(row.state, "running");
}

TEST_F(SessionTest, TimeLimitsEndTheAttempt) {
  options.max_time_s = 0.25;
  const Result result = run();
  EXPECT_EQ(result.steps, 250u);
  EXPECT_EQ(result.outcome, judge::Outcome::kAborted);
  EXPECT_EQ(result.reason, "time.limit");
}

TEST_F(SessionTest, ThePointerMovesTheToolThroughTheMouse) {
  options.device = "mouse";
  options.start_paused = true;
  auto session = open();
  session->start();
  snapshot::Snapshot before, after;
  ASSERT_TRUE(session->latest(before));
  swage_pointer p{};
  p.camera = {1, 0, 0, 0};
  p.buttons = 1;
  for (int i = 0; i < 10; ++i) {
    p.dx = 0.01;
    session->pointer(p);
  }
  session->pause(false);
  until([&] { return session->latest(after) && after.step >= 1000; });
  session->stop();
  const double moved =
      std::hypot(after.X_WB[0].p.x - before.X_WB[0].p.x, after.X_WB[0].p.y - before.X_WB[0].p.y);
  EXPECT_NEAR(moved, 0.1 * 10e-3, 1e-5);  // a tenth of the view's height at 10 mm for the whole of it
}

TEST_F(SessionTest, EventsArriveInOrder) {
  auto session = open();
  session->start();
  session->wait();
  judge::Event e{}, last{};
  int count = 0;
  while (session->next_event(e)) {
    EXPECT_GE(e.step, last.step);
    EXPECT_LT(e.event, session->card().script.events.size());
    last = e;
    ++count;
  }
  EXPECT_GT(count, 2);
}

TEST_F(SessionTest, WrongLessonsAreToldNotRun) {
  Problems problems;
  options.lesson_path = folder + "/none.json";
  EXPECT_EQ(Session::open(options, problems), nullptr);
  EXPECT_TRUE(base::failed(problems));
  problems.clear();
  options.lesson_path = kGrasp;
  options.device = "no_such_hand";
  EXPECT_EQ(Session::open(options, problems), nullptr);
  EXPECT_NE(told(problems).find("no_such_hand"), std::string::npos);
}

TEST_F(SessionTest, LiveChangesAreCheckedAndRecorded) {
  auto session = open();
  Problems problems;
  EXPECT_FALSE(session->change("nobody", "{}", problems));
  EXPECT_FALSE(session->change("needle", R"({"arc": "1/2"})", problems));
  EXPECT_NE(told(problems).find("cannot change while the scene runs"), std::string::npos) << told(problems);
}

// the real clock: steps pass like time passes, whatever the machine drops is told
TEST_F(SessionTest, RunsAtTheRateOfTheClock) {
  options.pace = Pace::kRealtime;
  options.max_time_s = 0.5;
  auto session = open();
  const auto start = std::chrono::steady_clock::now();
  session->start();
  session->wait();
  const double took = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const Result result = session->result();
  EXPECT_EQ(result.steps, 500u);
  EXPECT_GE(took, 0.499);  // how much longer is the machine's affair
  EXPECT_EQ(result.health.executed, 500u);
  EXPECT_GT(result.health.worst_step_s, 0);
  EXPECT_NE(told(result.problems).find("loop: "), std::string::npos);
  snapshot::Snapshot s;
  ASSERT_TRUE(session->latest(s));
  EXPECT_EQ(s.step, 500u);
}

TEST_F(SessionTest, PausedTimeStandsStill) {
  options.pace = Pace::kRealtime;
  options.device = "mouse";
  options.start_paused = true;
  auto session = open();
  session->start();
  // a snapshot that the loop itself has made while paused: it ticks and does not step
  snapshot::Snapshot s;
  until([&] { return session->latest(s) && s.paused == 1; });
  EXPECT_EQ(s.step, 0u);
  session->pause(false);
  until([&] { return session->latest(s) && s.step > 0; });
  EXPECT_GT(s.step, 0u);
  EXPECT_EQ(s.paused, 0u);
  session->stop();
}

}  // namespace
}  // namespace swage::session
