// SPDX-License-Identifier: Apache-2.0
#include "console/models/review.hpp"

#include <gtest/gtest.h>
#include <swage/abi/lesson_card.h>

#include <QStringList>
#include <algorithm>
#include <cmath>

#include "console/models/live_params.hpp"
#include "fake_recording.hpp"
#include "known_metrics.hpp"

namespace swage::console {
namespace {

TEST(ReviewModel, TracesHaveRoundAxesInReadableUnitsAndTheImportantOnesComeFirst) {
  const record::Recording r = test::fake_recording(2000);
  const Review review = make_review(test::fake_attempt(), r, test::fake_events());
  ASSERT_EQ(review.traces.size(), 4);
  EXPECT_EQ(review.traces[0].name, "Grasp force");
  EXPECT_TRUE(review.traces[0].wanted);
  EXPECT_EQ(review.traces[0].unit, "N");
  EXPECT_DOUBLE_EQ(review.traces[0].low, 0);
  EXPECT_DOUBLE_EQ(review.traces[0].high, 0.8);  // 0.7 rounded outwards
  EXPECT_EQ(review.traces[1].name, "Grasp tilt axis");
  EXPECT_EQ(review.traces[1].unit, "°");
  EXPECT_NEAR(value_at(review.traces[1], r, 1500), 0.2 * 180 / M_PI, 1e-4);
  // a constant signal is listed, not shown
  EXPECT_TRUE(review.traces[3].flat);
  EXPECT_FALSE(review.traces[3].wanted);
  EXPECT_DOUBLE_EQ(review.length_s, 2.0);
}

// of a knot its throws, before the tilts of what is held
TEST(ReviewModel, WhatIsTiedComesBeforeTilts) {
  record::Recording r = test::fake_recording(2000);
  const size_t n = r.info.script.signals.size();
  r.info.script.signals[n - 1] = {"knot", "knot.throws", "1", "Throws that are tied."};
  for (size_t i = 0; i < r.step.size(); ++i) r.signal[n * i + n - 1] = i < 1000 ? 0.0F : 1.0F;
  const Review review = make_review(test::fake_attempt(), r, test::fake_events());
  EXPECT_EQ(review.traces[0].name, "Grasp force");
  EXPECT_EQ(review.traces[1].name, "Knot throws");
  EXPECT_TRUE(review.traces[1].wanted);
}

TEST(ReviewModel, TwoTracesShareAScaleWithoutNumbersOfNoMeaning) {
  Trace a, b;
  a.low = -4, a.high = 0;
  b.low = 0, b.high = 3e-5;
  EXPECT_EQ(on_one_scale(a, b).low, -4);
  EXPECT_EQ(on_one_scale(a, b).high, 0);
  EXPECT_EQ(on_one_scale(b, a).high, 0) << "either way round";
  b.high = 2;
  EXPECT_EQ(on_one_scale(a, b).high, 2);
  a.low = -1e-5, a.high = 1;
  EXPECT_EQ(on_one_scale(a, b).low, 0);
}

TEST(ReviewModel, MomentsAreInOrderWithMeaningAndKnowWhoSaidThem) {
  const Review review = make_review(test::fake_attempt(), test::fake_recording(2000), test::fake_events());
  ASSERT_EQ(review.moments.size(), 3);
  EXPECT_EQ(review.moments[0].what, "Grasp taken");
  EXPECT_EQ(review.moments[0].means, "The jaws hold the needle");
  EXPECT_TRUE(review.moments[1].by_person);
  EXPECT_EQ(review.moments[1].what, "Wrist not turning");
  EXPECT_TRUE(review.moments[2].technical);
}

TEST(ReviewModel, MetricsHaveUnitAndDirection) {
  test::learn_known_metrics();
  const Review review = make_review(test::fake_attempt(), test::fake_recording(10), {});
  ASSERT_EQ(review.metrics.size(), 2);
  EXPECT_TRUE(review.metrics[0].value.endsWith("N"));
  EXPECT_EQ(review.metrics[0].better, SWAGE_BETTER_LOWER);
  EXPECT_EQ(review.metrics[1].better, SWAGE_BETTER_NONE);
  EXPECT_EQ(better_words(SWAGE_BETTER_NONE), QString());
  EXPECT_EQ(review.verdict(), "✓ Passed, 87 of 100");
}

TEST(ReviewModel, ARecordedHandIsNamedBeforeThePerson) {
  record::AttemptRow attempt = test::fake_attempt();
  record::Recording r = test::fake_recording(10);
  r.info.hands = {{"hand", "novice", "swage.device.skilled", "1.0.0", "{}", 0}};
  EXPECT_EQ(make_review(attempt, r, {}).title(), "Grasp the needle  ·  Arun P.");
  attempt.is_scripted = true;
  const Review review = make_review(attempt, r, {});
  EXPECT_TRUE(review.title().startsWith("Grasp the needle  ·  Recorded hand: novice")) << review.title().toStdString();
  EXPECT_FALSE(review.facts().contains("Practice"));
}

TEST(ReviewModel, ScalesOfSurgeonsAreToldAsFarAsTheAttemptDecidesThem) {
  record::AttemptRow attempt = test::fake_attempt();
  attempt.metrics = {{"points.time", "1", 3}, {"task.success", "1", 1}};
  Review review = make_review(attempt, test::fake_recording(10), {});
  ASSERT_EQ(review.ratings.size(), 3);  // two items of SMaRT after their mean; no knot was tied, so the other scales have no items
  EXPECT_EQ(review.ratings[0].name, "SMaRT, computed (2 of 9 items)");
  EXPECT_EQ(review.ratings[1].name, "SMaRT: Efficiency");
  EXPECT_EQ(review.ratings[1].value, "4.2 of 5");  // 1 + 4 (1 - 3 / 15)
  EXPECT_EQ(review.ratings[2].value, "5.0 of 5");
  EXPECT_NE(summary_csv(review).find("rating,\"smart.efficiency\",,4.2,\"1\",\"1 to 5\""), std::string::npos) << summary_csv(review);
  EXPECT_TRUE(review.ratings[0].doc.contains("Computed from metrics; 2 of 9 items")) << review.ratings[0].doc.toStdString();
  EXPECT_TRUE(review.ratings[0].doc.contains("from memory")) << "the source, as the scale's file tells it";
  // an instructor's points are listed beside them and enter no computed mean
  review = make_review(attempt, test::fake_recording(10), {}, nullptr, {{"smart.efficiency", 3}, {"smart.operation_flow", 5}, {"gone.item", 1}});
  const RatedScale& smart = *std::find_if(review.scales.begin(), review.scales.end(), [](const RatedScale& s) { return s.id == "smart"; });
  EXPECT_EQ(smart.items.size(), 9);
  EXPECT_EQ(smart.decided, 2);
  EXPECT_EQ(smart.given, 2);
  EXPECT_DOUBLE_EQ(smart.computed_mean, 4.6);
  EXPECT_DOUBLE_EQ(smart.given_mean, 4);
  EXPECT_NE(summary_csv(review).find("rating_by_instructor,\"smart.operation_flow\",,5,\"1\",\"1 to 5\""), std::string::npos);
  // an aborted attempt is not rated
  attempt.outcome = "aborted";
  EXPECT_TRUE(make_review(attempt, test::fake_recording(10), {}).ratings.isEmpty());
}

TEST(ReviewModel, TheLessonsOwnCardComesBeforeAnothers) {
  test::learn_known_metrics();
  const record::Recording recording = test::fake_recording(10);
  snapshot::SceneCard card;
  card.script = recording.info.script;
  card.metrics = {{SWAGE_BETTER_INSIDE, SWAGE_EVIDENCE_C, "M15", "max(f)", "Force", 0, 0},
                  {SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_D, "", "n", "", 0, 0}};
  Review review = make_review(test::fake_attempt(), recording, {}, &card);
  EXPECT_EQ(review.metrics[0].better, SWAGE_BETTER_INSIDE);
  EXPECT_TRUE(review.metrics[0].doc.contains("max(f)"));
  EXPECT_EQ(review.metrics[1].better, SWAGE_BETTER_HIGHER);
  EXPECT_NE(summary_csv(review).find("\"best inside its band\""), std::string::npos);
  // for a metric without data on this card, another card is used
  card.metrics[0].evidence = SWAGE_EVIDENCE_NONE;
  review = make_review(test::fake_attempt(), recording, {}, &card);
  EXPECT_EQ(review.metrics[0].better, SWAGE_BETTER_LOWER);
}

TEST(ReviewModel, TheSeedIsShownSoThatTheAttemptCanBeSetUpAgain) {
  record::Recording recording = test::fake_recording(10);
  recording.info.seed = 48213;
  const Review review = make_review(test::fake_attempt(), recording, {});
  EXPECT_TRUE(review.headline().contains("48213"));
  EXPECT_NE(summary_csv(review).find("\"48213\""), std::string::npos);
}

TEST(ReviewModel, SignalsAsCsvAreExactAndHaveUnits) {
  const record::Recording r = test::fake_recording(3);
  const QStringList lines = QString::fromStdString(signals_csv(r)).split('\n');
  ASSERT_EQ(lines.size(), 5);  // heading, three steps, and the empty text after the last line end
  EXPECT_EQ(lines[0].count(','), 4);
  EXPECT_TRUE(lines[0].contains("\"grasp grasp.force [N]\""));
  EXPECT_TRUE(lines[1].startsWith("0.001,"));
  EXPECT_EQ(lines[3].section(',', 1, 1).toFloat(), r.signal[2 * 4]);
  // NaN is an empty field
  record::Recording gap = r;
  gap.signal[0] = NAN;
  EXPECT_TRUE(QString::fromStdString(signals_csv(gap)).split('\n')[1].startsWith("0.001,,"));
}

TEST(ReviewModel, SummaryAsCsvQuotesWhatPeopleWrote) {
  test::learn_known_metrics();
  std::vector<record::EventRow> events = test::fake_events();
  events[1].id = "said \"slow, slow\"";
  const std::string csv = summary_csv(make_review(test::fake_attempt(), test::fake_recording(2000), events));
  EXPECT_NE(csv.find("\"said \"\"slow, slow\"\"\""), std::string::npos) << csv;
  EXPECT_NE(csv.find("metric,\"force.peak\",,0.83,\"N\",\"lower is better\""), std::string::npos) << csv;
}

// Two instruments have one grasp each: plots, lists and pictures name the instrument of each force.
TEST(ReviewModel, TracesAndEventsOfTwoGraspsAreToldApart) {
  record::Recording r = test::fake_recording(200);
  ASSERT_GE(r.info.script.signals.size(), 2u);
  r.info.script.signals[0] = {"grasp", "grasp.force", "N", "The grip."};
  r.info.script.signals[1] = {"tail_grasp", "grasp.force", "N", "The grip."};
  r.info.script.events.push_back({"tail_grasp", "grasp.taken", "N", "Both jaws hold it; value: the force."});
  r.info.script.events.push_back({"grasp", "grasp.taken", "N", "Both jaws hold it; value: the force."});
  const Review review = make_review(test::fake_attempt(), r, {{10, 0.01, "tail_grasp", "grasp.taken", 0.5}});
  QStringList names;
  for (const Trace& t : review.traces) names += t.name;
  EXPECT_TRUE(names.contains("Grasp force (Grasp)")) << names.join(", ").toStdString();
  EXPECT_TRUE(names.contains("Grasp force (Tail grasp)"));
  names.removeDuplicates();
  EXPECT_EQ(names.size(), review.traces.size());
  ASSERT_EQ(review.moments.size(), 1);
  EXPECT_EQ(review.moments[0].what, "Grasp taken (Tail grasp)");
  EXPECT_EQ(review.moments[0].means, "Both jaws hold it");
}

LiveParam length_param() {
  LiveParam p;
  p.instance = "needle";
  p.param.id = "gap";
  p.param.type = SWAGE_PARAM_REAL;
  p.param.unit = "m";
  p.param.display_unit = "mm";
  p.param.min = 0;
  p.param.max = 5e-3;
  p.start = {2.6e-3, 0, 0, 0};
  return p;
}

TEST(LiveParams, ShowTheTablesUnitAndGoOutAsTheCheckerReadsThem) {
  const LiveParam p = length_param();
  EXPECT_DOUBLE_EQ(p.factor(), 1000);
  EXPECT_EQ(p.unit(), "mm");
  EXPECT_DOUBLE_EQ(p.step(), 0.05);
  EXPECT_GE(p.decimals(), 2);
  // round trip: the form's output is accepted by the checker of lesson files
  host::ParamValues values;
  base::Problems problems;
  host::ParamSource source;
  source.where = [](const std::string& pointer) { return pointer; };
  ASSERT_TRUE(host::check_params(p.json({3.1e-3, 0, 0, 0}), {p.param}, source, values, problems));
  EXPECT_NEAR(values.value[0].number[0], 3.1e-3, 1e-12);
}

TEST(LiveParams, ValuesOutsideTheRangeAreRefusedByTheSameTable) {
  const LiveParam p = length_param();
  host::ParamValues values;
  base::Problems problems;
  host::ParamSource source;
  source.where = [](const std::string& pointer) { return pointer; };
  EXPECT_FALSE(host::check_params(p.json({6e-3, 0, 0, 0}), {p.param}, source, values, problems));
}

}  // namespace
}  // namespace swage::console
