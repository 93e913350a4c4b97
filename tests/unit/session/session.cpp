// SPDX-License-Identifier: Apache-2.0
//
// Whole attempts with the stock plugins: threads, record, ends.
#include "session/session.hpp"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "base/clock.hpp"
#include "record/store.hpp"
#include "session/sentences.hpp"
#include "session_bed.hpp"
#include "toolkit/math.hpp"

namespace swage::session {
namespace {

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

// 5 kg of lead on steel: what comes out is not surgery, whatever a lesson makes of it
TEST_F(SessionTest, AForceThatNoHandCanMakeVoidsTheAttempt) {
  options.lesson_path = folder + "/heavy.json";
  options.device = "";
  std::ofstream(options.lesson_path) << R"({ "format": "swage-lesson/1", "id": "test.heavy", "title": "Heavy",
    "objects": [ { "name": "ball", "plugin": "swage.object.solids", "pose": { "p": [0, 0, "100 mm"] },
                   "params": { "form": "sphere", "diameter": "100 mm", "density": 11000 } },
                 { "name": "floor", "plugin": "swage.object.solids", "pose": { "p": [0, 0, "-10 mm"] },
                   "params": { "form": "box", "fixed": true, "size": ["200 mm", "200 mm", "20 mm"] } } ],
    "couplings": [ { "plugin": "swage.coupling.contact", "between": ["ball", "floor"] } ],
    "lesson": { "plugin": "swage.lesson.look" } })";
  options.max_time_s = 2;
  const Result result = run();
  EXPECT_EQ(result.outcome, judge::Outcome::kVoid);
  EXPECT_EQ(result.reason, "host.impossible");
  EXPECT_EQ(result.score, 0);
  EXPECT_LT(result.simulated_s, 0.2) << "it ends there";
  const std::string said = told(result.problems);
  EXPECT_NE(said.find(say::kPressed.words(1) + "500 N" + say::kPressed.words(2)), std::string::npos) << said;
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
  // what never began is not kept
  ASSERT_EQ(store->attempts("").size(), 1u);
  EXPECT_EQ(store->attempts("")[0].state, "aborted");
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
  EXPECT_NEAR(moved, 0.1 * 10e-3, 1e-5);  // a tenth of 10 mm
}

// an attempt of the mouse that stands still, with a button and modifiers that were down in a step before
struct Dragging {
  Dragging(std::unique_ptr<Session> opened, uint32_t buttons, uint32_t modifiers) : session(std::move(opened)) {
    session->start();
    EXPECT_TRUE(session->latest(before));
    p.camera = {1, 0, 0, 0};
    p.buttons = buttons;
    p.modifiers = modifiers;
    session->pointer(p);
    session->pause(false);
    until([&] { return session->latest(after) && after.step >= 64; });
    session->pause(true);
    until([&] { return session->latest(after) && after.paused != 0; });
  }
  ~Dragging() { session->stop(); }
  void send(double dx) {
    p.dx = dx;
    session->pointer(p);
  }
  toolkit::Pose moved() {
    const uint64_t from = after.step;
    session->pause(false);
    until([&] { return session->latest(after) && after.step >= from + 1000; });
    const toolkit::Pose a(before.X_WB[0]), b(after.X_WB[0]);
    return {b.p - a.p, b.q * a.q.conjugate()};
  }
  std::unique_ptr<Session> session;
  snapshot::Snapshot before, after;
  swage_pointer p{};
};

// the last part of a drag and its release come together when a window was busy with a picture
TEST_F(SessionTest, TheEndOfADragCountsWithItsRelease) {
  options.device = "mouse";
  options.start_paused = true;
  Dragging drag(open(), 1, 0);
  drag.send(0.1);
  drag.p.buttons = 0;
  drag.send(0);
  drag.send(0.3);  // without a button it moves nothing
  EXPECT_NEAR(drag.moved().p.x(), 0.1 * 10e-3, 1e-5);
}

