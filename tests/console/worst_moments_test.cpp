// SPDX-License-Identifier: Apache-2.0
//
// Worst moments, common events of two attempts, and group figures.
#include "console/models/worst_moments.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "console/models/group_figure.hpp"
#include "console/models/metric_limits.hpp"
#include "console/pages/comparison.hpp"
#include "fake_recording.hpp"
#include "fake_store.hpp"
#include "known_metrics.hpp"

namespace swage::console {
namespace {

// the force of the fake recording, with a peak of 1.7 N at 1.234 s, and the metric computed from it
struct Peaked {
  record::Recording recording = test::fake_recording(2000);
  record::AttemptRow attempt = test::fake_attempt();
  std::vector<record::EventRow> events = test::fake_events();
  Peaked() {
    test::learn_known_metrics();
    recording.signal[4 * 1233] = 1.7F;
    attempt.metrics = {{"force.peak", "N", 1.6}, {"odd.number", "1", 3}};
  }
  QVector<WorstMoment> worst(const TargetFinder& target = {}) const {
    return worst_moments(make_review(attempt, recording, events), recording, target);
  }
};

TEST(WorstMoments, AMetricLeadsToThePeakOfItsSignal) {
  const Peaked p;
  const auto worst = p.worst();
  ASSERT_EQ(worst.size(), 1);
  EXPECT_NEAR(worst[0].time_s, 1.234, 1e-9);
  EXPECT_TRUE(worst[0].what.contains("1.60")) << worst[0].what.toStdString();
  EXPECT_LT(worst[0].weight, kOverLimit);
  // above the lesson's limit it is worse, with the limit in its text
  const auto over = p.worst([](const std::string&) { return MetricTarget{{}, 0.9}; });
  EXPECT_NEAR(over[0].weight, kOverLimit + 1.6 / 0.9, 1e-9);
  EXPECT_TRUE(over[0].what.contains("0.90")) << over[0].what.toStdString();
  // a peak that keeps the limit is said to keep it
  const auto within = p.worst([](const std::string&) { return MetricTarget{{}, 2.0}; });
  EXPECT_LT(within[0].weight, kOverLimit);
  EXPECT_TRUE(within[0].what.contains("within what is asked")) << within[0].what.toStdString();
}

TEST(MetricLimits, AValueIsMarkedOutsideWhatIsAskedAndNotOnIt) {
  EXPECT_EQ(beyond(0.9, {{}, 0.9}), Beyond::kNo);
  EXPECT_EQ(beyond(0.91, {{}, 0.9}), Beyond::kAbove);
  EXPECT_EQ(beyond(0.1, {0.2, 0.9}), Beyond::kBelow);
  EXPECT_EQ(beyond(1, {0.2, 0.9}), Beyond::kAbove);
  EXPECT_EQ(beyond(0.1, {}), Beyond::kNo);
  EXPECT_EQ(beyond(std::nan(""), {0.2, 0.9}), Beyond::kNo);
  EXPECT_NE(beyond_sign(Beyond::kAbove), beyond_sign(Beyond::kBelow)) << "the direction is told without colour";
  EXPECT_EQ(beyond_sign(Beyond::kNo), "");
  EXPECT_EQ(limit_words({{}, 0.9}, "N"), QStringLiteral("At most 0.90\u202fN is asked"));
  EXPECT_EQ(limit_words({0.2, 0.9}, "N"), QStringLiteral("From 0.20\u202fN to 0.90\u202fN is asked"));
  EXPECT_EQ(limit_words({0.5, {}}, "N"), QStringLiteral("At least 0.50\u202fN is asked"));
  EXPECT_EQ(limit_words({}, "N"), "");
}

TEST(MetricLimits, OfAnAttemptBelongToItsMeasurementsNotToItsDeductions) {
  Peaked p;
  p.attempt.metrics.push_back({"points.time", "1", 3});
  Review review = make_review(p.attempt, p.recording, p.events);
  review.metrics[2].points = true;
  set_limits(review, [](const std::string& metric) { return metric == "odd.number" ? MetricTarget{} : MetricTarget{{}, 0.9}; });
  EXPECT_EQ(beyond(review.metrics[0].number, review.metrics[0].target), Beyond::kAbove);
  EXPECT_EQ(review.metrics[0].asked, QStringLiteral("At most 0.90\u202fN is asked"));
  for (int i : {1, 2}) EXPECT_EQ(review.metrics[i].target, MetricTarget()) << review.metrics[i].id;
}

TEST(WorstMoments, ANumberThatNoSignalReachedLeadsNowhere) {
  Peaked p;
  p.attempt.metrics[0].value = 5;
  EXPECT_TRUE(p.worst().isEmpty());
  p.attempt.metrics[0] = {"force.peak", "rad", 1.6};  // of another unit
  EXPECT_TRUE(p.worst().isEmpty());
}

TEST(WorstMoments, WhatEndedTheAttemptComesFirstThenMishapsThenPeaks) {
  Peaked p;
  p.attempt.outcome = "failed";
  p.attempt.reason = "failed.dropped";
  p.events.push_back({1800, 1.8, "lesson", "failed.dropped", 0});
  p.events.push_back({700, 0.7, "lesson", "needle.dropped", 0});
  const auto worst = p.worst();
  ASSERT_EQ(worst.size(), 3);
  EXPECT_DOUBLE_EQ(worst[0].time_s, 1.8);
  EXPECT_DOUBLE_EQ(worst[1].time_s, 0.7);
  EXPECT_NEAR(worst[2].time_s, 1.234, 1e-9);
  // without an event the end of the recording is used; good events and notes are no mishaps
  p.events.resize(p.events.size() - 2);
  EXPECT_DOUBLE_EQ(p.worst()[0].time_s, 2.0);
  EXPECT_EQ(p.worst().size(), 2);
}

TEST(WorstMoments, JawsThatTouchWhatTheyTakeAreNone) {
  Peaked p;
  p.attempt.metrics.clear();
  p.events = {{600, 0.6, "grasp", "grasp.touched", 0.1}};
  EXPECT_TRUE(p.worst().isEmpty());
  p.events.push_back({700, 0.7, "lesson", "ring.touched", 0.1});
  EXPECT_EQ(p.worst().size(), 1);
}

TEST(WorstMoments, AreAFewEvenWhereMuchWentWrong) {
  Peaked p;
  for (int i = 0; i < 40; ++i) p.events.push_back({static_cast<uint64_t>(i), 0.01 * i, "lesson", "needle.dropped", 0});
  EXPECT_EQ(p.worst().size(), kMostWorst);
}

TEST(CommonEvents, AreTheFirstOfEachKindThatBothHave) {
  const record::Recording recording = test::fake_recording(2000);
  auto first = test::fake_events(), other = test::fake_events();
  other[0].time_s = 0.9;
  first.push_back({600, 0.6, "grasp", "grasp.taken", 0.4});
  first.push_back({700, 0.7, "lesson", "only.here", 0});
  const auto common =
      common_events(make_review(test::fake_attempt(), recording, first), make_review(test::fake_attempt(), recording, other));
  ASSERT_EQ(common.size(), 1) << "notes and technical events align nothing";
  EXPECT_EQ(common[0].id, "grasp.taken");
  EXPECT_DOUBLE_EQ(common[0].first_s, 0.5);
  EXPECT_DOUBLE_EQ(common[0].other_s, 0.9);
}

TEST(GroupFigure, EveryJudgedAttemptIsADotOfItsLessonAndPerson) {
  auto attempts = test::sample_attempts();  // 14 of Arun in two lessons; one of Bea, aborted
  attempts[2].is_void = true;
  attempts.push_back(attempts[0]);
  attempts.back().person_id = "p3";
  attempts.back().person_name = "Abe";
  const GroupFigure f = group_figure({attempts.rbegin(), attempts.rend()}, QStringLiteral("motion.path"));
  EXPECT_EQ(f.attempts, 14);
  EXPECT_EQ(f.unit, "mm");
  EXPECT_EQ(f.lessons, QStringList({"Carry and hold", "Grasp the needle"}));
  EXPECT_EQ(f.people, QStringList({"Abe", "Arun P."})) << "in the order of their names";
  EXPECT_EQ(f.cell[0][1].dots.size(), 2);
  EXPECT_EQ(f.cell[1][1].dots.size(), 11);
  EXPECT_NEAR(f.cell[0][1].dots[0].value, 1000 * (0.09 - 0.004 * 4), 1e-9) << "the oldest first";
  EXPECT_NEAR(f.cell[0][1].mean, 1000 * (0.09 - 0.004 * 6.5), 1e-9);
  EXPECT_FALSE(f.cell[1][0].dots[0].passed);
  EXPECT_TRUE(std::isnan(f.cell[0][0].mean));
  EXPECT_DOUBLE_EQ(f.low, 0);
  EXPECT_NEAR(f.high, 90, 1e-9);
  EXPECT_EQ(group_figure(attempts, QStringLiteral("no.such")).attempts, 0);
  const GroupFigure scores = group_figure(attempts, QStringLiteral("score"));
  EXPECT_GT(scores.attempts, 0);
  EXPECT_EQ(scores.attempts, std::count_if(attempts.begin(), attempts.end(), [](const auto& a) { return !a.is_void && a.outcome == "passed"; }))
      << "who did not pass has no score";
}

}  // namespace
}  // namespace swage::console
