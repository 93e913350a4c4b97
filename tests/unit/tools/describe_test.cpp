// SPDX-License-Identifier: Apache-2.0
#include "host/sentences.hpp"
#include "program.hpp"
#include "step/sentences.hpp"
#include "test_places.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;
using testing::Not;
using Describe = Program;

const std::string kNeedle = "swage.object.needle";

TEST_F(Describe, ListsWhatIsInstalled) {
  const Said said = swage({"describe"});
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.out, HasSubstr("object    swage.object.needle"));
  EXPECT_THAT(said.out, HasSubstr("coupling  swage.coupling.grasp"));
  EXPECT_THAT(said.out, HasSubstr("device    swage.device.mouse"));
  EXPECT_THAT(said.out, HasSubstr("lesson    swage.lesson.grasp"));
}

TEST_F(Describe, TellsAPluginAndItsParameters) {
  const Said said = swage({"describe", kNeedle});
  EXPECT_EQ(said.code, 0);
  EXPECT_THAT(said.out, HasSubstr("swage.object.needle 1.0.0 (object): Suture needle\n"));
  EXPECT_THAT(said.out, HasSubstr("offers swage.trait.solid/1, swage.trait.graspable/1"));
  EXPECT_THAT(said.out, HasSubstr("wire_diameter        \"0 um\"         0 um to 1000 um"));
  EXPECT_THAT(said.out, Not(HasSubstr("swage.object.jaws")));
}

TEST_F(Describe, TellsWhatALessonMeasuresAndSignals) {
  const Said said = swage({"describe", "swage.lesson.grasp"});
  EXPECT_THAT(said.out, HasSubstr("grasp.tries          1     lower is better   Closings of the jaws"));
  EXPECT_THAT(said.out, HasSubstr("M06. Evidence C."));
  EXPECT_THAT(said.out, HasSubstr("grip.too_hard        The grip force is above the limit. (colour, shape, sound, force)"));
  const nlohmann::json list = swage({"describe", "swage.lesson.grasp", "--json"}).json();
  EXPECT_EQ(list[0]["metrics"][0]["id"], "time.task");
  EXPECT_EQ(list[0]["metrics"][0]["evidence"], "A");
  EXPECT_FALSE(swage({"describe", kNeedle, "--json"}).json()[0].contains("metrics"));
}

TEST_F(Describe, TellsTheRoleOfACue) {
  const std::string bundle = SWAGE_BINARY_DIR "/tests/bad_plugins/bundles_roles/org.example.bad.roles.target";
  EXPECT_THAT(swage({"describe", bundle}).out, HasSubstr("lamp.lit             The lamp is lit. (colour, shape; target)"));
  EXPECT_EQ(swage({"describe", bundle, "--json"}).json()[0]["cues"][0]["role"], "target");
  EXPECT_EQ(swage({"describe", "swage.lesson.grasp", "--json"}).json()[0]["cues"][0]["role"], "");
}

// what a lesson may watch of an object and of a coupling
TEST_F(Describe, TellsTheSignalsAndEventsOfObjectsAndCouplings) {
  const Said jaws = swage({"describe", "swage.object.jaws"}), grasp = swage({"describe", "swage.coupling.grasp"});
  EXPECT_THAT(jaws.out, HasSubstr("  [Signals]\n  jaws.opening         rad   Angle between the jaws.\n"));
  EXPECT_THAT(jaws.out, Not(HasSubstr("[Events]"))) << "an object has none";
  EXPECT_THAT(grasp.out, HasSubstr("  grasp.force          N     Grip: mean of the two jaws' forces along the closing direction.\n"));
  EXPECT_THAT(grasp.out, HasSubstr("  grasp.taken          1     Both jaws hold it; value: where, 0 at the point and 1 at the swage.\n"));

  const nlohmann::json object = swage({"describe", "swage.object.jaws", "--json"}).json()[0];
  const nlohmann::json coupling = swage({"describe", "swage.coupling.grasp", "--json"}).json()[0];
  EXPECT_EQ(object["signals"][0], nlohmann::json({{"id", "jaws.opening"}, {"unit", "rad"}, {"doc", "Angle between the jaws."}}));
  EXPECT_EQ(coupling["signals"][1]["id"], "grasp.force");
  EXPECT_EQ(coupling["signals"][1]["unit"], "N");
  EXPECT_EQ(coupling["events"][1]["id"], "grasp.taken");
  EXPECT_EQ(coupling["events"].size(), 6u);
}

