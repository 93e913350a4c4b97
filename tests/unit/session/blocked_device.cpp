// SPDX-License-Identifier: Apache-2.0
//
// A device that does not come back costs a sentence, never the result nor the program.
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "record/store.hpp"
#include "session/bounded_call.hpp"
#include "session/sentences.hpp"
#include "session/session.hpp"
#include "test_places.hpp"

namespace swage::session {
namespace {

namespace fs = std::filesystem;

class BlockedDevice : public ::testing::Test {
 protected:
  BlockedDevice() {
    char name[] = "/tmp/swage-blocked-XXXXXX";
    folder = mkdtemp(name);
    setenv("XDG_STATE_HOME", folder.c_str(), 1);
    setenv("XDG_DATA_HOME", folder.c_str(), 1);
    unsetenv("SWAGE_PLUGIN_PATH");
    options.lesson_path = folder + "/lesson.json";
    options.plugin_dirs = {BAD_PLUGINS_DIR "_evil/org.example.bad.devices", BAD_PLUGINS_DIR "/org.example.ball", SWAGE_BINARY_DIR "/plugins"};
    options.store_path = folder + "/attempts.db";
    options.max_time_s = 0.2;
    options.pace = Pace::kRealtime;
  }
  ~BlockedDevice() override { fs::remove_all(folder); }

  void with(const std::string& fault) {
    std::ofstream(options.lesson_path) << R"({ "format": "swage-lesson/1", "id": "test.blocked", "title": "Blocked",
      "objects": [ { "name": "ball", "plugin": "org.example.ball" } ],
      "devices": [ { "name": "hand", "plugin": "org.example.bad.device.)"
                                       << fault << R"(" } ],
      "lesson": { "plugin": "swage.lesson.look" } })";
  }
  // an attempt in a program of its own, as main() would end it; `said` is what it told
  int attempt(std::string& said) {
    const std::string file = folder + "/told";
    const pid_t child = fork();
    if (child == 0) {
      alarm(60);  // else a test that fails would hang
      Problems problems;
      int code = 3;
      {
        auto session = Session::open(options, problems);
        if (session) {
          session->start();
          session->wait();
          const Result result = session->result();
          for (const Problem& p : result.problems) problems.push_back(p);
          code = result.reason == "time.limit" ? 0 : 4;
        }
      }
      std::ofstream out(file);
      for (const Problem& p : problems) out << p.where << ": " << p.message << "\n";
      out.close();
      exit(end_program(code));
    }
    int status = 0;
    waitpid(child, &status, 0);
    std::ifstream in(file);
    said.assign(std::istreambuf_iterator<char>(in), {});
    return status;
  }
  std::string kept_reason() {
    std::string error;
    auto store = record::Store::open(options.store_path, error);
    const auto rows = store ? store->attempts("") : std::vector<record::AttemptRow>();
    return rows.size() == 1 ? rows[0].reason : "kept " + std::to_string(rows.size()) + " attempts";
  }

  std::string folder;
  Options options;
};

TEST_F(BlockedDevice, InExchangeIsLeftBehindAfterTheResult) {
  with("exchange_blocks");
  std::string said;
  const int status = attempt(said);
  ASSERT_TRUE(WIFEXITED(status)) << said;
  EXPECT_EQ(WEXITSTATUS(status), 0) << said;
  EXPECT_NE(said.find("hand: " + say::kLeftBehind.words(0) + "org.example.bad.device.exchange_blocks 1.0.0" + say::kLeftBehind.words(2) + "exchange"),
            std::string::npos)
      << said;
  EXPECT_EQ(kept_reason(), "time.limit");
}

TEST_F(BlockedDevice, InCloseIsLeftBehindAfterTheResult) {
  with("close_blocks");
  std::string said;
  const int status = attempt(said);
  ASSERT_TRUE(WIFEXITED(status)) << said;
  EXPECT_EQ(WEXITSTATUS(status), 0) << said;
  EXPECT_NE(said.find(say::kLeftBehind.words(2) + "close" + say::kLeftBehind.words(3)), std::string::npos) << said;
  EXPECT_EQ(kept_reason(), "time.limit");
}

TEST_F(BlockedDevice, InOpenIsAProblemAndNoAttempt) {
  with("open_blocks");
  std::string said;
  const int status = attempt(said);
  ASSERT_TRUE(WIFEXITED(status)) << said;
  EXPECT_EQ(WEXITSTATUS(status), 3) << said;
  EXPECT_NE(said.find(say::kLeftBehind.words(2) + "open" + say::kLeftBehind.words(3)), std::string::npos) << said;
}

}  // namespace
}  // namespace swage::session
