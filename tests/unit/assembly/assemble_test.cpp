// SPDX-License-Identifier: Apache-2.0
#include "assembly/assemble.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "../../catalogue.hpp"
#include "assembly/sentences.hpp"
#include "base/rng.hpp"
#include "host/nearest.hpp"
#include "host/sentences.hpp"
#include "judge/host_events.hpp"
#include "test_places.hpp"

using namespace swage;
namespace say = assembly::say;
using scene::kNone;
using testing::ElementsAre;
using testing::IsEmpty;

namespace {

const host::Catalogue& catalogue() {
  static const host::Catalogue& found = test::make_catalogue(SWAGE_BINARY_DIR "/tests/assembly_plugins");
  return found;
}

const char* const kRequires =
    R"("requires": {"org.example.ball": "^1", "org.example.tool": "^1", "org.example.finds": "^1",
  "org.example.looks": "^1", "org.example.pad": "^1", "org.example.pen": "^1", "org.example.watch": "^1"},)";

struct Made {
  std::unique_ptr<host::Rig> rig;
  std::vector<std::string> said;
};

Made make(const std::string& body, const assembly::Overrides& overrides = {}, const char* required = "") {
  base::Problems problems;
  assembly::LessonFile file;
  Made made;
  assembly::parse_lesson(R"({"format": "swage-lesson/1", "id": "org.example.l", "title": "T", "seed": 5,)" +
                             std::string(required) + body + "}",
                         "a.json", file, problems);
  made.rig = assembly::assemble(file, catalogue(), overrides, problems);
  const std::string advice = "Add to \"requires\"";
  for (const auto& p : problems)
    if (*required != 0 || p.message.find(advice) == std::string::npos)
      made.said.push_back(p.where + ": " + p.message);
  return made;
}

const char* const kScene = R"(
  "devices": [{"name": "hand", "plugin": "org.example.pad", "motion_scale": 10, "force_scale": 2,
               "pose": {"p": ["5 mm", 0, 0]},
               "or": [{"as": "expert", "plugin": "org.example.pen", "params": {"speed": 2}}]}],
  "objects": [
    {"name": "tool", "plugin": "org.example.tool", "follows": {"pose": "hand", "closure": "hand"},
     "pose": {"p": [0, 0, "10 mm"]}},
    {"name": "ball", "plugin": "org.example.ball", "params": {"radius": "2 mm"}},
    {"name": "other", "plugin": "org.example.ball"}],
  "couplings": [
    {"plugin": "org.example.looks", "between": ["tool", "ball"]},
    {"plugin": "org.example.finds", "between": ["tool", "ball"]},
    {"plugin": "org.example.finds", "between": ["tool", "other"]}],
  "lesson": {"plugin": "org.example.watch", "params": {"arc_of": "tool"}})";

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

}  // namespace

TEST(Assemble, ObjectsOwnTheirPartOfTheWorld) {
  const Made m = make(kScene);
  ASSERT_NE(m.rig, nullptr);
  EXPECT_THAT(m.said, IsEmpty());
  const auto& world = m.rig->world;
  const auto& tool = m.rig->objects[0];
  const auto& other = m.rig->objects[2];
  EXPECT_EQ(tool.body.count, 2u);
  EXPECT_EQ(tool.hinge.count, 1u);
  EXPECT_EQ(tool.particle.count, 3u);
  EXPECT_EQ(other.body.first, 3u);
  EXPECT_EQ(other.state.first, 2u);
  EXPECT_EQ(other.signal.first, 1u);
  EXPECT_EQ(world.body[3].object, 2u);
  EXPECT_EQ(world.shape[other.shape.first].body, 3u);
  EXPECT_EQ(world.X_WB[1].p.z, 11e-3) << "placed by the lesson file";
  EXPECT_EQ(world.particle_p_W[2], 10e-3);
  EXPECT_EQ(world.shape[m.rig->objects[1].shape.first].radius, 2e-3);
  EXPECT_EQ(world.dt, 1e-3);
  EXPECT_TRUE(tool.instance->active());
}

TEST(Assemble, EveryInstanceButDevicesHasItsRandomStreamInTheState) {
  const Made m = make(kScene);
  ASSERT_NE(m.rig, nullptr);
  std::vector<uint64_t> expected;
  for (const host::Instance* instance : host::instances(*m.rig))
    if (instance->name != "hand") expected.push_back(base::stream_seed(5, instance->name));
  EXPECT_EQ(m.rig->world.random, expected);
}

