// SPDX-License-Identifier: Apache-2.0
//
// Whole scenes without one allocation, lock, sleep or file access in the step; and that such things would be seen.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "attempt.hpp"
#include "host/services.hpp"
#include "rt_calls.hpp"
#include "test_places.hpp"

namespace swage::realtime {
namespace {

namespace fs = std::filesystem;

const std::string kLessons = SWAGE_SOURCE_DIR "/lessons/series/";
const std::vector<std::string> kPlugins = {SWAGE_BINARY_DIR "/plugins"};

// ticks an attempt to its end on a thread in the role [rt]; returns what it called that it must not
Calls play(Attempt& attempt, int most_ticks, int& ticks) {
  Calls out;
  std::thread thread([&] {
    host::set_thread_role(SWAGE_THREAD_RT);
    const Calls before = calls();
    for (ticks = 0; ticks < most_ticks && attempt.tick();) ++ticks;
    out = calls() - before;
  });
  thread.join();
  return out;
}

#define SKIP_WITHOUT_COUNTING() \
  if (!counts()) GTEST_SKIP() << "a sanitizer has the allocator"

class WholeScene : public ::testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(WholeScene, CallsNothingThatMayBlock) {
  SKIP_WITHOUT_COUNTING();
  const auto [lesson, device] = GetParam();
  char name[] = "/tmp/swage-realtime-XXXXXX";
  const std::string folder = mkdtemp(name);
  {
    Attempt attempt(kLessons + lesson, device, kPlugins, folder + "/attempts.db");
    ASSERT_TRUE(attempt.ok());
    int ticks = 0;
    step::Command reset;
    reset.kind = step::CommandKind::kResetObject;
    reset.object = 1;
    attempt.loop().command(reset);
    for (int i = 0; i < 100; ++i) attempt.loop().pointer({}, 0);
    const Calls c = play(attempt, 30000, ticks);
    EXPECT_GT(ticks, 1000);
    EXPECT_EQ(c.heap, 0u);
    EXPECT_EQ(c.lock, 0u);
    EXPECT_EQ(c.sleep, 0u);
    EXPECT_EQ(c.file, 0u);
    EXPECT_EQ(c.thread, 0u);
  }
  fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Stock, WholeScene,
                         ::testing::Values(std::pair{"010_practice_solids.json", "expert"},
                                           std::pair{"010_practice_solids.json", "mouse"},
                                           std::pair{"020_grasp_basic.json", "expert"},
                                           std::pair{"020_grasp_basic.json", "novice"},
                                           std::pair{"020_grasp_basic.json", "clumsy"},
                                           std::pair{"110_insertion.json", "expert"},
                                           std::pair{"090_needle_bench.json", "expert"}));

/// The insertion with other text in its lesson file; its hands are found from any folder.
void insertion_with(std::vector<std::pair<std::string, std::string>> changes, const std::string& file) {
  std::ifstream in(kLessons + "110_insertion.json");
  std::string text{std::istreambuf_iterator<char>(in), {}};
  changes.emplace_back("../hands/", SWAGE_SOURCE_DIR "/lessons/hands/");
  for (const auto& [what, by] : changes) {
    size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    for (; at != std::string::npos; at = text.find(what, at + by.size())) text.replace(at, what.size(), by);
  }
  std::ofstream(file) << text;
}

struct Dearest {
  const char *level, *device;  // of the tissue; whose hand
};

class Insertion : public ::testing::TestWithParam<Dearest> {};

// the dearest scenes there are: jaws, a needle that bends, tissue that yields, a tear
TEST_P(Insertion, WithABendingNeedleCallsNothingThatMayBlock) {
  SKIP_WITHOUT_COUNTING();
  char name[] = "/tmp/swage-realtime-XXXXXX";
  const std::string folder = mkdtemp(name), level = GetParam().level;
  insertion_with({{R"("level": "compliant")", R"("level": ")" + level + R"(")"}}, folder + "/insertion.json");
  {
    Attempt attempt(folder + "/insertion.json", GetParam().device, kPlugins, "");
    ASSERT_TRUE(attempt.ok());
    int ticks = 0;
    const Calls c = play(attempt, 30000, ticks);
    EXPECT_GT(ticks, 1000);
    EXPECT_EQ(c.all(), 0u);
    EXPECT_EQ(attempt.engine().quarantined(), 0u);
    std::vector<snapshot::Snapshot> shot(1);
    attempt.engine().fill(shot[0]);
    EXPECT_TRUE(std::any_of(shot[0].visual, shot[0].visual + shot[0].n_visual, [](const auto& m) { return m.visual.kind == SWAGE_VISUAL_WOUND; }))
        << "it went in";
  }
  fs::remove_all(folder);
}

INSTANTIATE_TEST_SUITE_P(Levels, Insertion,
                         ::testing::Values(Dearest{"compliant", "expert"}, Dearest{"compliant", "novice"},
                                           Dearest{"mesh", "expert"}));

// putting everything back, saving and restoring are [rt] as well
TEST(Engine, ResetSaveAndRestoreCallNothingEither) {
  SKIP_WITHOUT_COUNTING();
  Attempt attempt(kLessons + "020_grasp_basic.json", "expert", kPlugins, "");
  ASSERT_TRUE(attempt.ok());
  int ticks = 0;
  play(attempt, 1000, ticks);
  std::vector<std::byte> image(attempt.engine().image_size());
  const Calls before = calls();
  const bool saved = attempt.engine().save(image);
  attempt.engine().reset();
  const bool restored = attempt.engine().restore(image);
  const Calls c = calls() - before;
  EXPECT_TRUE(saved && restored);
  EXPECT_EQ(c.all(), 0u);
}

// the negative: a plugin that allocates in its step is counted in the very same set-up
TEST(RtCalls, SeeAPluginThatAllocates) {
  SKIP_WITHOUT_COUNTING();
  char name[] = "/tmp/swage-realtime-XXXXXX";
  const std::string folder = mkdtemp(name);
  const std::string id = "org.example.bad.allocates";
  fs::create_directory_symlink(std::string(BAD_PLUGINS_DIR) + "/" + id, folder + "/" + id);
  std::ofstream(folder + "/lesson.json")
      << R"({ "format": "swage-lesson/1", "id": "test.allocates", "title": "Allocates",
      "objects": [ { "name": "bad", "plugin": ")"
      << id << R"(" } ], "lesson": { "plugin": "swage.lesson.look" } })";
  {
    Attempt attempt(folder + "/lesson.json", "", {folder, kPlugins[0]}, "");
    ASSERT_TRUE(attempt.ok());
    int ticks = 0;
    EXPECT_GT(play(attempt, 100, ticks).heap, 10u);
    EXPECT_EQ(ticks, 100);
  }
  fs::remove_all(folder);
}

// and each kind of call by itself
TEST(RtCalls, SeeEveryKind) {
  SKIP_WITHOUT_COUNTING();
  const auto count = [](auto work) {
    const Calls before = calls();
    work();
    return calls() - before;
  };
  EXPECT_EQ(count([] {}).all(), 0u);
  std::vector<int> v;
  EXPECT_EQ(count([&] { v.push_back(1); }).heap, 1u);
  EXPECT_GT(count([] {
              try {
                throw 1;
              } catch (...) {
              }
            }).heap,
            0u);
  std::mutex mutex;
  EXPECT_EQ(count([&] { const std::lock_guard lock(mutex); }).lock, 1u);
  std::condition_variable condition;
  EXPECT_GE(count([&] { condition.notify_one(); }).lock, 1u);
  EXPECT_GE(count([] { std::this_thread::sleep_for(std::chrono::microseconds(1)); }).sleep, 1u);
  EXPECT_GE(count([] { std::thread([] {}).join(); }).thread, 1u);
  EXPECT_GE(count([] {
              std::ofstream file("/dev/null");
              file << "words" << std::flush;
            }).file,
            1u);
}

}  // namespace
}  // namespace swage::realtime
