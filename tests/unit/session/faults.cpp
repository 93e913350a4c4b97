// SPDX-License-Identifier: Apache-2.0
//
// What a bad plugin costs: its attempt, not the session, and never the record of others.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "record/export.hpp"
#include "record/store.hpp"
#include "session/sentences.hpp"
#include "session/session.hpp"
#include "test_places.hpp"

namespace swage::session {
namespace {

namespace fs = std::filesystem;

std::string told(const Problems& problems) {
  std::string out;
  for (const Problem& p : problems) out += p.where + ": " + p.message + "\n";
  return out;
}

// a bad ball beside a good one, both free in space
class Faults : public ::testing::Test {
 protected:
  Faults() {
    char name[] = "/tmp/swage-faults-XXXXXX";
    folder = mkdtemp(name);
    setenv("XDG_STATE_HOME", folder.c_str(), 1);
    setenv("XDG_DATA_HOME", folder.c_str(), 1);
    unsetenv("SWAGE_PLUGIN_PATH");
    fs::create_directory(folder + "/plugins");
    use("org.example.ball", BAD_PLUGINS_DIR);
    use("swage.lesson.look", SWAGE_BINARY_DIR "/plugins");
    options.lesson_path = folder + "/lesson.json";
    options.plugin_dirs = {folder + "/plugins"};
    options.store_path = folder + "/attempts.db";
    options.pace = Pace::kFastest;
    options.max_time_s = 0.2;
  }
  ~Faults() override { fs::remove_all(folder); }

  void use(const std::string& id, const std::string& from) {
    fs::create_directory_symlink(from + "/" + id, folder + "/plugins/" + id);
  }
  void with(const std::string& fault) {
    const std::string id = "org.example.bad." + fault;
    use(id, BAD_PLUGINS_DIR);
    std::ofstream(options.lesson_path)
        << R"({ "format": "swage-lesson/1", "id": "test.faults", "title": "Faults",
      "objects": [ { "name": "good", "plugin": "org.example.ball" },
                   { "name": "bad", "plugin": ")"
        << id << R"(", "pose": { "p": [0.1, 0, 0] } } ],
      "lesson": { "plugin": "swage.lesson.look" } })";
  }
  void with_good_lesson() {
    std::ofstream(options.lesson_path) << R"({ "format": "swage-lesson/1", "id": "test.good", "title": "Good",
      "objects": [ { "name": "good", "plugin": "org.example.ball" } ],
      "lesson": { "plugin": "swage.lesson.look" } })";
  }
  // a coupling with a fault between two good balls
  void with_coupling(const std::string& fault) {
    const std::string id = "org.example.bad.coupling_" + fault;
    use(id, BAD_PLUGINS_DIR);
    std::ofstream(options.lesson_path)
        << R"({ "format": "swage-lesson/1", "id": "test.faults", "title": "Faults",
      "objects": [ { "name": "first", "plugin": "org.example.ball" },
                   { "name": "second", "plugin": "org.example.ball", "pose": { "p": [0.1, 0, 0] } } ],
      "couplings": [ { "name": "painter", "plugin": ")"
        << id << R"(", "between": ["first", "second"] } ],
      "lesson": { "plugin": "swage.lesson.look" } })";
  }
  Result run() {
    Problems problems;
    auto session = Session::open(options, problems);
    EXPECT_NE(session, nullptr) << told(problems);
    if (!session) return {};
    session->start();
    session->wait();
    return session->result();
  }
  // the same in a program of its own; returns how it ended, `said` is what it wrote to stderr
  int run_in_child(std::string& said) {
    const std::string file = folder + "/stderr";
    const pid_t child = fork();
    if (child == 0) {
      if (!freopen(file.c_str(), "w", stderr)) _exit(99);
      run();
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    std::ifstream in(file);
    said.assign(std::istreambuf_iterator<char>(in), {});
    return status;
  }
  record::AttemptRow only_attempt() {
    std::string error;
    auto store = record::Store::open(options.store_path, error);
    EXPECT_NE(store, nullptr) << error;
    const auto rows = store ? store->attempts("") : std::vector<record::AttemptRow>();
    EXPECT_EQ(rows.size(), 1u);
    return rows.empty() ? record::AttemptRow() : rows[0];
  }

  std::string folder;
  Options options;
};

