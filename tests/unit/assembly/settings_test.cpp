// SPDX-License-Identifier: Apache-2.0
//
// One lesson, many variants: values set from outside end in the text that is assembled and recorded.
#include "assembly/settings.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "assembly/sentences.hpp"
#include "host/nearest.hpp"

namespace swage::assembly {
namespace {

using Json = nlohmann::ordered_json;

const std::string kLesson = R"({
  "seed": 1,
  "devices": [ { "name": "hand", "plugin": "swage.device.mouse", "or": [
      { "as": "expert", "plugin": "x", "params": { "tremor": 0 } }, { "as": "novice", "plugin": "x", "params": { "tremor": 1 } } ] } ],
  "objects": [ { "name": "needle", "plugin": "swage.object.needle", "params": { "arc": "3/8" } }, { "name": "tray", "plugin": "y" } ],
  "couplings": [ { "plugin": "swage.coupling.grasp" } ],
  "lesson": { "plugin": "z", "params": {} } })";

Json with(const std::vector<std::string>& texts, base::Problems& problems) {
  std::vector<Setting> settings(texts.size());
  for (size_t i = 0; i < texts.size(); ++i) EXPECT_TRUE(parse_setting(texts[i], settings[i]));
  Json file = Json::parse(kLesson);
  std::vector<std::string> pointers;
  for (const Setting& setting : settings)
    if (!set_in(file, setting, "l.json", problems, pointers)) return Json();
  return file;
}

TEST(Settings, GoWhereTheirNameSays) {
  base::Problems problems;
  const Json file = with({"needle.arc=2/8", "tray.size=[\"1 mm\", 2, 3]", "lesson.drive=0.4",
                          "grasp.balance=0.2", "seed=7", "hand.tremor=\"15 um\"", "hand.start=[0, 0, 0]"},
                         problems);
  EXPECT_TRUE(problems.empty());
  EXPECT_EQ(file["objects"][0]["params"]["arc"], "2/8");
  EXPECT_EQ(file["objects"][1]["params"]["size"], Json({"1 mm", 2, 3}));
  EXPECT_EQ(file["lesson"]["params"]["drive"], 0.4);
  EXPECT_EQ(file["couplings"][0]["params"]["balance"], 0.2);
  EXPECT_EQ(file["seed"], 7);
  // alternatives that know a parameter get it, and only they
  EXPECT_EQ(file["devices"][0]["or"][0]["params"]["tremor"], "15 um");
  EXPECT_EQ(file["devices"][0]["or"][1]["params"]["tremor"], "15 um");
  EXPECT_EQ(file["devices"][0]["params"], Json({{"start", {0, 0, 0}}}));
}

TEST(Settings, ReachASecondCouplingOfOnePluginByItsNumber) {
  Json file = Json::parse(R"({ "couplings": [ { "plugin": "p.touch" }, { "plugin": "p.touch" }, { "name": "touch_3", "plugin": "p.touch" },
                               { "plugin": "p.touch" }, 7 ] })");
  EXPECT_EQ(coupling_names(file), (std::vector<std::string>{"touch", "touch_2", "touch_3", "touch_4", ""}));
  base::Problems problems;
  std::vector<std::string> pointers;
  ASSERT_TRUE(set_in(file, {"touch_4.friction", "0.2"}, "l.json", problems, pointers));
  EXPECT_EQ(file["couplings"][3]["params"]["friction"], 0.2);
  EXPECT_EQ(pointers, std::vector<std::string>{"/couplings/3/params/friction"});
}

// a base lesson may hold anything anywhere; whoever bases another on it gets a sentence
TEST(Settings, MeetWrongTypesWithASentence) {
  for (const char* text :
       {R"({"lesson": 3})", R"({"lesson": []})", R"({"lesson": {"params": [1]}})", R"({"lesson": {"params": null}})",
        R"({"objects": {"name": "lesson"}})", R"({"objects": [{"name": 3, "plugin": 4}]})", R"({"couplings": [{"plugin": {}}]})",
        R"({"devices": [{"name": "x", "params": 3, "or": 4}]})", R"({"devices": [{"name": "x", "or": [3, {"params": []}]}]})"}) {
    for (const char* what : {"lesson.drive", "x.y", "touch.friction"}) {
      Json file = Json::parse(text);
      base::Problems problems;
      std::vector<std::string> pointers;
      const bool set = set_in(file, {what, "1"}, "l.json", problems, pointers);
      EXPECT_EQ(set, problems.empty()) << text << " " << what;
      EXPECT_EQ(set, !pointers.empty()) << text << " " << what;
    }
  }
}

TEST(Settings, AreRefusedWithASentence) {
  Setting setting;
  EXPECT_FALSE(parse_setting("needle.arc", setting));
  EXPECT_FALSE(parse_setting("=3", setting));
  base::Problems problems;
  EXPECT_TRUE(with({"needel.arc=2/8"}, problems).is_null());
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].message,
            say::kNobodyToSet("needel", "needel.arc", host::did_you_mean("needel", {"needle"}), "needle, tray, grasp, hand, lesson"));
}

}  // namespace
}  // namespace swage::assembly
