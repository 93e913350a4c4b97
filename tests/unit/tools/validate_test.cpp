// SPDX-License-Identifier: Apache-2.0
#include <filesystem>
#include <fstream>

#include "host/instance.hpp"
#include "host/nearest.hpp"
#include "host/sentences.hpp"
#include "program.hpp"
#include "test_places.hpp"
#include "step/sentences.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;
using Validate = Program;

#ifdef SWAGE_SANITIZED
constexpr bool kSanitized = true;
#else
constexpr bool kSanitized = false;
#endif

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

// what "good" does not say is told: a plugin that allocates in the step is good for who did not ask
TEST_F(Validate, WhatWasNotAskedIsTold) {
  const Said usual = swage({"validate", stock("swage.object.jaws")});
  EXPECT_THAT(usual.out, testing::AllOf(HasSubstr("not asked: "), HasSubstr("real_time"), HasSubstr("waits"))) << usual.out;
  EXPECT_THAT(swage({"validate", stock("swage.object.jaws"), "--strictness", "10"}).out, testing::Not(HasSubstr("not asked")));
  EXPECT_THAT(swage({"validate", stock("swage.object.jaws"), "--only", "load"}).out, testing::Not(HasSubstr("not asked")));
}

// a lesson finds its objects among those that are installed, a coupling its partners; nothing is left out for want of a scene
TEST_F(Validate, LessonsAndCouplingsAreTestedToo) {
  for (const char* id : {"swage.lesson.grasp", "swage.lesson.free_practice", "swage.lesson.look",
                         "swage.coupling.contact", "swage.coupling.grasp"}) {
    const Said said = swage({"validate", stock(id), "--strictness", "9", "--json"});
    EXPECT_EQ(said.code, 0) << said.out << said.err;
    const nlohmann::json tests = said.json()[0]["tests"];
    bool fuzzed = false;
    for (const auto& test : tests) {
      fuzzed |= test["test"] == "fuzz_values" && test["result"] == "success";
      const bool hands_off = test["test"] == "fuzz" && test["text"] == say::kHandsOff();
      // a sanitizer has the allocator for itself
      const bool not_counted = kSanitized && test["test"] == "real_time" && test["text"] == host::say::kNoCount();
      EXPECT_TRUE(test["result"] != "skipped" || hands_off || not_counted) << id << ": " << test.dump();
    }
    EXPECT_TRUE(fuzzed) << said.out;
  }
}

TEST_F(Validate, FuzzValuesFindWhatItAsksFor) {
  const auto expect = [&](const std::string& plugin, const std::string& text) {
    const Said said = swage({"validate", bad(plugin), "--only", "fuzz_values", "--strictness", "9"});
    EXPECT_EQ(said.code, 1) << plugin << said.out << said.err;
    EXPECT_THAT(said.out, HasSubstr(text)) << plugin;
  };
  expect("lesson_remembers", say::kRemembers());
  expect("lesson_keeps", say::kForgets());
  expect("lesson_shares", say::kShares());
  expect("lesson_endless", say::kSaidNotFinite("metric", 0));
  expect("lesson_boasts", say::kScore(101));
  expect("coupling_negative", say::kContact.words(0) + "-1,");
  expect("coupling_poisoned", say::kPoisoned());
  expect("coupling_ties", say::kTooMany(65, "ties", 64));
  expect("coupling_tieplace", say::kTiePlace());
  expect("coupling_tiebody", say::kTieBody());
  expect("coupling_tiestrength", say::kTieStiffness(-1));
  expect("coupling_tieforce", say::kTieForce());
  expect("coupling_visuals", say::kManyVisuals(1, 0));
  expect("coupling_visualkind", say::kOfVisual(0, "unknown", say::kVisualKind(99)));
  expect("coupling_visualbody", say::kVisualBody.words(0));
  expect("coupling_visualtone", say::kOfVisual(0, "line", say::kVisualTone(77)));
  expect("coupling_visualnormal", say::kOfVisual(0, "disc", say::kVisualNormal("0")));
  expect("coupling_visualnumber", say::kOfVisual(0, "line", say::kVisualNumber("b.y")));
  expect("coupling_visualsize", say::kVisualSize("-0.0001"));
  expect("coupling_visualstrength", say::kVisualStrength("1.5"));
  expect("coupling_visualmeddles", say::kVisualMeddles());
  expect("coupling_visualother", say::kVisualOther());
#ifndef SWAGE_SANITIZED
  expect("lesson_allocates", say::kAllocates(2000, 2000));
#endif
}

