// SPDX-License-Identifier: Apache-2.0
//
// Same inputs, same bits: the hash of the whole state at fixed steps of every stock lesson, equal at -O0, at -O2 and with
// clang. When a hash changes on purpose, write the file anew with SWAGE_WRITE_GOLDEN=1 and say why in the commit.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>
#include <ostream>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "run_lesson.hpp"
#include "test_places.hpp"

namespace {

using nlohmann::json;

constexpr const char* kFile = SWAGE_SOURCE_DIR "/tests/determinism/golden.json";
constexpr uint64_t kGrasped[] = {1, 500, 2000, 4000}, kInserted[] = {1, 4000, 9000, 9500};

struct Case {
  const char* lesson;
  const char* hand;
  std::span<const uint64_t> steps = kGrasped;
  std::vector<std::string> settings = {};  // beside what the file says

  std::string name() const {
    std::string all = std::string(lesson) + "/" + hand;
    for (const std::string& setting : settings) all += " " + setting;
    return all;
  }
  friend void PrintTo(const Case& c, std::ostream* out) { *out << c.name(); }
};
const Case kCases[] = {{"010_practice_solids", "expert"},
                       {"020_grasp_basic", "expert"},
                       {"020_grasp_basic", "clumsy"},
                       {"020_grasp_basic", "expert", kGrasped, {"needle.level=bending"}},
                       {"030_grasp_advanced_1_quarter", "expert"},
                       {"031_grasp_advanced_1_three_eighths", "novice"},
                       {"032_grasp_advanced_1_half", "clumsy"},
                       {"040_grasp_advanced_2", "expert"},
                       {"050_suture_grasp", "expert", kGrasped},
                       {"050_suture_grasp", "expert", kGrasped, {"suture.diameter=60 um", "suture.memory=0 1/m", "suture.yield=0.001"}},
                       {"051_suture_carry", "expert", kGrasped},
                       {"110_insertion", "expert", kInserted},
                       {"110_insertion", "expert", kInserted, {"needle.level=rigid"}},
                       {"110_insertion", "expert", kInserted, {"needle.level=rigid", "tissue.level=mesh"}}};

std::string lesson_file(const std::string& name) {
  return SWAGE_SOURCE_DIR "/lessons/series/" + name + ".json";
}

std::string hex(uint64_t hash) {
  char text[20];
  std::snprintf(text, sizeof text, "%016lx", hash);
  return text;
}

/// Hash of the state after each of its steps.
json trace(const Case& c) {
  swage::stage::LessonRun run(lesson_file(c.lesson), c.hand, c.settings);
  json hashes = json::object();
  if (!run.ready()) {
    ADD_FAILURE() << run.problems();
    return hashes;
  }
  uint64_t done = 0;
  for (const uint64_t until : c.steps) {
    for (; done < until; ++done) run.step();
    hashes[std::to_string(until)] = hex(run.engine().hash());
  }
  return hashes;
}

json golden() {
  std::ifstream in(kFile);
  return json::parse(in);
}

class StockLesson : public testing::TestWithParam<Case> {};

TEST_P(StockLesson, HasTheBitsOfTheFile) {
  const json now = trace(GetParam());
  json all = golden();
  if (!std::getenv("SWAGE_WRITE_GOLDEN")) {
    EXPECT_EQ(now, all[GetParam().name()]) << GetParam().name();
    return;
  }
  all[GetParam().name()] = now;
  std::ofstream(kFile) << all.dump(2) << '\n';
  GTEST_SKIP() << "golden.json was written anew";
}

INSTANTIATE_TEST_SUITE_P(Golden, StockLesson, testing::ValuesIn(kCases), [](const auto& c) { return std::to_string(c.index); });

TEST(Golden, TheFileHasTheseLessonsAndNoOthers) {
  std::set<std::string> in_file, run;
  const json all = golden();
  for (auto it = all.begin(); it != all.end(); ++it) in_file.insert(it.key());
  for (const Case& c : kCases) run.insert(c.name());
  EXPECT_EQ(in_file, run);
}

TEST(Golden, ARunRepeatsItself) { EXPECT_EQ(trace(kCases[1]), trace(kCases[1])); }

TEST(Golden, AnotherSceneInTheSameProgramChangesNothing) {
  swage::stage::LessonRun one(lesson_file("020_grasp_basic"), "expert"),
      alone(lesson_file("020_grasp_basic"), "expert");
  swage::stage::LessonRun other(lesson_file("010_practice_solids"), "expert");
  ASSERT_TRUE(one.ready() && alone.ready() && other.ready());
  for (int i = 0; i < 1000; ++i) one.step(), other.step();
  for (int i = 0; i < 1000; ++i) alone.step();
  EXPECT_EQ(one.engine().hash(), alone.engine().hash());
}

// the comparison can fail: another hand gives other bits
TEST(Golden, AnotherHandGivesOtherBits) { EXPECT_NE(trace(kCases[1])["4000"], trace(kCases[2])["4000"]); }

}  // namespace
