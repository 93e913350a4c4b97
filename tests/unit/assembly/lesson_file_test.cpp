// SPDX-License-Identifier: Apache-2.0
#include "assembly/lesson_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "assembly/sentences.hpp"
#include "host/nearest.hpp"
#include "host/sentences.hpp"
#include "host/units.hpp"

using namespace swage;
namespace say = assembly::say;
using assembly::LessonFile;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

namespace {

struct Read {
  LessonFile file;
  std::vector<std::string> said;
  explicit Read(const std::string& text) {
    base::Problems problems;
    const bool whole = assembly::parse_lesson(text, "a.json", file, problems);
    EXPECT_EQ(whole, !base::failed(problems));
    EXPECT_EQ(whole, !file.faulty);
    for (const auto& p : problems) said.push_back(p.where + ": " + p.message);
  }
};

// a lesson with more of it
Read with(const std::string& more) {
  return Read(
      R"({"format": "swage-lesson/1", "id": "a", "title": "A", "objects": [{"name": "o", "plugin": "p.q"}],
"lesson": {"plugin": "p.l"}, )" +
      more + "}");
}

}  // namespace

// twenty thousand of anything are told quickly and in short
TEST(LessonFile, CountsAreCapped) {
  const auto many = [](std::size_t n, const std::function<std::string(std::size_t)>& one) {
    std::string out;
    for (std::size_t i = 0; i < n; ++i) out += (i > 0 ? "," : "") + one(i);
    return out;
  };
  const std::string coupling = R"({"plugin": "p.c", "between": ["o", "o"]})";
  EXPECT_THAT(with("\"couplings\": [" + many(3000, [&](std::size_t) { return coupling; }) + "]").said,
              ElementsAre("a.json:2 #/couplings: " + say::kTooMany("couplings", 128, 3000)));
  EXPECT_THAT(with("\"couplings\": [" + many(20'000, [&](std::size_t) { return coupling; }) + "]").said,
              ElementsAre("a.json: " + say::kTooMuch()));
  const Read keys = with(many(10'000, [](std::size_t i) { return "\"k" + std::to_string(i) + "\": 1"; }));
  ASSERT_EQ(keys.said.size(), 21u);
  EXPECT_EQ(keys.said.back(), "a.json: " + say::kMoreKeys(9980));
  EXPECT_EQ(with("\"cues\": [" + many(100, [](std::size_t) { return "3"; }) + "]," +
                 "\"objects_\": [" + many(5000, [](std::size_t) { return "{}"; }) + "]").said.size(), 101u);
  EXPECT_THAT(with("\"" + std::string(300, 'k') + "\": 1").said.size(), 1u);
}

TEST(LessonFile, SaysWhatIsWrongWithFiltersAndReactions) {
  const auto said = [](const std::string& device) {
    const Read r(R"({"format": "swage-lesson/1", "id": "org.example.l", "title": "T", "devices": [{"name": "hand", "plugin": "p.q", )" + device +
                 R"(}], "objects": [], "couplings": [], "lesson": {"plugin": "p.l"}})");
    return r.said.empty() ? std::string() : r.said.front();
  };
  EXPECT_EQ(said(R"("filters": {"low_pass": "10 Hz"}, "reaction": {"law": "quadratic", "from": "0.2 N"})"), "");
  EXPECT_EQ(said(R"("coupling": {"stiffness": "200 N/m", "damping": "1 N*s/m"})"), "");
  EXPECT_THAT(said(R"("coupling": {"stiffness": "2000 N/m"})"), HasSubstr("stiffness"));
  EXPECT_THAT(said(R"("coupling": {"stiffness": "2 mm"})"), HasSubstr("stiffness"));
  EXPECT_THAT(said(R"("coupling": {"spring": 3})"), HasSubstr("spring"));
  EXPECT_THAT(said(R"("filters": {"clutch": [32]})"), HasSubstr(say::kNoClutch(32)));
  EXPECT_THAT(said(R"("filters": {"clutch_of": "hand"})"), HasSubstr(say::kNoButtons()));
  EXPECT_THAT(said(R"("filters": {"clutch": [1], "clutch_of": "foot"})"), HasSubstr(say::kNoSuch("device", "foot", "", "")));
  EXPECT_THAT(said(R"("filters": {"lowpass": 1})"), HasSubstr("lowpass"));
  EXPECT_THAT(said(R"("reaction": {"law": "cubic"})"), HasSubstr(say::kNoChoice("cubic", "law", "", "proportional, null zone, threshold, quadratic, table")));
  EXPECT_THAT(said(R"("reaction": {"law": "threshold"})"), HasSubstr(say::kNoForce("threshold")));
  EXPECT_THAT(said(R"("reaction": {"law": "table"})"), HasSubstr(say::kShortTable()));
  EXPECT_THAT(said(R"("reaction": {"law": "table", "table": [[0, 0], [1, 2], [1, 3]]})"), HasSubstr(say::kFallingTable()));
  EXPECT_THAT(said(R"("reaction": {"law": "table", "table": [[0, 0], ["1 mm", 2]]})"), HasSubstr(say::kNoPoint("[\"1 mm\",2]")));
  EXPECT_THAT(said(R"("reaction": {"law": "quadratic", "from": 1, "table": []})"), HasSubstr(say::kTableOfNoLaw()));
}

TEST(LessonFile, ReadsEverything) {
  const Read r(R"({
    "format": "swage-lesson/1", "id": "org.example.l", "title": "Title", "summary": "Summary.",
    "x-note": {"anything": ["goes"]}, "reset": {"label": "Neu knüpfen und legen 24", "tip": "Tip."},
    "seed": 18446744073709551615, "rate_hz": "2000 Hz", "scene_length": "2 mm",
    "gravity": ["0 m/s2", 0, -1.6], "max_time": "90 s", "requires": {"p.q": "^1.2"},
    "devices": [{"name": "hand", "plugin": "p.mouse", "motion_scale": 10, "force_scale": "50 %",
                 "pose": {"p": ["1 mm", 0, 0]},
                 "filters": {"rate": "2 Hz", "low_pass": "10 Hz", "dead_band": "0.1 mm", "dead_turn": "1 deg", "clutch": [0, 3]},
                 "reaction": {"law": "table", "table": [[0, 0], ["20 mN", "0.1 N"], [1, "0.2 N"]]},
                 "or": [{"as": "expert", "plugin": "p.script", "params": {"file": "a"}}]}],
    "objects": [{"name": "tool", "plugin": "p.q", "follows": {"pose": "hand"}, "params": {"a": "1 mm"},
                 "pose": {"rpy": ["90 deg", 0, "90 deg"]}},
                {"name": "ball", "plugin": "p.r", "pose": {"q": [0.7071, 0, 0.7071, 0]}}],
    "couplings": [{"plugin": "p.c", "between": ["tool", "ball"]}, {"plugin": "p.c", "between": ["tool", "ball"]},
                  {"name": "c_3", "plugin": "p.c", "between": ["tool", "ball"]}],
    "lesson": {"plugin": "p.l"}
  })");
  ASSERT_THAT(r.said, IsEmpty());
  const LessonFile& f = r.file;
  EXPECT_EQ(f.seed, 18446744073709551615u);
  EXPECT_EQ(f.rate_hz, 2000);
  EXPECT_EQ(f.reset_label, "Neu knüpfen und legen 24") << "24 characters, not bytes";
  EXPECT_EQ(f.reset_tip, "Tip.");
  EXPECT_EQ(f.scene_length, 2e-3);
  EXPECT_EQ(f.gravity.z, -1.6);
  EXPECT_EQ(f.max_time_s, 90);
  EXPECT_EQ(f.devices[0].motion_scale, 10);
  EXPECT_EQ(f.devices[0].force_scale, 0.5);
  EXPECT_EQ(f.devices[0].X_WD0.p.x, 1e-3);
  EXPECT_EQ(f.devices[0].filters.rate, 2);
  EXPECT_EQ(f.devices[0].filters.low_pass, 10);
  EXPECT_EQ(f.devices[0].filters.dead_band, 1e-4);
  EXPECT_NEAR(f.devices[0].filters.dead_turn, 0.0174533, 1e-6);
  EXPECT_EQ(f.devices[0].filters.clutch, 9u);
  EXPECT_EQ(f.devices[0].reaction.law, host::Law::kTable);
  ASSERT_EQ(f.devices[0].reaction.table.size(), 3u);
  EXPECT_EQ(f.devices[0].reaction.table[1].scene, 0.02);
  EXPECT_EQ(f.devices[0].reaction.table[2].hand, 0.2);
  ASSERT_EQ(f.devices[0].choices.size(), 2u);
  EXPECT_EQ(f.devices[0].choices[1].as, "expert");
  EXPECT_EQ(f.devices[0].choices[1].pointer, "/devices/0/or/0");
  EXPECT_EQ(f.devices[0].choices[1].params, R"({"file":"a"})");
  EXPECT_EQ(f.objects[0].follow_pose, "hand");
  EXPECT_EQ(f.objects[0].follow_closure, "");
  // rolled, then yawed: x goes to y, y to z
  const swage_quat q = f.objects[0].X_WO.q;
  EXPECT_NEAR(q.w, 0.5, 1e-15);
  EXPECT_NEAR(q.x, 0.5, 1e-15);
  EXPECT_NEAR(q.y, 0.5, 1e-15);
  EXPECT_NEAR(q.z, 0.5, 1e-15);
  EXPECT_NEAR(f.objects[1].X_WO.q.y, std::sqrt(0.5), 1e-15) << "made unit";
  EXPECT_EQ(f.couplings[0].name, "c");
  EXPECT_EQ(f.couplings[1].name, "c_2");
  EXPECT_EQ(f.couplings[2].name, "c_3");
  EXPECT_EQ(f.where("/objects/0/params/a"), "a.json:11 #/objects/0/params/a");
  EXPECT_EQ(f.where("/objects/0/params/missing"), "a.json:11 #/objects/0/params/missing");
  EXPECT_EQ(f.where(""), "a.json");
}

TEST(LessonFile, HasDefaults) {
  const Read r = with(R"("seed": 1)");
  ASSERT_THAT(r.said, IsEmpty());
  EXPECT_EQ(r.file.rate_hz, 1000);
  EXPECT_EQ(r.file.scene_length, 1e-3);
  EXPECT_EQ(r.file.gravity.z, -9.80665);
  EXPECT_EQ(r.file.objects[0].X_WO.q.w, 1);
}

TEST(LessonFile, NumbersHaveUnitsAndRanges) {
  EXPECT_THAT(
      with(R"("rate_hz": 50)").said,
      ElementsAre("a.json:2 #/rate_hz: " + say::kOutOfRange(50, "rate_hz", "200 Hz", "10000 Hz")));
  EXPECT_THAT(
      with(R"("scene_length": "1 s")").said,
      ElementsAre("a.json:2 #/scene_length: " + host::say::kOtherDimension("1 s", "a time", "scene_length", host::measure_of("m"))));
  EXPECT_THAT(with(R"("gravity": [0, 0])").said,
              ElementsAre("a.json:2 #/gravity: " + say::kNoVector("gravity", "[0,0]")));
  EXPECT_THAT(with(R"("gravity": [0, 0, 1e300])").said,
              ElementsAre("a.json:2 #/gravity/2: " + say::kTooLargeNumber("1e+300")));
  EXPECT_THAT(with(R"("seed": 1.5)").said,
              ElementsAre("a.json:2 #/seed: " + say::kNoWhole("seed", "1.5")));
}

TEST(LessonFile, ListsAndObjectsAreWhatTheyAre) {
  EXPECT_THAT(with(R"("couplings": {})").said,
              ElementsAre("a.json:2 #/couplings: " + say::kNoList("couplings", "{}")));
  EXPECT_THAT(
      with(R"("couplings": [3])").said,
      ElementsAre(
          "a.json:2 #/couplings/0: " + say::kNoObject("a coupling of a lesson", 3)));
  EXPECT_THAT(with(R"("requires": ["a"])").said,
              ElementsAre("a.json:2 #/requires: " + say::kNoRequirements()));
}

TEST(LessonFile, TellsWhereTheTextStopsToBeJson) {
  EXPECT_THAT(
      Read("{\n \"a\" 1}").said,
      ElementsAre(
          "a.json:2: " + say::kNotJson(6)));
  EXPECT_EQ(Read("").said.size(), 1u);
  EXPECT_EQ(Read("{\"a\": 1e999}").said.size(), 1u);
  EXPECT_THAT(Read(std::string(5 << 20, ' ')).said,
              ElementsAre("a.json: " + say::kTooLarge()));
  EXPECT_THAT(Read(std::string(200000, '[')).said,
              ElementsAre("a.json: " + say::kTooDeep()));
}

TEST(LessonFile, AMissingFileIsSaid) {
  LessonFile file;
  base::Problems problems;
  EXPECT_FALSE(assembly::read_lesson_file("/there/is/none.json", file, problems));
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0].where, "/there/is/none.json");
  EXPECT_EQ(problems[0].message, say::kNoFile());
  EXPECT_FALSE(assembly::read_lesson_file("/tmp", file, problems)) << "a folder is no file";
}

TEST(LessonFile, TheWordsOfItsResetFitAButton) {
  const auto said = [](const std::string& reset) {
    const Read r(R"({"format": "swage-lesson/1", "id": "org.example.l", "title": "T", "reset": )" + reset +
                 R"(, "objects": [], "lesson": {"plugin": "p.l"}})");
    return r.said.empty() ? std::string() : r.said.front();
  };
  EXPECT_EQ(said(R"({"label": "Lay anew"})"), "");
  EXPECT_THAT(said(R"({"label": "Lay the whole thread anew"})"), HasSubstr(say::kLongLabel(24)));
  EXPECT_THAT(said(R"({"tip": "Lays it anew"})"), HasSubstr(say::kMissing("label")));
  EXPECT_THAT(said(R"({"label": "Lay anew", "text": "x"})"), HasSubstr("text"));
  EXPECT_THAT(said(R"("Lay anew")"), HasSubstr("the reset of a lesson"));
}

TEST(LessonFile, ThePullOfAKnot) {
  EXPECT_EQ(with(R"("seed": 1)").file.pull.load, 0) << "none";
  const Read r = with(R"("pull": {"load": "100 mN", "points": 30})");
  ASSERT_THAT(r.said, IsEmpty());
  EXPECT_DOUBLE_EQ(r.file.pull.load, 0.1);
  EXPECT_EQ(r.file.pull.points, 30);
  EXPECT_EQ(with(R"("pull": {"load": 0.3})").file.pull.points, 0);
  EXPECT_THAT(with(R"("pull": {"points": 30})").said, ElementsAre(HasSubstr(say::kMissing("load"))));
  EXPECT_THAT(with(R"("pull": {"load": "0 N"})").said, ElementsAre(HasSubstr("load")));
  EXPECT_THAT(with(R"("pull": {"load": "0.1 mm"})").said, ElementsAre(HasSubstr("load")));
  EXPECT_THAT(with(R"("pull": {"load": "0.1 N", "points": 61})").said, ElementsAre(HasSubstr("points")));
  EXPECT_THAT(with(R"("pull": {"load": "0.1 N", "lod": 1})").said, ElementsAre(HasSubstr("lod")));
  EXPECT_THAT(with(R"("pull": "0.1 N")").said, Not(IsEmpty()));
}

TEST(LessonFile, MirrorModeAndCues) {
  const Read usual = with(R"("seed": 1)");
  EXPECT_FALSE(usual.file.mirror);
  EXPECT_EQ(usual.file.mode, "");
  EXPECT_EQ(usual.file.cues, 15u);
  EXPECT_FALSE(usual.file.tips_only);
  EXPECT_TRUE(with(R"("tips_only": true)").file.tips_only);
  EXPECT_EQ(usual.file.view, "");
  EXPECT_EQ(with(R"("view": "side")").file.view, "side");
  EXPECT_THAT(with(R"("view": "sid")").said, ElementsAre(HasSubstr("side")));
  const Read r = with(R"("mirror": true, "mode": "test", "cues": ["shape", "sound"])");
  ASSERT_THAT(r.said, IsEmpty());
  EXPECT_TRUE(r.file.mirror);
  EXPECT_EQ(r.file.mode, "test");
  EXPECT_EQ(r.file.cues, 6u);
  EXPECT_EQ(with(R"("cues": [])").file.cues, 0u);
  EXPECT_THAT(
      with(R"("mirror": 1, "mode": "tset", "cues": ["smell"])").said,
      ElementsAre(
          "a.json:2 #/mirror: " + say::kNoFlag("mirror", 1),
          "a.json:2 #/mode: " + say::kNoChoice("tset", "mode", host::did_you_mean("tset", {"test"}), "practice, test, demo"),
          "a.json:2 #/cues/0: " + say::kNoChannel("\"smell\"")));
}
