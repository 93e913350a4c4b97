// SPDX-License-Identifier: Apache-2.0
#include "judge/referee.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace swage::judge {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// a script in which another instance owns the first name of each kind, so that a missing offset shows
class RefereeTest : public ::testing::Test {
 protected:
  RefereeTest() {
    for (auto* names : {&script.metrics, &script.cues, &script.events, &script.phases})
      for (const char* id : {"other.one", "mine.one", "mine.two"}) names->push_back({"", id, "1", ""});
    script.marks.push_back({{SWAGE_MARK_POINT, 0, {}, {0.1, 0}, {1, 2, 3}}, "target.point"});
    referee.prepare(script, {1, 2}, {1, 2}, {1, 2}, {1, 2}, 3);
  }
  Script script;
  Referee referee;
};

TEST_F(RefereeTest, StartsEmpty) {
  const Verdict& v = referee.verdict();
  EXPECT_EQ(v.outcome, Outcome::kRunning);
  EXPECT_EQ(v.phase, SWAGE_NONE);
  ASSERT_EQ(v.metric.size(), 3u);
  for (double m : v.metric) EXPECT_TRUE(std::isnan(m));
  for (uint32_t c : v.object_cue) EXPECT_EQ(c, SWAGE_NONE);
  EXPECT_EQ(v.mark_p_W[0].y, 2);
}

TEST_F(RefereeTest, CountsTheLessonsNamesFromItsFirst) {
  const swage_verdict* say = referee.begin(5);
  const swage_vec3 p{7, 8, 9};
  say->metric(say, 1, 2.5);
  say->cue(say, 2, 0);
  say->mark(say, 0, 1, &p);
  say->event(say, 0, 4.0);
  say->phase(say, 1);
  const Verdict& v = referee.verdict();
  EXPECT_EQ(v.metric[2], 2.5);
  EXPECT_EQ(v.object_cue[2], 1u);
  EXPECT_EQ(v.mark_cue[0], 2u);
  EXPECT_EQ(v.mark_p_W[0].x, 7);
  EXPECT_EQ(v.phase, 2u);
  ASSERT_EQ(referee.events().size(), 1u);
  EXPECT_EQ(referee.events()[0].event, 1u);
  EXPECT_EQ(referee.events()[0].step, 5u);
  EXPECT_EQ(referee.mistakes(), 0u);

  say->cue(say, 2, SWAGE_NONE);
  say->mark(say, 0, SWAGE_NONE, nullptr);
  EXPECT_EQ(v.object_cue[2], SWAGE_NONE);
  EXPECT_EQ(v.mark_cue[0], SWAGE_NONE);
  EXPECT_EQ(v.mark_p_W[0].x, 7);
  referee.begin(6);
  EXPECT_TRUE(referee.events().empty());
}

TEST_F(RefereeTest, TheFirstEndStays) {
  const swage_verdict* say = referee.begin(9);
  say->finish(say, 1, 150, 1);
  say->finish(say, 0, 0, 0);
  referee.finish(Outcome::kVoid, 0, SWAGE_NONE, 10);
  EXPECT_EQ(referee.verdict().outcome, Outcome::kPassed);
  EXPECT_EQ(referee.verdict().score, 100);
  EXPECT_EQ(referee.verdict().reason, 2u);
  EXPECT_EQ(referee.verdict().finished_step, 9u);
  referee.clear();
  EXPECT_EQ(referee.verdict().outcome, Outcome::kRunning);
}

TEST_F(RefereeTest, MistakesChangeNothingAndAreCounted) {
  const swage_verdict* say = referee.begin(0);
  const swage_vec3 bad{0, kNaN, 0};
  say->metric(say, 2, 1.0);
  say->metric(say, 0, kNaN);
  say->cue(say, 3, 0);
  say->cue(say, 0, 2);
  say->mark(say, 1, 0, nullptr);
  say->mark(say, 0, SWAGE_NONE, &bad);
  say->event(say, 7, 0);
  say->phase(say, 2);
  say->finish(say, 1, kNaN, SWAGE_NONE);
  say->finish(say, 1, 50, 2);
  EXPECT_EQ(referee.mistakes(), 10u);
  EXPECT_EQ(referee.verdict().outcome, Outcome::kRunning);
  EXPECT_EQ(referee.verdict().phase, SWAGE_NONE);
  EXPECT_EQ(referee.verdict().mark_p_W[0].y, 2);
  EXPECT_TRUE(referee.events().empty());
}

TEST_F(RefereeTest, AFloodOfEventsIsCutOff) {
  const swage_verdict* say = referee.begin(0);
  for (int i = 0; i < 1000; ++i) say->event(say, 0, i);
  EXPECT_EQ(referee.events().size() + referee.mistakes(), 1000u);
  EXPECT_GT(referee.mistakes(), 0u);
}

}  // namespace
}  // namespace swage::judge
