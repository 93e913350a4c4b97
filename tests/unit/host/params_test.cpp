// SPDX-License-Identifier: Apache-2.0
#include "host/params.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "../../temp_folder.hpp"
#include "host/nearest.hpp"
#include "host/params_json.hpp"
#include "host/sentences.hpp"
#include "host/units.hpp"

using namespace swage::host;
using swage::base::Problems;
using swage::base::Severity;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

Param real(const char* id, const char* label, double min, double max, double value) {
  Param p;
  p.id = id;
  p.label = label;
  p.unit = "m";
  p.display_unit = "mm";
  p.doc = "A length.";
  p.min = min;
  p.max = max;
  p.default_number[0] = value;
  return p;
}

ParamTable needle_table() {
  Param arc;
  arc.type = SWAGE_PARAM_CHOICE;
  arc.id = "arc";
  arc.label = "Arc";
  arc.doc = "Share of a circle.";
  arc.choices = {"1/4", "3/8", "1/2"};
  arc.default_number[0] = 1;
  Param wire = real("wire_diameter", "Wire diameter", 0.03e-3, 1e-3, 0.1e-3);
  wire.aliases = {"thickness"};
  return {arc, real("arc_radius", "Arc radius", 0.5e-3, 20e-3, 2.6e-3), wire};
}

Param typed(int32_t type, const char* id) {
  Param p;
  p.type = type;
  p.id = id;
  p.label = id;
  p.unit = p.display_unit = "1";
  p.doc = "Doc.";
  p.min = -10;
  p.max = 10;
  return p;
}

struct Checked {
  bool good;
  ParamValues values;
  std::vector<std::string> said;  // "E /pointer: message"
};

Checked check(const ParamTable& table, const char* json, const std::string& folder = "/") {
  Checked out;
  Problems problems;
  const ParamSource source{"swage.object.needle", folder, "", [](const std::string& p) { return p; }};
  out.good = check_params(json, table, source, out.values, problems);
  for (const auto& p : problems)
    out.said.push_back(std::string(p.severity == Severity::kError ? "E " : "W ") + p.where + ": " +
                       p.message);
  return out;
}

}  // namespace

TEST(Params, ConvertsAndFillsDefaults) {
  const Checked c = check(needle_table(), R"({"arc": "1/2", "arc_radius": "3 mm"})");
  EXPECT_THAT(c.said, IsEmpty());
  ASSERT_TRUE(c.good);
  EXPECT_EQ(c.values.value[0].number[0], 2);
  EXPECT_EQ(c.values.value[1].number[0], 3e-3);
  EXPECT_EQ(c.values.value[2].number[0], 0.1e-3) << "the default";
}

TEST(Params, PlainNumbersAreSi) {
  EXPECT_EQ(check(needle_table(), R"({"arc_radius": 0.0026})").values.value[1].number[0], 0.0026);
}

TEST(Params, EverythingWrongIsToldAtOnce) {
  const Checked c = check(needle_table(), R"({
    "arc": "3/9", "arc_raduis": "3 mm", "arc_radius": "3 m", "wire_diameter": "0.1 N", "colour": 1 })");
  EXPECT_FALSE(c.good);
  EXPECT_THAT(
      c.said,
      ElementsAre(
          "E /arc: " + say::kOtherType("Arc", say::kOneOf(join({"1/4", "3/8", "1/2"}, true)), "\"3/9\"") + did_you_mean("3/9", {"3/8"}),
          "E /arc_raduis: " + say::kNoSuchParam("swage.object.needle", did_you_mean("arc_raduis", {"arc_radius"}), say::kHas("arc, arc_radius, wire_diameter")),
          "E /arc_radius: " + say::kOutOfRange("\"3 m\"", "Arc radius", "0.5 mm", "20 mm"),
          "E /wire_diameter: " + say::kOtherDimension("0.1 N", "a force", "Wire diameter", measure_of("m")),
          "E /colour: " + say::kNoSuchParam("swage.object.needle", "", say::kHas("arc, arc_radius, wire_diameter"))));
}

TEST(Params, FormerNamesWarnWithTheLineToPaste) {
  const Checked c = check(needle_table(), R"({"thickness": "0.2 mm"})");
  EXPECT_TRUE(c.good);
  EXPECT_THAT(c.said, ElementsAre("W /thickness: " + say::kFormerName("thickness", "wire_diameter", "wire_diameter", "\"0.2 mm\"")));
  EXPECT_DOUBLE_EQ(c.values.value[2].number[0], 0.2e-3);
  EXPECT_THAT(check(needle_table(), R"({"wire_diameter": "0.1 mm", "thickness": "0.2 mm"})").said[1],
              "E /thickness: " + say::kGivenTwice("wire_diameter"));
}

TEST(Params, RangesHoldTheirEnds) {
  for (const char* json :
       {R"({"arc_radius": "20 mm"})", R"({"arc_radius": "0.5 mm"})", R"({"arc_radius": 0.02})"}) {
    const Checked c = check(needle_table(), json);
    EXPECT_TRUE(c.good) << json;
    EXPECT_LE(c.values.value[1].number[0], 20e-3) << "rounding must not carry a value over the end";
  }
  EXPECT_FALSE(check(needle_table(), R"({"arc_radius": "20.001 mm"})").good);
}

