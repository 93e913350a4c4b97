// SPDX-License-Identifier: Apache-2.0
//
// The program itself, without a screen: SIGTERM ends its attempt as Stop does, and the attempt is stored.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "record/recorder.hpp"
#include "record/store.hpp"
#include "temp_folder.hpp"
#include "test_places.hpp"

namespace swage::test {
namespace {

// an attempt with an unmoved mouse: only the signal ends it
const std::string kLesson = SWAGE_SOURCE_DIR "/lessons/series/020_grasp_basic.json";

std::vector<record::AttemptRow> kept(const std::string& store) {
  std::string error;
  if (!std::filesystem::exists(store)) return {};
  const auto opened = record::Store::open(store, error);
  return opened ? opened->attempts("") : std::vector<record::AttemptRow>();
}

TEST(Signal, EndsTheConsolesAttemptAsStopDoes) {
  const TempFolder folder;
  const std::string store = folder.path() + "/a.db";
  const pid_t child = fork();
  if (child == 0) {
    setenv("HOME", folder.path().c_str(), 1);
    setenv("XDG_CONFIG_HOME", folder.path().c_str(), 1);
    const int log = open((folder.path() + "/log").c_str(), O_WRONLY | O_CREAT, 0600);
    dup2(log, STDOUT_FILENO);
    dup2(log, STDERR_FILENO);
    execl(SWAGE_CONSOLE_PROGRAM, SWAGE_CONSOLE_PROGRAM, kLesson.c_str(), "--store", store.c_str(), "--start", nullptr);
    _exit(127);
  }
  // at most 90 s, so that a failing test ends
  for (int i = 0; i < 900 && kept(store).empty(); ++i) usleep(100'000);
  ASSERT_EQ(kept(store).size(), 1u);
  EXPECT_EQ(kept(store)[0].state, "running");
  kill(child, SIGTERM);
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 0) << status;
  ASSERT_EQ(kept(store).size(), 1u);
  EXPECT_EQ(kept(store)[0].state, "aborted");
  EXPECT_EQ(kept(store)[0].reason, "stopped");
}

}  // namespace
}  // namespace swage::test