// control let go before the button: what was dragged until then is a roll about the line of sight, and no turn
TEST_F(SessionTest, TheEndOfARollIsNoTurn) {
  options.device = "mouse";
  options.start_paused = true;
  Dragging drag(open(), 4, 2);
  drag.send(0.1);
  drag.p.modifiers = 0;
  drag.send(0);
  const toolkit::Vec3 turned = toolkit::log_rotation(drag.moved().q);
  EXPECT_NEAR(turned.z(), -0.1 * 2 * std::numbers::pi / 3, 1e-3);
  EXPECT_NEAR(turned.head<2>().norm(), 0, 1e-3);
}

// a stroke that the window handles all at once is as long as its release is late; what comes behind it waits, too
TEST_F(SessionTest, AReleaseWaitsForItsTime) {
  options.device = "mouse";
  options.start_paused = true;
  auto session = open();
  session->start();
  swage_pointer p{};
  p.camera = {1, 0, 0, 0};
  p.keys = uint64_t{1} << ('d' - 'a');
  session->pointer(p);
  p.keys = 0;
  const int64_t due_ns = base::wall_ns() + 300'000'000;
  session->pointer(p, due_ns);
  p.buttons = 1;
  p.dx = 1;
  session->pointer(p);
  snapshot::Snapshot now;
  ASSERT_TRUE(session->latest(now));
  const double x = now.X_WB[0].p.x, y = now.X_WB[0].p.y;
  const auto moved = [&] { return std::hypot(now.X_WB[0].p.x - x, now.X_WB[0].p.y - y); };
  session->pause(false);
  until([&] { return session->latest(now) && moved() > 0.2e-3; });  // twice what the shortest stroke moves
  // Only the key has moved it, 4 mm/s; the drag alone is 10 mm. A machine that is slow reads this late and tells nothing.
  if (base::wall_ns() < due_ns) {
    EXPECT_LT(moved(), 4e-6 * static_cast<double>(now.step) + 1e-5);
  }
  until([&] { return base::wall_ns() > due_ns + 50'000'000 && session->latest(now) && moved() > 9e-3; });
  const uint64_t from = now.step;
  until([&] { return session->latest(now) && now.step > from + 500; });
  const double there = moved();
  until([&] { return session->latest(now) && now.step > from + 1500; });
  EXPECT_NEAR(moved(), there, 1e-6) << "the key is up";
  session->stop();
}

// down and up before the next step looks, as a quick finger does it on a slow screen
TEST_F(SessionTest, AShortStrokeOfAKeyIsSeen) {
  options.lesson_path = SWAGE_SOURCE_DIR "/lessons/series/045_pass_the_needle.json";
  options.device = "mouse";
  options.start_paused = true;
  auto session = open();
  ASSERT_NE(session, nullptr);
  session->start();
  swage_pointer p{};
  p.camera = {1, 0, 0, 0};
  const auto stroke = [&] {
    for (const uint64_t keys : {uint64_t{1} << 46, uint64_t{0}}) {
      p.keys = keys;
      session->pointer(p);
    }
  };
  stroke();
  snapshot::Snapshot now;
  session->pause(false);
  until([&] { return session->latest(now) && now.step >= 64; });
  EXPECT_EQ(now.device[0].valid & SWAGE_VALID_BUTTONS, 0u);
  EXPECT_NE(now.device[1].valid & SWAGE_VALID_BUTTONS, 0u) << "Tab has handed over";
  session->stop();
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
  EXPECT_NE(told(problems).find(say::kNotLive.words(2)), std::string::npos) << told(problems);
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

// the whole program stands still for a while, as on a machine that cannot keep up: what was left out is told with the result
TEST_F(SessionTest, AnAttemptThatCouldNotKeepUpSaysSo) {
  options.pace = Pace::kRealtime;
  options.max_time_s = 1;
  auto session = open();
  session->start();
  snapshot::Snapshot s;
  until([&] { return session->latest(s) && s.step > 100; });
  const pid_t child = fork();
  if (child == 0) {
    kill(getppid(), SIGSTOP);
    usleep(500'000);
    kill(getppid(), SIGCONT);
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  session->wait();
  const Result result = session->result();
  EXPECT_LT(result.speed, 0.8);
  EXPECT_GT(result.speed, 0);
  EXPECT_NE(told(result.problems).find(say::kTooSlow.words(1)), std::string::npos) << told(result.problems);
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