TEST(Assemble, ThoseThatDetectMakePairsAndThoseThatLookShareThem) {
  const Made m = make(kScene);
  ASSERT_NE(m.rig, nullptr);
  ASSERT_EQ(m.rig->pairs.size(), 2u);
  EXPECT_EQ(m.rig->pairs[1].object_b, 2u);
  EXPECT_EQ(m.rig->couplings[0].pair, 0u) << "looks, though it stands first in the file";
  EXPECT_EQ(m.rig->couplings[1].pair, 0u);
  EXPECT_EQ(m.rig->couplings[2].pair, 1u);
  EXPECT_EQ(m.rig->couplings[2].instance->name, "finds_2");
}

TEST(Assemble, TheScriptNamesEverythingOnce) {
  const Made m = make(kScene);
  ASSERT_NE(m.rig, nullptr);
  const judge::Script& script = m.rig->script;
  ASSERT_EQ(script.signals.size(), m.rig->world.signal.size());
  EXPECT_EQ(script.signals[0].owner, "ball");
  EXPECT_EQ(script.signals[2].owner, "looks");
  EXPECT_EQ(script.events[0].id, "looks.seen");
  EXPECT_EQ(script.events[1].owner, judge::kHostOwner);
  EXPECT_EQ(m.rig->lesson.event.first, 1 + judge::kHostEventCount);
  EXPECT_EQ(script.events[m.rig->lesson.event.first].id, "watch.done");
  EXPECT_EQ(script.metrics[0].id, "watch.time");
  ASSERT_EQ(script.marks.size(), 2u);
  EXPECT_EQ(script.marks[0].meaning, "region.target");
  EXPECT_EQ(script.marks[0].mark.object, 0u);
  EXPECT_EQ(script.marks[0].mark.number[0], 0.5);
  EXPECT_EQ(m.rig->card.script.marks[1].meaning, "target.point");
}

TEST(Assemble, TheCardShowsTheScene) {
  const Made m = make(kScene);
  ASSERT_NE(m.rig, nullptr);
  const snapshot::SceneCard& card = m.rig->card;
  EXPECT_EQ(card.title, "T");
  EXPECT_EQ(card.seed, 5u);
  EXPECT_EQ(card.objects[0].plugin_version, "1.2.3");
  EXPECT_THAT(card.objects[0].traits, ElementsAre(SWAGE_TRAIT_SOLID));
  EXPECT_EQ(card.devices[0].plugin, "org.example.pad");
  EXPECT_EQ(card.start.size(), m.rig->world.body.size());
  ASSERT_EQ(card.motion.size(), card.start.size());
  for (size_t i = 0; i < card.motion.size(); ++i) EXPECT_EQ(card.motion[i], m.rig->world.body[i].motion);
  ASSERT_EQ(card.shapes.size(), m.rig->world.shape.size());
  EXPECT_EQ(card.shapes[1].vertex.size(), 4u);
  EXPECT_EQ(card.shapes[1].face.size(), 4u);
  EXPECT_EQ(card.shapes[1].face[0].size(), 3u);
}

TEST(Assemble, DevicesScaleUnlessTheySpeakInTheWorld) {
  const Made pad = make(kScene), pen = make(kScene, {"expert", ""});
  ASSERT_TRUE(pad.rig && pen.rig);
  EXPECT_EQ(pad.rig->devices[0].motion_scale, 10);
  EXPECT_EQ(pad.rig->devices[0].force_scale, 2);
  EXPECT_EQ(pad.rig->devices[0].X_WD0.p.x, 5e-3);
  EXPECT_EQ(pad.rig->objects[0].follow.pose_device, 0u);
  EXPECT_EQ(pad.rig->objects[1].follow.pose_device, kNone);
  EXPECT_EQ(pen.rig->devices[0].instance->plugin_id, "org.example.pen");
  EXPECT_EQ(pen.rig->devices[0].instance->values[0].number[0], 2) << "parameters of the choice";
  EXPECT_EQ(pen.rig->devices[0].motion_scale, 1);
  EXPECT_EQ(pen.rig->devices[0].force_scale, 0);
  EXPECT_EQ(pen.rig->devices[0].X_WD0.p.x, 0);
}

TEST(Assemble, OverridesChooseByNameIdOrLastWord) {
  for (const char* device : {"expert", "pen", "org.example.pen"})
    EXPECT_EQ(make(kScene, {device, ""}).rig->card.devices[0].plugin, "org.example.pen") << device;
  const Made fast = make(kScene, {"pen", R"({"speed": 3})"});
  EXPECT_EQ(fast.rig->devices[0].instance->values[0].number[0], 3);
  EXPECT_THAT(
      make(kScene, {"pen", R"({"sped": 3})"}).said,
      ElementsAre(
          "--device-params #/sped: " + host::say::kNoSuchParam("org.example.pen", host::did_you_mean("sped", {"speed"}), host::say::kHas("speed"))));
  EXPECT_THAT(
      make(kScene, {"exprt", ""}).said,
      ElementsAre(
          "a.json:2 #/devices: " + say::kNoDevice("exprt", host::did_you_mean("exprt", {"expert"}), "expert, pad, pen")));
}