// in a run without pace neither is noticed
TEST_F(Validate, WhoSleepsOrAllocatesInTheStepIsTold) {
  const auto expect = [&](const std::string& plugin, const std::string& test, const std::string& text) {
    const Said said = swage({"validate", bad(plugin), "--only", test, "--strictness", "7"});
    EXPECT_EQ(said.code, 1) << plugin << said.out << said.err;
    EXPECT_THAT(said.out, HasSubstr(text)) << plugin;
  };
  expect("lesson_sleeps", "waits", host::text(host::FaultKind::kWaited));
  expect("coupling_sleeps", "waits", host::text(host::FaultKind::kWaited));
#ifndef SWAGE_SANITIZED
  expect("lesson_allocates", "real_time", say::kAllocates(1000, 1000));
  expect("coupling_takes", "real_time", say::kAllocates(1000, 1000));
#endif
}

TEST_F(Validate, SteppingTestsFindWhatTheyAskFor) {
  const auto expect = [&](const std::string& plugin, const std::string& test, const std::string& text) {
    const Said said = swage({"validate", bad(plugin), "--only", test, "--strictness", "10"});
    EXPECT_EQ(said.code, 1) << plugin << said.out << said.err;
    EXPECT_THAT(said.out, HasSubstr(text)) << plugin;
    EXPECT_THAT(said.out, HasSubstr("NOT good"));
  };
  expect("nan", "stepping", host::text(host::FaultKind::kNotFinite));
  expect("remembers", "rewind", say::kRewinds.words(0));
  expect("crashes_in_step", "stepping", "signal 11");
}

TEST_F(Validate, ATestEndsAtTheLimitThatIsAskedFor) {
  const Said said = swage({"validate", bad("hangs_in_step"), "--only", "stepping", "--limit", "0.5"});
  EXPECT_EQ(said.code, 1) << said.out << said.err;
  EXPECT_THAT(said.out, HasSubstr(host::say::kNotDone.words(0) + "0.5" + host::say::kNotDone.words(1)));
}

// what is not known is no number and good; what is infinite is a fault of the driver
TEST_F(Validate, WhatADeviceTellsOfItselfIsAskedFor) {
  const auto validate = [&](const std::string& told) {
    const std::string bundle = SWAGE_BINARY_DIR "/tests/bad_plugins/bundles_tells/org.example.bad.tells." + told;
    return swage({"validate", bundle, "--only", "driver", "--strictness", "10"});
  };
  for (const char* told : {"number", "unknown"}) {
    const Said said = validate(told);
    EXPECT_EQ(said.code, 0) << told << said.out << said.err;
    EXPECT_THAT(said.out, testing::ContainsRegex("driver +success +" + say::kMeasurements("[0-9]+", "[0-9.]+"))) << told;
  }
  const Said said = validate("infinity");
  EXPECT_EQ(said.code, 1) << said.out << said.err;
  EXPECT_THAT(said.out, HasSubstr(say::kInfinite()));
}

// the console gives a cue its look by its role
TEST_F(Validate, ACueOfAnUnknownRoleIsTold) {
  const auto bundle = [](const char* role) {
    return std::string(SWAGE_BINARY_DIR "/tests/bad_plugins/bundles_roles/org.example.bad.roles.") + role;
  };
  const Said good = swage({"validate", bundle("target"), "--only", "descriptor", "--strictness", "10"});
  EXPECT_EQ(good.code, 0) << good.out << good.err;
  const Said bad_role = swage({"validate", bundle("unknown"), "--only", "descriptor", "--strictness", "10"});
  EXPECT_EQ(bad_role.code, 1) << bad_role.out << bad_role.err;
  EXPECT_THAT(bad_role.out, HasSubstr(host::say::kNoCueRole("lamp.lit", 5)));
}

