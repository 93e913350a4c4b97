// SPDX-License-Identifier: Apache-2.0
#include <filesystem>

#include "program.hpp"

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

// no level ends within a millisecond of processor time, and it is said
TEST_F(Audit, SaysWhichLevelWasTooSlow) {
  const Said said = swage({"audit", kLesson, "--budget", "0.001"});
  ASSERT_LE(said.code, 1) << said.err;
  EXPECT_THAT(said.out, HasSubstr("cannot be played: too slow: stopped at"));
}

// the comparison can fail
TEST_F(Audit, SaysByWhichMetricALevelDiffers) {
  // as clumsy as the hand is, the chain of spheres of the thesis feels other forces than the arc
  const Said said =
      swage({"audit", kLesson, "--device", "clumsy", "--tolerance", "1e-6", "--only", "engine.contact"});
  ASSERT_LE(said.code, 1) << said.err;
  EXPECT_THAT(said.out, testing::ContainsRegex("differs +[0-9.]+ +[a-z_.]+ [0-9.]+ instead of"));
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
