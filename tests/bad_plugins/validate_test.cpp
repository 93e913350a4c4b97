// SPDX-License-Identifier: Apache-2.0
//
// The validator finds in each bad plugin what is wrong with it, and nothing in a good one.
#include "host/validate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>

#include "host/instance.hpp"
#include "host/sentences.hpp"
#include "toolkit/sentences.hpp"

using namespace swage::host;
using testing::HasSubstr;

namespace {

std::string bundle(const std::string& id) { return std::string(BAD_PLUGINS_DIR) + "/" + id; }

std::vector<ValidateResult> results(const std::string& id, double limit_s = 20) {
  ValidateOptions options;
  options.strictness = 10;
  options.limit_s = limit_s;
  return validate(bundle(id), host_tests(), options);
}

// what one test says: "failed: ..."
std::string says(const std::vector<ValidateResult>& all, const std::string& test) {
  for (const ValidateResult& r : all)
    if (r.name == test)
      return std::string(text(r.finding.mark)) + (r.finding.text.empty() ? "" : ": " + r.finding.text);
  return "no such test";
}

std::string says(const std::string& id, const std::string& test) { return says(results(id), test); }

}  // namespace

TEST(Validate, AGoodPluginPasses) {
  const auto all = results("org.example.ball");
  EXPECT_EQ(all.size(), host_tests().size());
  for (const ValidateResult& r : all) {
    if (r.name == "descriptor") continue;
    if (r.name == "load" && r.finding.mark == Mark::kWarning) continue;       // a slow machine
    if (r.name == "real_time" && r.finding.mark == Mark::kSkipped) continue;  // sanitizers
    EXPECT_EQ(r.finding.mark, Mark::kSuccess) << r.name << ": " << r.finding.text;
  }
  EXPECT_EQ(says(all, "descriptor"),
            "warning: " + say::kNoPluginJson());
  EXPECT_TRUE(passed(all)) << "a warning is no failure";
}

TEST(Validate, StepsOfBadPlugins) {
  EXPECT_EQ(says("org.example.bad.nan", "threads"),
            "failed: " + say::kQuarantine("trial", "org.example.bad.nan", "1.0.0", text(FaultKind::kNotFinite), "forces", 10));
  EXPECT_THAT(says("org.example.bad.nan", "bounds"),
              testing::StartsWith("failed: " + say::kAtEnd("radius", "min") + ": trial" + say::kQuarantine.words(1) + "org.example"));
  EXPECT_THAT(says("org.example.bad.throws", "threads"),
              HasSubstr(say::kQuarantine("trial", "org.example.bad.throws", "1.0.0", text(FaultKind::kFault), "forces", 10)));
  EXPECT_THAT(says("org.example.bad.huge", "threads"),
              HasSubstr(text(FaultKind::kTooLarge)));
  EXPECT_EQ(says("org.example.bad.talks", "threads"),
            "failed: " + say::kWrongThread("org.example.bad.talks", 300));
  EXPECT_EQ(says("org.example.bad.remembers", "state"),
            "failed: " + say::kRewinds("org.example.bad.remembers") + "\n" + say::kSecondInstance("org.example.bad.remembers"));
}

TEST(Validate, MemoryTakenInTheStep) {
  const std::string said = says("org.example.bad.allocates", "real_time");
  if (said.starts_with("skipped")) GTEST_SKIP() << said;
  EXPECT_EQ(
      said,
      "failed: " + say::kAllocates("org.example.bad.allocates", 300, 300));
}

TEST(Validate, CrashesAreResultsAndNameTheCall) {
  const auto all = results("org.example.bad.crashes_in_step");
  EXPECT_EQ(says(all, "threads"),
            "crashed: " + say::kCrashed(" in forces() of org.example.bad.crashes_in_step at step 10", "signal 11 (Segmentation fault)"));
  EXPECT_EQ(says(all, "lifecycle"), "success") << "the other tests go on";
  EXPECT_FALSE(passed(all));
}