// a solver that lies has finite numbers: nobody notices while it runs, so that it is asked
TEST_F(Validate, SolversThatLieAreTold) {
  const auto validate = [&](const std::string& name, const std::string& test) {
    const std::string bundle = SWAGE_BINARY_DIR "/tests/bad_plugins/bundles_solvers/org.example.bad.solver." + name;
    return swage({"validate", bundle, "--only", test, "--strictness", "10"});
  };
  for (const char* test : {"solver", "traits"}) {
    const Said said = validate("good", test);
    EXPECT_EQ(said.code, 0) << said.out << said.err;
    EXPECT_THAT(said.out, testing::Not(HasSubstr("skipped  "))) << said.out;
  }
  const auto expect = [&](const std::string& name, const std::string& text, const std::string& test = "solver") {
    const Said said = validate(name, test);
    EXPECT_EQ(said.code, 1) << name << said.out << said.err;
    EXPECT_THAT(said.out, HasSubstr(text)) << name;
  };
  expect("skew", say::kSkew.words(0));
  expect("pulls", say::kPulls.words(0));
  expect("unsteady", say::kOtherBits("mobility"));
  expect("part", say::kPart());
  expect("unwritten", say::kUnwritten.words(1));
  expect("forgets", say::kImpulsesOff.words(0));
  expect("doubles", say::kImpulsesOff.words(0));
  expect("stands", say::kImpulsesSlip.words(0));
  expect("aborts", host::say::kCrashed.words(0) + " in mobility() of org.example.bad.solver.aborts");
  expect("infinite", say::kImpulsesNotFinite());
  expect("dents", say::kOfVisual(0, "dent", say::kVisualNumber("b.z")), "drawing");
  // what is not wrong and will not be seen is a warning
  for (const auto& [name, text] : {std::pair{"unseen", say::kVisualUnseen(0, "dent", "swage.trait.pierceable/1")}, {"many", say::kVisualsLeftOut(200, 80)}})
    EXPECT_THAT(validate(name, "drawing").out, testing::AllOf(HasSubstr("warning"), HasSubstr(text), HasSubstr("\n  good: ")));
  expect("meddles", say::kVisualMeddles(), "drawing");
  expect("surface", say::kSurfaceUnwritten());
  expect("unsteadysurface", say::kOtherBits("displacement"));
  expect("bandless", say::kBandNoChain.words(0));
  expect("nearest", say::kOfCall("locate", say::kNotSquare()), "traits");
}

// of an object with a chain: solver/2, and the band that the host solves with everything else
TEST_F(Validate, ChainsThatLieAreTold) {
  enum { kGood, kSkew, kPart, kUnwritten, kUnsteady, kForgets, kElsewhere, kBandStiff, kBandFree, kBandIndefinite,
         kBandNan, kBandAborts, kGoesTwice, kGoesStill, kGoesNowhere };
  const auto validate = [&](int fault) { return validate_fault("org.example.bad.chain", "solver", fault); };
  const Said good = validate(kGood);
  EXPECT_EQ(good.code, 0) << good.out << good.err;
  EXPECT_THAT(good.out, testing::ContainsRegex("solver +success"));
  const auto expect = [&](int fault, const std::string& text) {
    const Said said = validate(fault);
    EXPECT_EQ(said.code, 1) << fault << said.out << said.err;
    EXPECT_THAT(said.out, HasSubstr(text)) << fault;
  };
  expect(kSkew, say::kSkew.words(0));
  expect(kPart, say::kPart());
  expect(kUnwritten, say::kUnwritten.words(1));
  expect(kUnsteady, say::kOtherBits("mobility"));
  expect(kForgets, say::kImpulsesOff.words(0));
  expect(kElsewhere, say::kImpulsesOff.words(0));
  expect(kBandStiff, say::kBandMobility());
  expect(kBandFree, say::kBandFree());
  expect(kBandIndefinite, say::kBandNotDefinite());
  expect(kBandNan, say::kBandNotFinite());
  expect(kBandAborts, host::say::kCrashed.words(0) + " in linearise() of org.example.bad.chain");
  expect(kGoesTwice, say::kDisplaceOff());
  expect(kGoesStill, say::kDisplaceSpeed());
  expect(kGoesNowhere, say::kDisplaceNotFinite());
}

/// A copy of the library whose fault is the name of its folder.
class ValidateDriver : public Validate {
 protected:
  std::string driver(const std::string& fault) const {
    const std::string id = "org.example.bad.driver." + fault;
    std::filesystem::create_directories(path(id));
    std::filesystem::copy_file(SWAGE_BINARY_DIR "/tests/bad_plugins/bundles_driver/org.example.bad.driver/org.example.bad.driver.so",
                               path(id) + "/" + id + ".so", std::filesystem::copy_options::overwrite_existing);
    return path(id);
  }
};

