// SPDX-License-Identifier: Apache-2.0
#include "program.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;
using Audit = Program;

TEST_F(Audit, ClimbsEachLadderAndSaysWhatIsEnough) {
  const Said said = swage({"audit", source("lessons/series/020_grasp_basic.json"), "--json"});
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
  EXPECT_THAT(names, testing::IsSupersetOf({"grasp.level", "engine.contact", "engine.free_motion"}));
}

// the comparison can fail
TEST_F(Audit, SaysByWhichMetricALevelDiffers) {
  // as clumsy as the hand is, the chain of spheres of the thesis feels other forces than the arc
  const Said said = swage(
      {"audit", source("lessons/series/020_grasp_basic.json"), "--device", "clumsy", "--tolerance", "1e-6"});
  ASSERT_LE(said.code, 1) << said.err;
  EXPECT_THAT(said.out, HasSubstr("differs: "));
  EXPECT_THAT(said.out, HasSubstr("reference"));
}

TEST_F(Audit, RefusesWhatIsNoLesson) {
  write("broken.json", "{");
  EXPECT_EQ(swage({"audit", path("broken.json")}).code, 2);
  EXPECT_EQ(swage({"audit", source("lessons/series/020_grasp_basic.json"), "--device", "nobody"}).code, 2);
}

}  // namespace
}  // namespace swage::tools::test