TEST(Validate, HangsAreStoppedAndNamed) {
#ifdef SWAGE_SANITIZED_THREADS
  GTEST_SKIP() << "The sanitizer delivers a timer's signal late: who hangs is not named.";
#endif
  ValidateOptions options;
  options.strictness = 10;
  options.only = "threads";
  options.limit_s = 3;
  const auto all = validate(bundle("org.example.bad.hangs_in_step"), host_tests(), options);
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].finding.text,
            say::kNotDone("3", " in forces() of org.example.bad.hangs_in_step at step 10"));
  EXPECT_EQ(all[0].finding.mark, Mark::kCrashed);
}

TEST(Validate, WhatCannotBeLoaded) {
  const auto wrong = results("org.example.bad.wrong_abi");
  EXPECT_EQ(says(wrong, "load"),
            "failed: " + say::kOtherAbi("2.0", "1.0", say::kOtherMajor()));
  EXPECT_EQ(says(wrong, "state"), "skipped: " + say::kNotLoaded());
  EXPECT_EQ(says("org.example.bad.crashes_on_load", "load"),
            "crashed: " + say::kCrashed(" in load() of org.example.bad.crashes_on_load at step 0", "signal 11 (Segmentation fault)"));
#ifndef SWAGE_SANITIZED_THREADS  // which delivers a timer's signal late
  EXPECT_EQ(says(results("../bundles_hanging/org.example.bad.hangs_on_load", 0.5), "load"),
            "crashed: " + say::kNotDone("0.5", " in load() of org.example.bad.hangs_on_load at step 0"));
#endif
#if defined(__x86_64__)
  EXPECT_THAT(says("org.example.bad.fast_math", "load"), HasSubstr(say::kLoadRounding()));
#endif
  EXPECT_EQ(
      says("org.example.bad.no_plugin", "load"),
      "failed: " + say::kExportsMore("swage_plugin_entry", "answer") + "\n" + say::kNoPlugin("swage_plugin_entry"));
  EXPECT_EQ(says("org.example.bad.none", "load"),
            "failed: " + say::kNoElf() + "\n" + swage::toolkit::say::kNoFile());
}

TEST(Validate, FactoriesAndTables) {
  EXPECT_THAT(
      says("org.example.bad.leaks_ids", "descriptor"),
      HasSubstr(
          "failed: " + say::kCreatesAnything("org.example.bad.leaks_idsx")));
  EXPECT_THAT(says("org.example.bad.bad_table", "parameters"),
              HasSubstr("\"radius\": " + say::kIdTwice()));
  EXPECT_EQ(says("org.example.bad.gaps", "lifecycle"),
            "failed: " + say::kGaps("swage.object/1", "org.example.bad.gaps") + "\n" + say::kTraitNotOffered("org.example.bad.gaps", "swage.trait.graspable/1"));
  EXPECT_EQ(says("org.example.bad.no_params", "parameters"), "success");
  EXPECT_EQ(says("org.example.bad.silent", "lifecycle"),
            "failed: " + say::kRefusesDefaults("org.example.bad.silent"));
  EXPECT_THAT(says("org.example.bad.silent", "bounds"), HasSubstr(say::kRefusesSilently.words(2)));
  EXPECT_THAT(says("org.example.bad.greedy", "threads"), HasSubstr(say::kLargeState(2147483647)));
}

TEST(Validate, LevelsAndNamesChooseTests) {
  ValidateOptions options;
  options.strictness = 2;
  std::vector<std::string> heard;
  validate(bundle("org.example.ball"), host_tests(), options,
           [&](const ValidateResult& r) { heard.push_back(r.name); });
  EXPECT_THAT(heard, testing::ElementsAre("load", "descriptor", "parameters"));
}

TEST(Validate, RoomsAboveAddTheirOwnTests) {
  std::vector<ValidateTest> tests = {
      {4, "own", "Whatever.",
       [](const Subject& s) {
         return Finding{Mark::kWarning, s.plugins.at(0).id};
       }},
      {4, "aborts", "Whatever.", [](const Subject&) -> Finding { std::abort(); }},
      {4, "exits", "Whatever.", [](const Subject&) -> Finding { std::_Exit(7); }}};
  const auto all = validate(bundle("org.example.ball"), tests, {});
  EXPECT_EQ(says(all, "own"), "warning: org.example.ball");
  EXPECT_EQ(says(all, "aborts"), "crashed: " + say::kCrashed("", "signal 6 (Aborted)"));
  EXPECT_EQ(says(all, "exits"), "crashed: " + say::kEndedWith(7));
}
