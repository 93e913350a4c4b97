// SPDX-License-Identifier: Apache-2.0
//
// kill -9 in a school: of the console during an attempt, and of the server while the console runs on. The store stays
// consistent, and the stored part of an attempt replays bit for bit. SWAGE_KILL_TRIALS: number of kills; if set, the loss is judged, too,
// which depends on the machine.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "base/clock.hpp"
#include "host/child.hpp"
#include "postgres_server.hpp"
#include "record/address.hpp"
#include "record/recorder.hpp"
#include "record/store.hpp"
#include "temp_folder.hpp"
#include "test_places.hpp"

namespace swage::test {
namespace {

using record::AttemptRow;
using record::test::PostgresServer;

int trials() {
  const char* text = std::getenv("SWAGE_KILL_TRIALS");
  return text != nullptr ? std::atoi(text) : 2;
}
bool is_soak() { return std::getenv("SWAGE_KILL_TRIALS") != nullptr; }

double now_s() { return 1e-9 * static_cast<double>(base::wall_ns()); }
void nap(double s) { base::sleep_until_ns(base::wall_ns() + static_cast<int64_t>(1e9 * s)); }

class Kills : public testing::Test {
 protected:
  Kills() {
    for (const char* place : {"HOME", "XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME"}) setenv(place, folder_.path().c_str(), 1);
  }
  ~Kills() override {
    if (console_ > 0) kill_console(SIGKILL);
  }

  /// Starts 020 with a recorded hand, the novice's, which takes longer than any test waits before the kill.
  void start_console(const std::string& store) {
    console_ = fork();
    if (console_ != 0) return;
    const int log = open((folder_ / "log").c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    const std::string lesson = SWAGE_SOURCE_DIR "/lessons/series/020_grasp_basic.json";
    execl(SWAGE_CONSOLE_PROGRAM, SWAGE_CONSOLE_PROGRAM, lesson.c_str(), "--device", "novice", "--store", store.c_str(), "--start", nullptr);
    _exit(127);
  }
  /// Returns the exit status as from waitpid.
  int kill_console(int signal) {
    int status = 0;
    kill(console_, signal);
    waitpid(console_, &status, 0);
    console_ = -1;
    return status;
  }

  /// Waits until the newest of `count` attempts has steps in the store. False after 90 s, so that a failing test ends.
  bool recording(const std::string& store, std::size_t count) const {
    for (const double until = now_s() + 90; now_s() < until; nap(0.05))
      if (attempts(store).size() == count && kept(store) > 0) return true;
    return false;
  }
  std::vector<AttemptRow> attempts(const std::string& store) const {
    std::string error;
    if (!record::is_postgres(store) && access(store.c_str(), R_OK) != 0) return {};
    const auto opened = record::Store::open(store, error);
    return opened ? opened->attempts("") : std::vector<AttemptRow>();
  }
  /// Steps of the newest attempt.
  std::size_t kept(const std::string& store) const {
    const std::vector<AttemptRow> all = attempts(store);
    record::Recording recording;
    std::string error;
    return !all.empty() && record::read_recording(store, all[0].id, recording, error) ? recording.step.size() : 0;
  }

  host::ChildResult swage(std::vector<std::string> words, const std::string& store) const {
    words.insert(words.begin(), SWAGE_PROGRAM);
    words.insert(words.end(), {"--store", store, "--plugin-dir", SWAGE_BINARY_DIR "/plugins", "--json"});
    return host::run_program(words, 60);
  }
  void expect_whole(const std::string& store) const {
    const host::ChildResult doctor = swage({"doctor"}, store);
    bool found = false;
    for (const auto& one : nlohmann::json::parse(doctor.out, nullptr, false)) {
      if (one.value("name", "") != "store") continue;
      found = true;
      EXPECT_EQ(one.value("state", ""), "good") << one.dump();
    }
    EXPECT_TRUE(found) << doctor.out << doctor.err;
  }
  void expect_replays(const std::string& store) const {
    const host::ChildResult again = swage({"replay", attempts(store).at(0).id}, store);
    EXPECT_EQ(again.exit_code, 0) << again.out << again.err;
  }

  TempFolder folder_;
  pid_t console_ = -1;
  std::mt19937 random_{14};
};

TEST_F(Kills, OfTheConsoleLeaveItsStoreWholeAndWhatWasKeptOfTheAttempt) {
  const std::string store = folder_ / "attempts.db";
  std::uniform_real_distribution<double> more(0, 3);
  double worst = 0;
  for (int trial = 0; trial < trials(); ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    start_console(store);
    ASSERT_TRUE(recording(store, static_cast<std::size_t>(trial) + 1));
    // lower limit of the steps made: those in the store, and 1 000 a second since
    std::size_t seen = kept(store);
    double made = static_cast<double>(seen) - 1e3 * now_s();
    for (const double until = now_s() + more(random_); now_s() < until; nap(0.1)) {
      seen = kept(store);
      made = std::max(made, static_cast<double>(seen) - 1e3 * now_s());
    }
    const double at = now_s();
    kill_console(SIGKILL);
    expect_whole(store);
    {
      std::string error;
      const auto opened = record::Store::open(store, error);
      ASSERT_TRUE(opened) << error;
      EXPECT_EQ(opened->recover(), 1);
    }
    EXPECT_EQ(attempts(store).at(0).state, "recovered");
    EXPECT_GE(kept(store), seen);
    worst = std::max(worst, made + 1e3 * at - static_cast<double>(kept(store)));
    expect_replays(store);
  }
  std::printf("worst loss in %d kills: %.0f ms\n", trials(), worst);
  if (is_soak()) {
    EXPECT_LE(worst, 1000) << "ms";
  }
}

TEST_F(Kills, OfTheServerCostNoStepOfTheAttempt) {
  PostgresServer server;
  if (!server.running()) GTEST_SKIP() << server.why_not();
  const std::string store = server.make_database("school");
  std::uniform_real_distribution<double> more(0, 2), away(0, 2);
  for (int trial = 0; trial < trials(); ++trial) {
    SCOPED_TRACE("trial " + std::to_string(trial));
    start_console(store);
    ASSERT_TRUE(recording(store, static_cast<std::size_t>(trial) + 1));
    nap(more(random_));
    server.crash();
    nap(away(random_));
    ASSERT_TRUE(server.start());
    nap(away(random_));
    const int status = kill_console(SIGTERM);
    EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
    expect_whole(store);
    const std::vector<AttemptRow> all = attempts(store);
    ASSERT_EQ(all.size(), static_cast<std::size_t>(trial) + 1) << "once";
    EXPECT_NE(all[0].state, "running");
    EXPECT_NE(all[0].state, "recovered");
    EXPECT_GE(kept(store), static_cast<std::size_t>(1e3 * all[0].simulated_s)) << "every step";
    expect_replays(store);
  }
}

}  // namespace
}  // namespace swage::test