TEST(Assemble, AnInstalledDeviceMayReplaceTheLessonsOwn) {
  const std::string one = replaced(kScene, R"("org.example.pad", "motion_scale": 10, "force_scale": 2,
               "pose": {"p": ["5 mm", 0, 0]},
               "or": [{"as": "expert", "plugin": "org.example.pen", "params": {"speed": 2}}])",
                                   R"("org.example.pad")");
  const Made pen = make(one, {"pen", ""});
  ASSERT_NE(pen.rig, nullptr);
  EXPECT_EQ(pen.rig->card.devices[0].plugin, "org.example.pen");
  EXPECT_EQ(pen.rig->devices[0].instance->values[0].number[0], 1) << "its defaults";
}

TEST(Assemble, WhatIsNotInstalledGivesWayToWhatIs) {
  const Made m = make(replaced(kScene, "org.example.pad", "org.example.haptic"));
  ASSERT_NE(m.rig, nullptr);
  EXPECT_THAT(
      m.said,
      ElementsAre("a.json:2 #/devices/0/plugin: " + say::kReplaced("org.example.haptic", "hand", "org.example.pen")));
}

TEST(Assemble, LessonsWithoutDevicesRunWithAnyHand) {
  const Made m = make(R"("objects": [{"name": "ball", "plugin": "org.example.ball"}],
                         "lesson": {"plugin": "org.example.watch"})",
                      {"expert", ""});
  EXPECT_NE(m.rig, nullptr);
  EXPECT_THAT(m.said, ElementsAre("a.json: " + say::kNoDevices("expert")));
}

TEST(Assemble, RequirementsAreComparedWithWhatIsThere) {
  EXPECT_THAT(make(kScene, {}, kRequires).said, IsEmpty());
  const std::string newer =
      replaced(kRequires, R"("org.example.tool": "^1")", R"("org.example.tool": "^1.3")");
  EXPECT_THAT(
      make(kScene, {}, newer.c_str()).said,
      ElementsAre(
          "a.json:1 #/requires/org.example.tool: " + say::kOtherVersion("org.example.tool", "1.2.3", "^1.3")));
  const std::string fewer = replaced(kRequires, R"("org.example.tool": "^1", )", "");
  const Made told = make(kScene, {}, fewer.c_str());
  EXPECT_NE(told.rig, nullptr) << "a warning, no error";
  EXPECT_THAT(told.said,
              ElementsAre("a.json:1 #/requires: " + say::kNotRequired("org.example.tool", "org.example.tool", "1.2")));
}

TEST(Assemble, MarksAreChecked) {
  EXPECT_THAT(make(replaced(kScene, R"("arc_of": "tool")", R"("arc_of": "ball")")).said,
              ElementsAre("a.json:14 #/lesson: " + say::kArcMarkOf("ball")));
  EXPECT_THAT(make(replaced(kScene, R"("arc_of": "tool")", R"("arc_of": "nobody")")).said,
              ElementsAre("a.json:14 #/lesson: " + say::kMarkOfNobody(4294967295u)));
  EXPECT_THAT(
      make(replaced(kScene, R"("arc_of": "tool")", R"("arc_of": "tool", "from": "95 %")")).said,
      ElementsAre("a.json:14 #/lesson: " + say::kArcMarkRange()));
}

TEST(Assemble, TooManyObjectsAreRefused) {
  std::string objects;
  for (int i = 0; i < 33; ++i)
    objects += std::string(i > 0 ? "," : "") + R"({"plugin": "org.example.ball", "name": "b)" +
               std::to_string(i) + "\"}";
  EXPECT_THAT(make("\"objects\": [" + objects + R"(], "lesson": {"plugin": "org.example.watch"})").said,
              ElementsAre("a.json:1 #/objects: " + say::kManyObjects(32, 33)));
}

TEST(Assemble, TheRigOutlivesNothingItNeeds) {
  Made m = make(kScene);
  ASSERT_NE(m.rig, nullptr);
  const swage_scene_card& card = m.rig->bound.card;
  EXPECT_EQ(card.n_object, 3u);
  EXPECT_EQ(std::string(card.object[1].name.data, card.object[1].name.size), "ball");
  EXPECT_EQ(card.signal[2].owner.size, 5u);
  EXPECT_EQ(card.n_event, 2 + judge::kHostEventCount);
  m.rig.reset();
}