TEST(Params, EachTypeRefusesTheOthers) {
  ParamTable table = {typed(SWAGE_PARAM_BOOL, "on"), typed(SWAGE_PARAM_INTEGER, "count"),
                      typed(SWAGE_PARAM_TEXT, "text"), typed(SWAGE_PARAM_VECTOR, "range"),
                      real("size", "Size", 0, 1, 0.5)};
  table[3].dimension = 2;
  EXPECT_TRUE(
      check(table, R"({"on": true, "count": 3, "text": "a", "range": [0.1, "50 %"], "size": 0.1})").good);
  EXPECT_THAT(check(table, R"({"on": 1})").said, ElementsAre("E /on: " + say::kOtherType("on", say::kFlag(), "1")));
  EXPECT_THAT(check(table, R"({"count": 2.5})").said,
              ElementsAre("E /count: " + say::kOtherType("count", say::kWhole(), "2.5")));
  EXPECT_THAT(check(table, R"({"text": 3})").said, ElementsAre("E /text: " + say::kOtherType("text", say::kText(), "3")));
  EXPECT_THAT(check(table, R"({"range": [1]})").said,
              ElementsAre("E /range: " + say::kOtherType("range", say::kNumbers(2, ""), "[1]")));
  EXPECT_THAT(check(table, R"({"range": [1, "2 mm"]})").said,
              ElementsAre("E /range/1: " + say::kOtherDimension("2 mm", "a length", "range", measure_of("1"))));
  EXPECT_THAT(check(table, R"({"size": true})").said,
              ElementsAre("E /size: " + say::kOtherType("Size", measure_of("m"), "true")));
  EXPECT_THAT(check(table, R"([1])").said,
              ElementsAre("E : " + say::kParamsNoObject("[1]")));
  EXPECT_THAT(check(table, R"({)").said, ElementsAre("E : " + say::kParamsNoJson("{")));
}

TEST(Params, RequiredOnesMustBeThere) {
  ParamTable table = needle_table();
  table[1].flags = SWAGE_PARAM_REQUIRED;
  EXPECT_THAT(check(table, "{}").said,
              ElementsAre("E : " + say::kNeedsParam("swage.object.needle", "arc_radius", measure_of("m"), "A length.")));
  EXPECT_TRUE(check(table, R"({"arc_radius": "1 mm"})").good);
}

TEST(Params, PluginsWithoutParametersWork) {
  EXPECT_TRUE(check({}, "{}").good);
  EXPECT_TRUE(check({}, "").good);
  EXPECT_THAT(check({}, R"({"a": 1})").said,
              ElementsAre("E /a: " + say::kNoSuchParam("swage.object.needle", "", say::kHasNone())));
}

TEST(Params, FilesAreFoundBesideTheLesson) {
  const swage::test::TempFolder own;
  const std::string& folder = own.path();
  std::ofstream(folder + "/hand.json") << "{}";
  const ParamTable table = {typed(SWAGE_PARAM_FILE, "path")};
  const Checked c = check(table, R"({"path": "hand.json"})", folder);
  ASSERT_TRUE(c.good);
  EXPECT_EQ(c.values.text[0], folder + "/hand.json");
  EXPECT_EQ(std::string(c.values.value[0].text.data, c.values.value[0].text.size), c.values.text[0]);
  EXPECT_THAT(check(table, R"({"path": "no.json"})", folder).said,
              ElementsAre("E /path: " + say::kNoFile("path", folder + "/no.json")));
}

TEST(Params, NotesOfPeopleAreLeftAlone) {
  EXPECT_TRUE(check(needle_table(), R"({"x-why": "thin ones bend"})").good);
}

TEST(Params, TableFaultsAreFound) {
  EXPECT_THAT(table_faults(needle_table()), IsEmpty());
  ParamTable table = {real("Big", "Size", 1, 0, 0.5), real("size", "", 0, 1, 2),
                      real("size", "Size", 0, 1, 0.5)};
  table[2].unit = "mm";
  table[2].doc = "";
  EXPECT_THAT(
      table_faults(table),
      ElementsAre(
          say::kOfParam("Big", say::kNotSnakeCase()), say::kOfParam("Big", say::kEmptyRange()),
          say::kOfParam("Big", say::kDefaultOutOfRange()), say::kOfParam("size", say::kNoLabel()),
          say::kOfParam("size", say::kDefaultOutOfRange()), say::kOfParam("size", say::kIdTwice()),
          say::kOfParam("size", say::kNoDoc()),
          say::kOfParam("size", say::kNoSiUnit("mm", unit_list()))));
}

TEST(Params, TheTableSurvivesItsSidecar) {
  ParamTable table = needle_table();
  table[1].flags = SWAGE_PARAM_LIVE | SWAGE_PARAM_HIDDEN;
  table[2].flags = SWAGE_PARAM_INTERVAL;
  table[1].max = std::numeric_limits<double>::infinity();
  ParamTable back;
  ASSERT_TRUE(table_from_json(table_to_json(table), back));
  EXPECT_EQ(table_to_json(back).dump(), table_to_json(table).dump());
  EXPECT_EQ(back[1].max, table[1].max);
  EXPECT_EQ(back[1].min, 0.5e-3);
  EXPECT_TRUE(back[1].live() && back[1].hidden() && !back[1].required());
  EXPECT_EQ(back[2].flags, SWAGE_PARAM_INTERVAL);
  EXPECT_FALSE(table_from_json(nlohmann::ordered_json::parse(R"([{"id": 3}])"), back));
}

TEST(Params, ValuesAreWrittenAsLessonsSayThem) {
  const ParamTable table = needle_table();
  const ParamValues v = default_values(table);
  EXPECT_EQ(value_text(table[0], v.value[0]), "\"3/8\"");
  EXPECT_EQ(value_text(table[1], v.value[1]), "\"2.6 mm\"");
}
