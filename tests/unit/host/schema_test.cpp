// SPDX-License-Identifier: Apache-2.0
#include "host/schema.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

using namespace swage::host;
using Json = nlohmann::json;

namespace {

PluginInfo needle() {
  PluginInfo plugin;
  plugin.kind = SWAGE_KIND_OBJECT;
  plugin.id = "swage.object.needle";
  plugin.version = "1.0.0";
  plugin.name = "Suture needle";
  plugin.summary = "Rigid.";
  Param arc, radius;
  arc.type = SWAGE_PARAM_CHOICE;
  arc.id = "arc";
  arc.label = "Arc";
  arc.doc = "Share of a circle.";
  arc.choices = {"1/4", "3/8"};
  arc.default_number[0] = 1;
  radius.id = "arc_radius";
  radius.label = "Arc radius";
  radius.unit = "m";
  radius.display_unit = "mm";
  radius.doc = "Of the centre line.";
  radius.min = 0.5e-3;
  radius.max = 20e-3;
  radius.default_number[0] = 2.6e-3;
  radius.flags = SWAGE_PARAM_REQUIRED;
  radius.aliases = {"radius"};
  plugin.params = {arc, radius};
  return plugin;
}

}  // namespace

TEST(Schema, SaysWhatTheTableSays) {
  const Json s = Json::parse(params_schema(needle()));
  EXPECT_EQ(s["$schema"], "http://json-schema.org/draft-07/schema#");
  EXPECT_EQ(s["properties"]["arc"]["enum"], Json({"1/4", "3/8"}));
  EXPECT_EQ(s["properties"]["arc"]["default"], "3/8");
  EXPECT_EQ(s["properties"]["arc_radius"]["anyOf"][0]["maximum"], 20e-3);
  EXPECT_EQ(s["properties"]["arc_radius"]["default"], "2.6 mm");
  EXPECT_EQ(s["properties"]["arc_radius"]["description"], "Of the centre line.");
  EXPECT_TRUE(s["properties"].contains("radius")) << "former names complete too";
  EXPECT_EQ(s["required"], Json({"arc_radius"}));
  EXPECT_EQ(s["additionalProperties"], false);
}

TEST(Schema, ItsPatternTakesWhatTheReaderTakes) {
  const Json s = Json::parse(params_schema(needle()));
  const std::string pattern = s["properties"]["arc_radius"]["anyOf"][1]["pattern"];
  for (const char* good : {"2.6 mm", "2.6mm", "-1e-3 m", ".5 um"})
    EXPECT_THAT(good, testing::MatchesRegex(pattern)) << good;
  for (const char* bad : {"2.6", "2.6 N", "mm", "2.6 mmm"})
    EXPECT_THAT(bad, testing::Not(testing::MatchesRegex(pattern))) << bad;
}

TEST(Schema, ALessonsPluginDecidesAboutItsParameters) {
  const Json s = Json::parse(lesson_schema({needle()}));
  const Json& object = s["properties"]["objects"]["items"];
  EXPECT_EQ(object["properties"]["plugin"]["enum"], Json({"swage.object.needle"}));
  EXPECT_EQ(object["allOf"][0]["then"]["properties"]["params"]["$ref"], "#/definitions/swage.object.needle");
  EXPECT_TRUE(s["definitions"].contains("swage.object.needle"));
  EXPECT_EQ(s["properties"]["couplings"]["items"]["properties"]["plugin"]["enum"], Json::array());
  EXPECT_EQ(s["properties"]["reset"]["required"], Json({"label"}));
}