// each thing that a driver with a thread of its own may get wrong
TEST_F(ValidateDriver, WhatADriverDoesWrongIsTold) {
  const auto expect = [&](const std::string& fault, const std::string& text, int code = 1) {
    const Said said = swage({"validate", driver(fault), "--only", "driver", "--strictness", "10"});
    EXPECT_EQ(said.code, code) << fault << said.out << said.err;
    EXPECT_THAT(said.out, HasSubstr(text)) << fault;
  };
  expect("good", say::kMeasurements.words(1), 0);
  expect("unknown_flags", say::kUnknownFlags(0xFF00));
  expect("no_rate", say::kNoRate(0));
  expect("force", say::kForces("takes no", 1));
  expect("opens_not", say::kOpensNot());
  expect("calibration_gaps", say::kTableGaps("swage.device.calibration/1"));
  expect("calibration_no_json", say::kCalibrationNoJson());
  expect("sends_nothing", say::kSentNothing(), 0);
  expect("slow_exchange", say::kSlowExchange.words(0), 0);
  expect("too_slow_exchange", say::kTooSlowExchange.words(1));
  expect("calls_host", say::kCallsHost());
  expect("not_finite", say::kSampleNotFinite());
  expect("unknown_fields", say::kUnknownFields(0x8000));
  expect("backwards", say::kBackwards());
  expect("quaternion", say::kQuaternion(2));
  expect("closure", say::kClosure("1.5"), 0);
  expect("older", say::kOlder());
  expect("other_clock", say::kOtherClock(), 0);
}

// a hand that sees is judged by its samples
TEST_F(ValidateDriver, WhatAHandThatSeesDoesWrongIsTold) {
  const auto validate = [&](const std::string& fault) {
    const std::string id = "org.example.bad.driver." + fault;
    write("seen.json", R"({ "format": "swage-lesson/1", "id": "org.example.seen", "title": "Seen",
      "requires": { "swage.object.solids": "^1", ")" + id + R"(": "^1", "swage.lesson.look": "^1" },
      "objects": [ { "name": "ball", "plugin": "swage.object.solids" } ],
      "devices": [ { "name": "hand", "plugin": ")" + id + R"(" } ],
      "lesson": { "plugin": "swage.lesson.look", "params": { "duration": "1 s" } } })");
    return swage({"validate", driver(fault), "--only", "sight", "--strictness", "10", "--with", path("seen.json")});
  };
  const Said good = validate("sight_good");
  EXPECT_EQ(good.code, 0) << good.out << good.err;
  EXPECT_THAT(good.out, testing::ContainsRegex("sight +success"));
  EXPECT_THAT(validate("good").out, HasSubstr(say::kOwnThread()));
  const auto expect = [&](const std::string& fault, const std::string& text) {
    const Said said = validate(fault);
    EXPECT_EQ(said.code, 1) << fault << said.out << said.err;
    EXPECT_THAT(said.out, HasSubstr(text)) << fault;
  };
  expect("sight_not_finite", say::kSampleNotFinite());
  expect("sight_quaternion", say::kQuaternion(2));
  expect("sight_closure", say::kClosure("1.5"));
  expect("sight_shares", say::kSeesOtherwise());
  expect("sight_writes", host::text(host::FaultKind::kMeddled));
#ifndef SWAGE_SANITIZED
  expect("sight_allocates", say::kAllocates(480, 500));
#endif
}

