// SPDX-License-Identifier: Apache-2.0
//
// What is asked wrongly is answered with code 2, one sentence on standard error and the way to the help.
#include "host/nearest.hpp"
#include "program.hpp"
#include "tools/sentences.hpp"

namespace swage::tools::test {
namespace {

using testing::HasSubstr;
using Usage = Program;

void expect_refused(const std::vector<std::string>& arguments, const std::string& sentence) {
  const Said said = swage(arguments);
  EXPECT_EQ(said.code, 2) << sentence;
  EXPECT_EQ(said.out, "") << sentence;
  EXPECT_THAT(said.err, HasSubstr("error: " + sentence));
}

TEST_F(Usage, VerbsAreNamed) {
  expect_refused({}, say::kSayVerb("swage") + say::kVerbs.words(0) + "run, study, replay, pull, validate,");
  expect_refused({"runn", "x.json"},
                 say::kNoVerb("swage", "runn", host::did_you_mean("runn", {"run"})) + say::kVerbs.words(0) + "run, study, replay,");
  expect_refused({"attempts"}, say::kSayVerb("attempts") + say::kVerbs("list, import, backup, restore, salvage, export, send, void, name, note"));
  expect_refused({"calibrate"}, say::kSayVerb("calibrate") + say::kVerbs("displacement, force, tip, poses, zero, check, show"));
  expect_refused({"attempts", "exprot"}, say::kNoVerb("attempts", "exprot", host::did_you_mean("exprot", {"export"})));
}

TEST_F(Usage, ArgumentsAreChecked) {
  expect_refused({"run"}, say::kSeeHelp("lesson is required", "run "));
  expect_refused({"run", "a.json", "b.json"},
                 say::kSeeHelp("The following argument was not expected: b.json", "run "));
  expect_refused({"run", "a.json", "--mode", "hard"}, "--mode: hard not in {practice,test,demo}");
  expect_refused({"run", "a.json", "--max-time", "-3"}, "--max-time: " + say::kNoTime("-3"));
  expect_refused({"run", "a.json", "--fast"}, "The following argument was not expected: --fast");
  expect_refused({"replay"}, "attempt is required");
  expect_refused({"validate"}, "paths is required");
  expect_refused({"validate", "x", "--strictness", "11"}, "--strictness: Value 11 not in range 1 to 10");
  expect_refused({"describe", "--pretty"}, "The following argument was not expected: --pretty");
  expect_refused({"new", "object"}, "id is required");
  expect_refused({"bench"}, "which is required");
}

TEST_F(Usage, HelpAndVersionAreAnswers) {
  for (const char* verb : {"run", "replay", "validate", "describe", "new", "doctor", "bench", "attempts", "needle", "simulate-sensor",
                           "calibrate"}) {
    const Said said = swage({verb, "--help"});
    EXPECT_EQ(said.code, 0);
    EXPECT_THAT(said.out, HasSubstr(std::string("swage ") + verb));
  }
  EXPECT_THAT(swage({"--help"}).out, HasSubstr("Exit codes: 0 good, 1 not passed, 2 a problem."));
  EXPECT_EQ(swage({"help"}).out, swage({"--help"}).out);
  EXPECT_EQ(swage({"help", "attempts", "export"}).out, swage({"attempts", "export", "--help"}).out);
  expect_refused({"help", "runn"}, say::kNoVerb("swage", "runn", host::did_you_mean("runn", {"run"})));
  EXPECT_EQ(swage({"--version"}).out, "swage 1.0.0\n");
}

TEST_F(Usage, BenchSaysWhatItNeeds) {
  expect_refused({"bench", "chart"},
                 say::kBenchKnows("charts, stability, bar", "chart", host::did_you_mean("chart", {"charts"})));
}

}  // namespace
}  // namespace swage::tools::test