// a primitive that makes no sense costs what is drawn, and is told: counted, with an event, in words and with the attempt
TEST_F(Faults, WhatIsNotDrawnIsCountedAndTold) {
  const std::pair<const char*, const char*> faults[] = {{"visualkind", "kind"}, {"visualnumber", "b.y"}, {"visualnormal", "direction"}};
  for (const auto& [fault, member] : faults) {
    with_coupling(fault);
    Problems problems;
    auto session = Session::open(options, problems);
    ASSERT_NE(session, nullptr) << told(problems);
    session->start();
    session->wait();
    const Result result = session->result();
    EXPECT_NE(result.outcome, judge::Outcome::kVoid) << fault;
    EXPECT_GT(result.health.visuals.faulty, 0u) << fault;
    EXPECT_EQ(result.health.visuals.object, 1u);
    EXPECT_STREQ(base::visual_member(result.health.visuals.member), member);
    int times = 0;
    judge::Event event;
    while (session->next_event(event)) {
      if (session->card().script.events[event.event].id != "host.not_drawn") continue;
      ++times;
      EXPECT_EQ(event.value, 2) << "two objects come before it";
    }
    EXPECT_EQ(times, 1) << fault;
    const std::string words = told(result.problems);
    EXPECT_NE(words.find("painter"), std::string::npos) << words;
    EXPECT_NE(words.find(member), std::string::npos) << words;
    std::vector<record::Exported> kept;
    std::string error;
    record::Selection which;
    which.attempt_id = result.attempt_id;
    ASSERT_TRUE(record::read_for_export(options.store_path, which, kept, error)) << error;
    ASSERT_EQ(kept.size(), 1u);
    const auto count = std::find_if(kept[0].health.begin(), kept[0].health.end(), [](const auto& h) { return h.id == "visuals.faulty"; });
    ASSERT_NE(count, kept[0].health.end());
    EXPECT_EQ(count->value, static_cast<double>(result.health.visuals.faulty));
  }
}

TEST_F(Faults, NonsenseVoidsTheAttemptAndNamesTheCulprit) {
  for (const char* fault : {"nan", "throws", "huge", "sets_fpu"}) {
    with(fault);
    const Result result = run();
    EXPECT_EQ(result.outcome, judge::Outcome::kVoid) << fault;
    EXPECT_EQ(result.reason, "host.quarantined") << fault;
    EXPECT_EQ(result.score, 0);
    EXPECT_LT(result.steps, 20u);
    const std::string all = told(result.problems);
    EXPECT_NE(all.find("bad: bad (org.example.bad." + std::string(fault)), std::string::npos) << all;
    EXPECT_EQ(all.find("good:"), std::string::npos) << all;
  }
}

TEST_F(Faults, AGoodPluginIsNotAccused) {
  with_good_lesson();
  const Result result = run();
  EXPECT_EQ(result.outcome, judge::Outcome::kAborted);
  EXPECT_EQ(result.reason, "time.limit");
  EXPECT_EQ(result.steps, 200u);
}

// In real time the scene goes on without the culprit, so that everybody sees what is left.
TEST_F(Faults, TheOthersKeepRunning) {
  with("nan");
  options.pace = Pace::kRealtime;
  const Result result = run();
  EXPECT_EQ(result.outcome, judge::Outcome::kVoid);
  EXPECT_EQ(result.steps, 200u);
}

// two milliseconds of its own processor time in each of one
TEST_F(Faults, AlwaysLateIsQuarantinedInRealTimeAlone) {
  with("slow");
  options.pace = Pace::kRealtime;
  const Result clocked = run();
#if defined(__OPTIMIZE__) && !defined(SWAGE_SANITIZED)
  EXPECT_EQ(clocked.outcome, judge::Outcome::kVoid) << told(clocked.problems);
  EXPECT_NE(told(clocked.problems).find("was late"), std::string::npos) << told(clocked.problems);
#endif
  EXPECT_GT(clocked.health.own_overrun, 5u);
  options.pace = Pace::kFastest;
  EXPECT_EQ(run().outcome, judge::Outcome::kAborted);  // without a clock nobody is late
}

TEST_F(Faults, ACrashIsRememberedAndTheRecordIsSafe) {
  with("crashes_in_step");
  std::string said;
  const int status = run_in_child(said);
  EXPECT_TRUE(WIFSIGNALED(status) || WEXITSTATUS(status) != 0);

  // the next start tells
  Problems problems;
  with_good_lesson();
  ASSERT_NE(Session::open(options, problems), nullptr);
  const std::string all = told(problems);
  EXPECT_NE(all.find(say::kEndedInPlugin.words(1) + "forces() of \"bad\" (org.example.bad.crashes_in_step" + say::kEndedInPlugin.words(4) + "10"), std::string::npos)
      << all;
  EXPECT_NE(all.find("safe mode"), std::string::npos);
  problems.clear();
  ASSERT_NE(Session::open(options, problems), nullptr);
  EXPECT_EQ(told(problems).find("safe mode"), std::string::npos);  // once
}

TEST_F(Faults, AHangEndsTheProgramWithTheAttemptSaved) {
  with("hangs_in_step");
  options.pace = Pace::kRealtime;
  std::string said;
  const int status = run_in_child(said);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 70);
  EXPECT_NE(said.find("forces() of \"bad\" (org.example.bad.hangs_in_step"), std::string::npos) << said;
  EXPECT_NE(said.find(say::kHung.words(2)), std::string::npos);
  const record::AttemptRow row = only_attempt();
  EXPECT_TRUE(row.is_void);
  EXPECT_NE(row.state, "running");
  EXPECT_EQ(row.reason, "host.hung");
}

}  // namespace
}  // namespace swage::session
