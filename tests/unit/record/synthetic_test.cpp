// SPDX-License-Identifier: Apache-2.0
#include "record/synthetic.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "attempt.hpp"
#include "judge/learning.hpp"
#include "record/progress.hpp"
#include "record/school.hpp"
#include "record/sentences.hpp"

namespace swage::record::test {
namespace {

using testing::HasSubstr;

// an attempt of a hand with these numbers
std::string hand(const std::string& store, double score, double seconds, double tries, double time,
                 const std::string& failed_for = "") {
  base::Problems problems;
  AttemptInfo info = make_info();
  info.mode = "test";
  for (HandInfo& h : info.hands) h.flags |= SWAGE_DEVICE_SCRIPTED;
  const auto recorder = Recorder::open(store, info, problems);
  for (uint64_t i = 0; i < 300; ++i) recorder->step(make_step(7, i));
  AttemptEnd end = make_end();
  end.score = score;
  end.simulated_s = seconds;
  end.metric[0] = tries;
  end.metric[1] = time;
  if (!failed_for.empty()) end.outcome = judge::Outcome::kFailed, end.reason = failed_for;
  recorder->finish(end);
  return recorder->attempt_id();
}

class Synthetic : public testing::Test {
 protected:
  Synthetic() {
    school_.from = folder_ / "hands.db";
    school_.lessons = {{hand(school_.from, 98, 10, 1, 8.5), {hand(school_.from, 60, 30, 4, 28.5), hand(school_.from, 50, 40, 5, 38.5)}}};
    school_.people = 10;
    school_.attempts = 300;
    school_.recordings = 4;
  }
  Folder folder_;
  SyntheticSchool school_;
  std::string path_ = folder_ / "a.db", error_;
};

TEST_F(Synthetic, IsMarkedInEveryAttemptAndWhole) {
  ASSERT_TRUE(write_synthetic_school(path_, school_, error_)) << error_;
  const auto store = Store::open(path_, error_);
  const auto attempts = store->attempts("");
  ASSERT_EQ(attempts.size(), 300u);
  for (const AttemptRow& a : attempts) {
    EXPECT_TRUE(a.is_synthetic);
    EXPECT_FALSE(a.is_scripted);
    EXPECT_EQ(a.state, "complete");
    EXPECT_THAT(a.person_name, testing::StartsWith("Synthetic "));
    EXPECT_TRUE(a.simulated_s >= 1 && a.simulated_s < 80) << a.simulated_s;
  }
  // the same list without metrics, for pages that show everybody
  const auto heads = store->attempt_heads();
  ASSERT_EQ(heads.size(), attempts.size());
  for (size_t i = 0; i < heads.size(); ++i) {
    EXPECT_EQ(heads[i].id, attempts[i].id);
    EXPECT_EQ(heads[i].score, attempts[i].score);
    EXPECT_TRUE(heads[i].metrics.empty());
    EXPECT_FALSE(attempts[i].metrics.empty());
  }
  const std::string somebody = attempts[0].person_id;
  EXPECT_EQ(store->attempt_heads(somebody).size(), store->attempts(somebody).size());
  EXPECT_TRUE(store->attempt_heads("", "no.such").empty());
  EXPECT_EQ(store->damage(), "");
  int with_recording = 0;
  for (std::size_t i = 0; i < 10; ++i) {
    Recording r;
    if (read_recording(path_, attempts[i].id, r, error_) && r.step.size() == 300) ++with_recording;
  }
  EXPECT_EQ(with_recording, 4);
  EXPECT_FALSE(write_synthetic_school(path_, school_, error_));
  EXPECT_THAT(error_, HasSubstr(say::kSyntheticAlready(path_)));
}

TEST_F(Synthetic, WhatHoldsInEveryRealAttemptHoldsInEachDrawnOne) {
  // the first metric is never above the second, and only a failed attempt has it below 1
  const auto real = [&](double score, double mean, double peak, const char* failed_for = "") {
    return hand(school_.from, score, 10, mean, peak, failed_for);
  };
  school_.lessons = {{real(98, 1.2, 1.21), {real(60, 4.4, 4.4), real(50, 6.1, 6.15)}, {real(0, 0.5, 0.5, "failed.late"), real(0, 0.3, 0.31, "failed.late")}}};
  ASSERT_TRUE(write_synthetic_school(path_, school_, error_)) << error_;
  int failed = 0;
  for (const AttemptRow& a : Store::open(path_, error_)->attempts("")) {
    EXPECT_LE(a.metrics[0].value, a.metrics[1].value + 1e-12) << "a mean above its peak";
    EXPECT_EQ(a.outcome == "failed", a.metrics[0].value < 1) << a.outcome << " " << a.metrics[0].value;
    EXPECT_EQ(a.reason == "failed.late", a.outcome == "failed");
    EXPECT_TRUE(a.outcome != "failed" || a.score == 0);
    failed += a.outcome == "failed";
  }
  EXPECT_GT(failed, 20);
}

TEST_F(Synthetic, LearnsAndItsExpertsDoNotNeedTo) {
  school_.attempts = 600;
  ASSERT_TRUE(write_synthetic_school(path_, school_, error_)) << error_;
  const auto store = Store::open(path_, error_);
  const auto school = School::open(path_, error_);
  std::string experts;
  for (const Group& g : school->groups())
    if (g.name == "Experts") experts = g.id;
  const Course course = school->courses().at(0);
  int levels = 0, passed = 0, masters = 0;
  for (const Person& p : school->people()) {
    const auto attempts = store->attempts(p.id);
    std::vector<double> time;
    for (auto a = attempts.rbegin(); a != attempts.rend(); ++a) time.push_back(a->metrics[1].value);
    const double first = judge::quantile({time.begin(), time.begin() + 5}, 0.5), last = judge::quantile({time.end() - 10, time.end()}, 0.5);
    if (p.group_id == experts) {
      ++masters;
      EXPECT_LT(first, 12) << p.name;
      continue;
    }
    EXPECT_GT(first, 1.3 * last) << p.name;
    levels += judge::fit_curve(time).fitted;
    passed += standing(course, attempts)[0].rule.passed;
  }
  EXPECT_EQ(masters, 1);
  EXPECT_EQ(levels, 9);
  EXPECT_GT(passed, 0) << "somebody passes the course";
}

TEST_F(Synthetic, ExpertsDoNotJoinRealOnes) {
  Group real{"", "Experts", "", ""};
  ASSERT_TRUE(School::open(path_, error_)->add_group(real)) << error_;
  ASSERT_TRUE(write_synthetic_school(path_, school_, error_)) << error_;
  const auto school = School::open(path_, error_);
  std::vector<std::string> groups;
  for (const Group& g : school->groups()) groups.push_back(g.name);
  EXPECT_THAT(groups, testing::UnorderedElementsAre("Experts", "Synthetic experts", "Synthetic residents"));
  for (const Person& p : school->people()) EXPECT_NE(p.group_id, real.id) << p.name;
}

TEST_F(Synthetic, TheSameSeedDrawsTheSameNumbers) {
  const auto scores = [&](const std::string& path, uint64_t seed) {
    school_.seed = seed;
    EXPECT_TRUE(write_synthetic_school(path, school_, error_)) << error_;
    std::vector<double> out;
    for (const AttemptRow& a : Store::open(path, error_)->attempts("")) out.push_back(a.score);
    std::sort(out.begin(), out.end());
    return out;
  };
  const auto one = scores(folder_ / "1.db", 5);
  EXPECT_EQ(one, scores(folder_ / "2.db", 5));
  EXPECT_NE(one, scores(folder_ / "3.db", 6));
}

TEST_F(Synthetic, NeedsSomethingToDrawBetween) {
  school_.lessons[0].novices.clear();
  EXPECT_FALSE(write_synthetic_school(path_, school_, error_));
  EXPECT_THAT(error_, HasSubstr(say::kNeedsNovice()));
  school_.lessons.clear();
  EXPECT_FALSE(write_synthetic_school(path_, school_, error_));
  EXPECT_THAT(error_, HasSubstr(say::kSchoolNeedsLesson()));
}

}  // namespace
}  // namespace swage::record::test