// in the scene of a lesson: what it declares there, and what starts inside what
TEST_F(Describe, InTheSceneOfALesson) {
  const std::string starts = step::say::kStartsInside.words(0) + "ring" + step::say::kStartsInside.words(1);
  for (const char* plugin : {"swage.lesson.look", "swage.coupling.contact"}) {
    const Said inside = swage({"describe", plugin, "--with", write_two_solids("0.4 mm")});
    EXPECT_EQ(inside.code, 0) << inside.err;
    EXPECT_THAT(inside.out, HasSubstr("  [At the start]\n  " + starts)) << plugin;
    EXPECT_THAT(inside.out, testing::ContainsRegex("[0-9.]+" + step::say::kStartsInside.words(2) + "hook"));
  }
  const nlohmann::json contact = swage({"describe", "swage.coupling.contact", "--with", write_two_solids("0.4 mm"), "--json"}).json()[0];
  EXPECT_EQ(contact["signals"][0]["id"], "contact.force");
  EXPECT_EQ(contact["overlaps"].size(), 1u);
  EXPECT_EQ(swage({"describe", "swage.coupling.contact", "--with", write_two_solids("20 mm"), "--json"}).json()[0]["overlaps"].size(), 0u);
  EXPECT_FALSE(swage({"describe", "swage.coupling.contact", "--json"}).json()[0].contains("overlaps"));

  // a plugin that the lesson does not use, and a file that is no lesson
  EXPECT_THAT(swage({"describe", kNeedle, "--with", write_two_solids("20 mm")}).out, HasSubstr("Its signals and events are not known here"));
  write("none.json", "{}");
  const Said none = swage({"describe", kNeedle, "--with", path("none.json")});
  EXPECT_EQ(none.code, 2);
  EXPECT_THAT(none.err, HasSubstr("none.json"));
}

TEST_F(Describe, AsMarkdownJsonAndSchema) {
  const Said table = swage({"describe", kNeedle, "--markdown"});
  EXPECT_THAT(table.out,
              testing::StartsWith("| Parameter | Default | Range | Meaning |\n| --- | --- | --- | --- |\n"));
  EXPECT_THAT(table.out, HasSubstr("\n| `wire_diameter` | \"0 um\" | 0 um to 1000 um | "));

  const nlohmann::json list = swage({"describe", kNeedle, "--json"}).json();
  ASSERT_EQ(list.size(), 1u);
  EXPECT_EQ(list[0]["kind"], "object");
  EXPECT_EQ(list[0]["params"].size(), 15u);
  EXPECT_GT(swage({"describe", "--json"}).json().size(), 9u);

  const nlohmann::json one = swage({"describe", kNeedle, "--schema"}).json();
  EXPECT_TRUE(one["properties"].contains("wire_diameter"));
  const nlohmann::json whole = swage({"describe", "--schema"}).json();
  EXPECT_EQ(whole["$id"], "swage-lesson/1");
  EXPECT_TRUE(whole["properties"].contains("objects"));
}

TEST_F(Describe, TakesABundleOrALibrary) {
  const std::string bundle = std::string(SWAGE_BINARY_DIR) + "/plugins/" + kNeedle;
  for (const std::string& what : {bundle, bundle + "/" + kNeedle + ".so"}) {
    const Said said = swage({"describe", what});
    EXPECT_EQ(said.code, 0) << said.err;
    EXPECT_THAT(said.out, HasSubstr("Suture needle"));
  }
  write("broken.so", "this is no library");
  const Said said = swage({"describe", path("broken.so")});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(said.err, HasSubstr(say::kNoPluginIn(path("broken.so"))));
}

TEST_F(Describe, AnUnknownPluginGetsItsNearestName) {
  const Said said = swage({"describe", "swage.object.nedle"});
  EXPECT_EQ(said.code, 2);
  EXPECT_THAT(
      said.err,
      HasSubstr("error: " + host::say::kNotInstalled("swage.object.nedle") + host::say::kNearest(kNeedle, "1.0.0") + host::say::kSearched.words(0)));
  EXPECT_EQ(swage({"describe", "./no/such/bundle"}).code, 2);
}

}  // namespace
}  // namespace swage::tools::test