// the stock hand that sees, in a lesson that needs its eyes
TEST_F(Validate, TheStockHandThatSeesIsGood) {
  const Said said = swage({"validate", stock("swage.device.skilled"), "--strictness", "5", "--with", source("lessons/series/110_insertion.json")});
  EXPECT_EQ(said.code, 0) << said.out << said.err;
  EXPECT_THAT(said.out, testing::ContainsRegex("sight +success"));
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

// what a build leaves behind: a folder of bundles, and beside lessons what a trace says about itself
TEST_F(Validate, AFolderOfBundlesStandsForEach) {
  const Said said = swage({"validate", SWAGE_BINARY_DIR "/tests/bad_plugins/bundles_tells", "--only", "load"});
  EXPECT_EQ(said.code, 0) << said.out << said.err;
  for (const char* told : {"number", "unknown", "infinity"}) EXPECT_THAT(said.out, HasSubstr(std::string("bundles_tells/org.example.bad.tells.") + told + "\n"));
  write_drop_lesson();
  write("t.csv.about.json", "{}");
  const Said lessons = swage({"validate", folder()});
  EXPECT_THAT(lessons.out, HasSubstr("drop.json: good"));
  EXPECT_THAT(lessons.out + lessons.err, testing::Not(HasSubstr("about.json")));
}

TEST_F(Validate, WrongUses) {
  const Said test = swage({"validate", stock("swage.object.needle"), "--only", "steping"});
  EXPECT_EQ(test.code, 2);
  EXPECT_THAT(test.err, HasSubstr(say::kNoTest.words(0) + "steping" + say::kNoTest.words(1) + host::did_you_mean("steping", {"stepping"}) + say::kNoTest.words(2)));
  const Said absent = swage({"validate", path("none")});
  EXPECT_EQ(absent.code, 2);
  EXPECT_THAT(absent.err, HasSubstr(say::kNothingThere(path("none"))));
  const Said empty = swage({"validate", folder()});
  EXPECT_EQ(empty.code, 2);
  EXPECT_THAT(empty.err, HasSubstr(say::kHoldsNeither(folder())));
}

// a test that cannot be made is no finding about the plugin, and says why
TEST_F(Validate, WhyOneTestIsNotMade) {
  const Said strict = swage({"validate", stock("swage.object.needle"), "--only", "real_time"});
  EXPECT_EQ(strict.code, 2) << strict.out << strict.err;
  EXPECT_THAT(strict.err, HasSubstr(say::kNeedsStrictness("real_time", 7)));
  const Said kind = swage({"validate", stock("swage.lesson.look"), "--only", "traits"});
  EXPECT_EQ(kind.code, 2) << kind.out << kind.err;
  EXPECT_THAT(kind.out, HasSubstr(say::kNotOfItsKind("traits", "objects")));
  EXPECT_THAT(kind.out, testing::Not(HasSubstr("NOT good")));
  const Said json = swage({"validate", stock("swage.lesson.look"), "--only", "traits", "--json"});
  EXPECT_EQ(json.json()[0]["reason"], say::kNotOfItsKind("traits", "objects"));
}

// what a failed build leaves behind
TEST_F(Validate, ABundleWithoutALibrary) {
  for (const char* file : {"org.example.empty/words.de.json", "made/plugin.json"}) {
    const std::string bundle = path(std::filesystem::path(file).parent_path().string());
    std::filesystem::create_directories(bundle);
    write(file, "{}");
    const Said said = swage({"validate", bundle});
    EXPECT_EQ(said.code, 2) << said.out << said.err;
    EXPECT_THAT(said.err, HasSubstr(say::kNoLibraryIn(bundle)));
  }
}

TEST_F(Validate, LessonFilesToo) {
  const std::string good = source("lessons/series/020_grasp_basic.json");
  const Said said = swage({"validate", good});
  EXPECT_EQ(said.code, 0) << said.err;
  EXPECT_EQ(said.out, good + ": good\n");
  const Said all = swage({"validate", source("lessons/series")});
  EXPECT_EQ(all.code, 0) << all.err;
  EXPECT_THAT(all.out, HasSubstr(good + ": good\n"));
  EXPECT_THAT(all.err, testing::Not(HasSubstr(step::say::kStartsInside.words(2)))) << "what starts held is no fault of a lesson";
  std::ifstream in(good);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  const std::string right = "\"wire_diameter\": \"100 um\"";
  text.replace(text.find(right), right.size(), "\"wire_diameter\": \"0.1 N\"");
  write("wrong.json", text);
  const Said wrong = swage({"validate", path("wrong.json"), "--json"});
  EXPECT_EQ(wrong.code, 1);
  EXPECT_THAT(wrong.err, HasSubstr("wrong.json"));
  EXPECT_THAT(wrong.err, HasSubstr("/params/wire_diameter: " + host::say::kOtherDimension.words(0) + "0.1 N" + host::say::kOtherDimension.words(1) + "a force" + host::say::kOtherDimension.words(2)));
  EXPECT_EQ(wrong.json()[0]["good"], false);
}

// what starts inside each other is thrown: it is said with its depth and both names
TEST_F(Validate, SaysWhatStartsInsideEachOther) {
  const auto two = [this](const char* x) { return swage({"validate", write_two_solids(x)}); };
  const Said inside = two("0.4 mm"), apart = two("20 mm");
  EXPECT_THAT(inside.out + inside.err, HasSubstr(step::say::kStartsInside.words(0) + "ring" + step::say::kStartsInside.words(1)));
  EXPECT_THAT(inside.out + inside.err, testing::ContainsRegex("[0-9.]+" + step::say::kStartsInside.words(2) + "hook"));
  EXPECT_EQ(apart.code, 0) << apart.err;
  EXPECT_THAT(apart.out + apart.err, testing::Not(HasSubstr(step::say::kStartsInside.words(2))));
}

}  // namespace
}  // namespace swage::tools::test
