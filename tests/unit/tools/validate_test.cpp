// SPDX-License-Identifier: Apache-2.0
#include <fstream>

#include "program.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;
using Validate = Program;

std::string stock(const std::string& id) { return std::string(SWAGE_BINARY_DIR) + "/plugins/" + id; }
std::string bad(const std::string& name) {
  return std::string(SWAGE_BINARY_DIR) + "/tests/bad_plugins/bundles/org.example.bad." + name;
}

TEST_F(Validate, AGoodPluginPasses) {
  const Said said = swage({"validate", stock("swage.object.needle")});
  EXPECT_EQ(said.code, 0) << said.out << said.err;
  for (const char* test : {" 4 stepping ", " 5 rewind ", " 5 alone "}) EXPECT_THAT(said.out, HasSubstr(test));
  EXPECT_THAT(said.out, HasSubstr("\n  good: "));
}

TEST_F(Validate, SteppingTestsFindWhatTheyAskFor) {
  const auto expect = [&](const std::string& plugin, const std::string& test, const std::string& text) {
    const Said said = swage({"validate", bad(plugin), "--only", test, "--strictness", "10"});
    EXPECT_EQ(said.code, 1) << plugin << said.out << said.err;
    EXPECT_THAT(said.out, HasSubstr(text)) << plugin;
    EXPECT_THAT(said.out, HasSubstr("NOT good"));
  };
  expect("nan", "stepping", "wrote a number that is not finite");
  expect("remembers", "rewind", "After restoring the state");
  expect("crashes_in_step", "stepping", "signal 11");
}

TEST_F(Validate, SeveralPathsAndJson) {
  const Said said =
      swage({"validate", stock("swage.object.jaws"), bad("nan"), "--only", "stepping", "--json"});
  EXPECT_EQ(said.code, 1);
  const nlohmann::json list = said.json();
  ASSERT_EQ(list.size(), 2u);
  EXPECT_EQ(list[0]["good"], true);
  EXPECT_EQ(list[0]["tests"][0]["test"], "stepping");
  EXPECT_EQ(list[0]["tests"][0]["result"], "success");
  EXPECT_EQ(list[1]["good"], false);
}

TEST_F(Validate, WrongUses) {
  const Said test = swage({"validate", stock("swage.object.needle"), "--only", "steping"});
  EXPECT_EQ(test.code, 2);
  EXPECT_THAT(test.err, HasSubstr("There is no test \"steping\". Did you mean \"stepping\"? It has: "));
  const Said absent = swage({"validate", path("none")});
  EXPECT_EQ(absent.code, 2);
  EXPECT_THAT(absent.err, HasSubstr("There is no " + path("none")));
}

TEST_F(Validate, LessonFilesToo) {
  const std::string good = source("lessons/series/020_grasp_basic.json");
  const Said said = swage({"validate", good});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_EQ(said.out, good + ": good\n");

  std::ifstream in(good);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::string right = "\"wire_diameter\": \"100 um\"";
  text.replace(text.find(right), right.size(), "\"wire_diameter\": \"0.1 N\"");
  write("wrong.json", text);
  const Said wrong = swage({"validate", path("wrong.json"), "--json"});
  EXPECT_EQ(wrong.code, 1);
  EXPECT_THAT(wrong.err, HasSubstr("wrong.json"));
  EXPECT_THAT(wrong.err, HasSubstr("/params/wire_diameter: \"0.1 N\" is a force;"));
  EXPECT_EQ(wrong.json()[0]["good"], false);
}

}  // namespace
}  // namespace swage::tools::test
