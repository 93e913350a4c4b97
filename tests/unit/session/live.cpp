// SPDX-License-Identifier: Apache-2.0
#include "session/live.hpp"

#include <gtest/gtest.h>

#include "session/sentences.hpp"

namespace swage::session {
namespace {

host::Param real(const char* id, uint32_t flags) {
  host::Param p;
  p.id = id;
  p.label = id;
  p.unit = "N";
  p.display_unit = "N";
  p.flags = flags;
  p.max = 10;
  return p;
}

class Live : public ::testing::Test {
 protected:
  Live() {
    instance.name = "holder";
    instance.plugin_id = "swage.object.jaws";
    table = {real("mass", SWAGE_PARAM_REQUIRED), real("grip", SWAGE_PARAM_LIVE | SWAGE_PARAM_REQUIRED),
             real("pull", SWAGE_PARAM_LIVE)};
  }
  bool run(const std::string& json) { return live_commands(instance, 3, table, json, commands, problems); }
  host::Instance instance;
  host::ParamTable table;
  std::vector<step::Command> commands;
  base::Problems problems;
};

TEST_F(Live, OneCommandPerKeyWithTheIndexOfTheWholeTable) {
  ASSERT_TRUE(run(R"({"pull": "20 mN"})"));
  ASSERT_EQ(commands.size(), 1u);
  EXPECT_EQ(commands[0].kind, step::CommandKind::kLiveParameter);
  EXPECT_EQ(commands[0].object, 3u);
  EXPECT_EQ(commands[0].parameter, 2u);
  EXPECT_DOUBLE_EQ(commands[0].number[0], 0.02);
}

TEST_F(Live, WhatIsNotLiveSaysWhatIs) {
  EXPECT_FALSE(run(R"({"mass": 1, "pull": 1})"));
  EXPECT_TRUE(commands.empty());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].where, "holder #/mass");
  EXPECT_EQ(problems[0].message,
            say::kNotLive("mass", "swage.object.jaws", say::kLiveAre("grip, pull")));
}

TEST_F(Live, ValuesAreCheckedLikeThoseOfALesson) {
  EXPECT_FALSE(run(R"({"pull": "3 mm"})"));
  EXPECT_FALSE(run(R"({"pull": 11})"));
  EXPECT_FALSE(run(R"({"pul": 1})"));
  EXPECT_FALSE(run("[]"));
  EXPECT_FALSE(run("{"));
  EXPECT_TRUE(commands.empty());
  EXPECT_GE(problems.size(), 5u);
}

}  // namespace
}  // namespace swage::session
