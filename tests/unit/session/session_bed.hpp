// SPDX-License-Identifier: Apache-2.0
//
// A session on the basic grasp, in a home of its own: what the tests of whole attempts share.
#pragma once

#include <gtest/gtest.h>
#include <stdlib.h>

#include <chrono>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>

#include "record/recorder.hpp"
#include "session/session.hpp"
#include "test_places.hpp"

namespace swage::session {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

inline const std::string kGrasp = SWAGE_SOURCE_DIR "/lessons/series/020_grasp_basic.json";

// waits for a condition, not for a time: CTest's limit ends what never comes
template <class F>
void until(F done) {
  while (!done()) std::this_thread::sleep_for(1ms);
}

inline std::string told(const Problems& problems) {
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

}  // namespace swage::session
