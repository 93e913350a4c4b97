// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>

#include "program.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;
using Audit = Program;

const std::string kLesson = source("lessons/series/020_grasp_basic.json");

TEST_F(Audit, ClimbsEachLadderAndSaysWhatIsEnough) {
  const Said said = swage({"audit", kLesson, "--json", "--only", "grasp.level", "--only", "engine.contact",
                           "--only", "engine.free_motion"});
  ASSERT_LE(said.code, 1) << said.err;
  const nlohmann::json lesson = said.json()[0];
  EXPECT_EQ(lesson["device"], "expert");
  std::vector<std::string> names;
  for (const auto& ladder : lesson["ladders"]) {
    names.push_back(ladder["ladder"]);
    ASSERT_GE(ladder["levels"].size(), 2u);
    const auto& finest = ladder["reference"];
    for (const auto& level : ladder["levels"]) {
      if (level["level"] != finest) continue;
      EXPECT_EQ(level["outcome"], "passed") << ladder["ladder"];
      EXPECT_TRUE(level["enough"]) << "a level is like itself";
      EXPECT_GT(level["cpu_s"], 0);
      EXPECT_TRUE(level["metrics"].contains("grasp.tries"));
    }
  }
  EXPECT_THAT(names, testing::ElementsAre("grasp.level", "engine.contact", "engine.free_motion"));
}

TEST_F(Audit, WritesTablesAndChartWhenAsked) {
  const Said said = swage({"audit", kLesson, "--out", path("audit"), "--max-time", "0.1"});
  ASSERT_LE(said.code, 1) << said.err;
  for (const char* name : {"audit.csv", "audit_metrics.csv", "audit.md", "audit.svg"})
    EXPECT_TRUE(std::filesystem::exists(path("audit/") + name)) << name;
}

TEST_F(Audit, AddsLessonsToAnEarlierOne) {
  const std::string other = source("lessons/series/030_grasp_advanced_1_quarter.json");
  const auto audit = [&](const std::string& lesson, std::vector<std::string> more) {
    std::vector<std::string> line = {"audit", lesson, "--out", path("audit"), "--max-time", "0.05", "--only", "grasp.level"};
    line.insert(line.end(), more.begin(), more.end());
    return swage(line).code;
  };
  const auto lessons = [&] {
    std::ifstream file(path("audit/audit_runs.json"));
    const auto runs = nlohmann::json::parse(file);
    std::vector<std::string> ids;
    for (const auto& lesson : runs["lessons"]) ids.push_back(lesson["id"]);
    return ids;
  };
  ASSERT_LE(audit(other, {"--add"}), 1) << "a folder without an audit";
  ASSERT_LE(audit(kLesson, {"--add"}), 1);
  ASSERT_EQ(lessons().size(), 2u);
  EXPECT_EQ(lessons()[0], "swage.series.grasp_basic");
  ASSERT_LE(audit(kLesson, {}), 1);
  EXPECT_EQ(lessons().size(), 1u) << "without --add it is written anew";
  write("audit/audit_runs.json", "{");
  EXPECT_EQ(audit(kLesson, {"--add"}), 2);
  EXPECT_EQ(swage({"audit", kLesson, "--add"}).code, 2) << "to which audit?";
}

TEST_F(Audit, ClimbsTheNumberOfSegmentsOfAThread) {
  const Said said = swage({"audit", source("lessons/series/050_suture_grasp.json"), "--json", "--only", "suture.segments",
                           "--max-time", "0.02"});
  ASSERT_LE(said.code, 1) << said.err;
  const nlohmann::json ladder = said.json()[0]["ladders"][0];
  std::vector<std::string> names;
  for (const auto& level : ladder["levels"]) {
    names.push_back(level["level"]);
    EXPECT_EQ(level["problem"], "");
  }
  EXPECT_THAT(names, testing::ElementsAre("quarter (10)", "half (20)", "its own (40)", "twice (80)", "four times (160)"));
  EXPECT_EQ(ladder["own"], "its own (40)");
  EXPECT_EQ(ladder["reference"], "four times (160)");
}

// no level ends within a millisecond of processor time, and it is said
TEST_F(Audit, SaysWhichLevelWasTooSlow) {
  const Said said = swage({"audit", kLesson, "--budget", "0.001"});
  ASSERT_LE(said.code, 1) << said.err;
  EXPECT_THAT(said.out, HasSubstr(say::kNotPlayed(say::kTooSlow.words(0))));
}

// the comparison can fail
TEST_F(Audit, SaysByWhichMetricALevelDiffers) {
  // as clumsy as the hand is, the chain of spheres of the thesis feels other forces than the arc
  const Said said =
      swage({"audit", kLesson, "--device", "clumsy", "--tolerance", "1e-6", "--only", "engine.contact"});
  ASSERT_LE(said.code, 1) << said.err;
  EXPECT_THAT(said.out, testing::ContainsRegex("differs +[0-9.]+ +" + say::kInstead("[a-z_.]+", "[0-9.]+", "")));
  EXPECT_THAT(said.out, HasSubstr("reference"));
}

TEST_F(Audit, RefusesWhatIsNoLesson) {
  write("broken.json", "{");
  EXPECT_EQ(swage({"audit", path("broken.json")}).code, 2);
  EXPECT_EQ(swage({"audit"}).code, 2);
  EXPECT_EQ(swage({"audit", kLesson, "--only", "thread.level"}).code, 2);
  EXPECT_EQ(swage({"audit", kLesson, "--device", "nobody"}).code, 2);
}

}  // namespace
}  // namespace swage::tools::test
