// SPDX-License-Identifier: Apache-2.0
//
// The rule of the audit on runs made by hand: when a level is enough, when it is not, and what is said of a finest level that could
// not be played.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tools/audit.hpp"
#include "tools/sentences.hpp"

namespace swage::tools {
namespace {

using testing::HasSubstr;

AuditRun run(const char* level, double us, double force, double reach = 1e-3) {
  AuditRun out;
  out.level = level;
  out.outcome = "passed";
  out.score = 90;
  out.cpu_s = 1e-6 * us;
  out.metric = {{"force.mean", "N", force}, {"grasp.tip_reach", "m", reach}, {"needle.bending", "1", NAN}};
  return out;
}

AuditLadder judged(const std::vector<AuditRun>& runs, std::size_t own = 0) {
  AuditLadder ladder;
  ladder.name = "needle.level";
  ladder.plugin = "swage.object.needle";
  ladder.own = own;
  for (const AuditRun& r : runs) ladder.level.emplace_back().run = r;
  judge({0.05}, ladder);
  return ladder;
}

TEST(AuditRule, TheCheapestLevelThatChangesNothingIsEnough) {
  const AuditLadder ladder =
      judged({run("rigid", 10, 0.61), run("bending", 40, 0.605), run("reference", 200, 0.6)});
  EXPECT_EQ(ladder.reference, 2u);
  EXPECT_EQ(ladder.chosen, 0u);
  EXPECT_NEAR(ladder.saves, 0.95, 1e-12);
  // 10 mN beside 5 % of 0.61 N
  EXPECT_NEAR(ladder.level[0].worst, 0.01 / (0.05 * 0.61), 1e-9);
  EXPECT_THAT(ladder.level[0].why, HasSubstr(say::kInstead("force.mean", "0.61", "0.6 N")));
}

TEST(AuditRule, ACoarseLevelThatMovesAMetricIsNotEnough) {
  const AuditLadder ladder =
      judged({run("rigid", 10, 0.7), run("bending", 40, 0.605), run("reference", 200, 0.6)});
  EXPECT_FALSE(ladder.level[0].enough);
  EXPECT_GT(ladder.level[0].worst, 1);
  EXPECT_EQ(ladder.chosen, 1u);
  EXPECT_NEAR(ladder.saves, 0.8, 1e-12);
}

TEST(AuditRule, OfLevelsThatCostTheSameTheSimplestIsNamed) {
  // the finest is the cheapest, by less than a busy machine adds
  const AuditLadder equal =
      judged({run("rigid", 10, 0.6), run("bending", 9.8, 0.6), run("reference", 9.5, 0.6)}, 2);
  EXPECT_EQ(equal.chosen, 0u);
  EXPECT_EQ(equal.saves, 0) << "nothing that could be measured";
  EXPECT_EQ(judged({run("rigid", 10, 0.8), run("bending", 9.8, 0.6), run("reference", 9.5, 0.6)}).chosen, 1u)
      << "the simplest is not enough";
  // costs that creep: 9 is a tenth below 10, and 8 below 9, yet 8 is not 10
  EXPECT_EQ(judged({run("rigid", 10, 0.6), run("bending", 9, 0.6), run("reference", 8, 0.6)}).chosen, 2u);
}

TEST(AuditRule, ASimplerLevelThatCostsMoreIsSaid) {
  const AuditLadder ladder = judged({run("rigid", 12, 0.6), run("bending", 10, 0.6)}, 1);
  EXPECT_EQ(ladder.chosen, 1u);
  EXPECT_THAT(
      audit_markdown({{"x.json", "org.example.x", "Lesson", "expert", {ladder}}}, {0.05}),
      HasSubstr("| bending | bending | - | rigid 12, bending 10 | " + say::kWouldDo("rigid", 20) + " |"));
}

TEST(AuditRule, WhatNobodyNoticesIsEqualWhateverItsShare) {
  EXPECT_TRUE(judged({run("rigid", 10, 0.6, 1e-6), run("bending", 40, 0.6, 20e-6)}).level[0].enough);
  EXPECT_FALSE(judged({run("rigid", 10, 0.6, 1e-6), run("bending", 40, 0.6, 22e-6)}).level[0].enough);
  // an area is small in m2: half a needle's length by its thickness must not pass for nothing
  AuditRun coarse = run("rigid", 10, 0.6), fine = run("bending", 40, 0.6);
  coarse.metric.push_back({"tissue.swept", "m2", 0});
  fine.metric.push_back({"tissue.swept", "m2", 2.5e-3 * 100e-6});
  EXPECT_FALSE(judged({coarse, fine}).level[0].enough);
}

// a tenth of a point of 100 made the needle of the insertion "not enough"
TEST(AuditRule, PointsAreComparedAsTheScore) {
  AuditRun coarse = run("rigid", 10, 0.6), fine = run("bending", 40, 0.6);
  coarse.metric.push_back({"points.entry", "1", 0.6});
  fine.metric.push_back({"points.entry", "1", 0.5});
  EXPECT_TRUE(judged({coarse, fine}).level[0].enough);
  coarse.metric.back().value = 6;
  EXPECT_FALSE(judged({coarse, fine}).level[0].enough);
}

TEST(AuditRule, AnotherVerdictIsNeverEnough) {
  AuditRun failed = run("rigid", 10, 0.6);
  failed.outcome = "failed";
  failed.reason = "failed.dropped";
  const AuditLadder ladder = judged({failed, run("bending", 40, 0.6)});
  EXPECT_FALSE(ladder.level[0].enough);
  EXPECT_TRUE(std::isinf(ladder.level[0].worst));
  EXPECT_EQ(ladder.level[0].why, say::kOtherEnd("failed (failed.dropped)", "bending", "passed"));
  EXPECT_EQ(ladder.chosen, 1u);
  EXPECT_EQ(ladder.saves, 0);
}

TEST(AuditRule, AMetricThatALevelCannotTellIsNamed) {
  AuditRun fine = run("bending", 40, 0.6);
  fine.metric.back().value = 0.3;
  const AuditLadder ladder = judged({run("rigid", 10, 0.6), fine});
  EXPECT_TRUE(ladder.level[0].enough);
  EXPECT_THAT(ladder.level[0].untold, testing::ElementsAre("needle.bending"));
}

TEST(AuditRule, AFinestLevelThatFailsOrIsTooSlowIsSaidAndTheNextMeasures) {
  AuditRun slow = run("reference", 9000, 0.6);
  slow.problem = "too slow: stopped at 1.00 s of the lesson";
  const AuditLadder ladder = judged({run("rigid", 10, 0.8), run("bending", 40, 0.6), slow});
  EXPECT_EQ(ladder.reference, 1u);
  EXPECT_FALSE(ladder.level[2].enough);
  EXPECT_EQ(ladder.chosen, 1u);

  AuditLesson lesson{"x.json", "org.example.x", "Lesson <x>", "expert", {ladder}};
  const std::string md = audit_markdown({lesson}, {0.05});
  EXPECT_THAT(md, HasSubstr(say::kOwnNotEnough(say::kInstead("force.mean", "0.8", "0.6 N")) + "; reference: " + slow.problem));
  EXPECT_THAT(md, HasSubstr("| reference | not played | | | | too slow"));
  const std::string csv = audit_csv({lesson});
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
  EXPECT_THAT(csv, HasSubstr("org.example.x,expert,needle.level,rigid,1,0,0,0,passed,,90,10,0,5,"));
  EXPECT_THAT(csv, HasSubstr("\"too slow: stopped at 1.00 s of the lesson\""));
  // score and two metrics of two levels; who was not played has none
  const std::string metrics = audit_metrics_csv({lesson});
  EXPECT_EQ(std::count(metrics.begin(), metrics.end(), '\n'), 1 + 2 * 3);
  EXPECT_THAT(metrics, HasSubstr("org.example.x,needle.level,rigid,force.mean,N,0.8,0.6,0.04,5\n"));
  const std::string svg = audit_svg({lesson});
  EXPECT_THAT(svg, HasSubstr("Lesson &lt;x&gt;"));
  EXPECT_THAT(svg, HasSubstr(">rigid<"));
  EXPECT_THAT(svg, testing::Not(HasSubstr(">reference<")));
}

AuditLesson lesson_of(const char* file, const char* id, const AuditLadder& ladder) {
  return {std::string("/somewhere/") + file, id, std::string("Lesson ") + file, "expert", {ladder}};
}

TEST(AuditReport, SaysWhatEachModelCostsAndErrsInAllLessons) {
  AuditLadder good = judged({run("rigid", 10, 0.6), run("bending", 40, 0.6)}, 0);
  AuditLadder bad = judged({run("rigid", 20, 0.66), run("bending", 40, 0.6)}, 1);
  bad.name = "other_needle.level";
  const std::string md = audit_markdown({lesson_of("1.json", "a", good), lesson_of("2.json", "b", bad)}, {0.05});
  EXPECT_THAT(md, HasSubstr("| needle.level | rigid | 1 | 2 | 1 | 0.38 | 1.82 | Lesson 2.json: " + say::kInstead("force.mean", "0.66", "0.6 N") + " |"))
      << md;
  EXPECT_THAT(md, HasSubstr("|  | bending | 1 | 2 | 2 | 1.00 | 0.00 |  |"));
  // numbers of segments differ from lesson to lesson, what they are beside the lesson's does not
  AuditLadder thread = judged({run("half (20)", 10, 0.6), run("its own (40)", 20, 0.6)}, 1);
  AuditLadder other = judged({run("half (24)", 10, 0.6), run("its own (48)", 20, 0.6)}, 1);
  thread.plugin = other.plugin = "swage.object.thread";
  thread.name = other.name = "suture.segments";
  EXPECT_THAT(audit_markdown({lesson_of("1.json", "a", thread), lesson_of("2.json", "b", other)}, {0.05}),
              HasSubstr("| thread.segments | half | 0 | 2 | 2 | 0.50 | 0.00 |  |"));
}

TEST(AuditRuns, AreKeptForALaterPiece) {
  AuditRun slow = run("reference", 9000, 0.6);
  slow.problem = "too slow";
  const AuditLadder ladder = judged({run("rigid", 10, 0.8), run("bending", 40, 0.6), slow}, 1);
  std::vector<AuditLesson> written = {lesson_of("020.json", "a", ladder), lesson_of("110.json", "b", ladder)}, read;
  ASSERT_TRUE(read_audit_runs(audit_runs(written), read));
  for (AuditLesson& lesson : read)
    for (AuditLadder& l : lesson.ladder) judge({0.05}, l);
  EXPECT_EQ(audit_csv(read), audit_csv(written));
  EXPECT_EQ(audit_metrics_csv(read), audit_metrics_csv(written));
  EXPECT_EQ(audit_markdown(read, {0.05}), audit_markdown(written, {0.05}));
  EXPECT_EQ(audit_svg(read), audit_svg(written));

  add_lesson(read, lesson_of("050.json", "c", ladder));
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[1].id, "c") << "in the order of their numbers";
  AuditLesson again = lesson_of("020.json", "a", ladder);
  again.title = "played again";
  add_lesson(read, again);
  ASSERT_EQ(read.size(), 3u);
  EXPECT_EQ(read[0].title, "played again");

  for (const char* text : {"", "[]", "{\"format\": \"swage-audit/2\", \"lessons\": []}",
                           "{\"format\": \"swage-audit/1\", \"lessons\": [{\"path\": 3}]}"})
    EXPECT_FALSE(read_audit_runs(text, read)) << text;
}

}  // namespace
}  // namespace swage::tools
