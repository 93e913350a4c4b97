// SPDX-License-Identifier: Apache-2.0
//
// What the sutures of the series bear and leave behind, beyond the order of the three hands (series_test.cpp).
#include <gtest/gtest.h>

#include <string>

#include "base/solver_health.hpp"
#include "run_lesson.hpp"
#include "test_places.hpp"

namespace swage::stage {
namespace suture_series_test {

const std::string kSeries = SWAGE_SOURCE_DIR "/lessons/series/";

LessonRun run(const std::string& lesson, const std::string& hand, double max_s = 60) {
  LessonRun attempt(lesson, hand);
  EXPECT_EQ(attempt.problems(), "");
  if (attempt.ready()) attempt.run(max_s);
  return attempt;
}

TEST(Suture, IsHeldWithoutASolverThatFallsShort) {
  const LessonRun expert = run(kSeries + "050_suture_grasp.json", "expert");
  ASSERT_TRUE(expert.ready());
  EXPECT_EQ(expert.outcome(), "passed");
  EXPECT_EQ(base::text(expert.engine().stats().health), "");
  EXPECT_EQ(expert.engine().quarantined(), 0u);
}

// in, out, and the thread drawn through until its tail has its length: nothing snatches, cuts or saws
TEST(Suture, IsDrawnThroughUntilItsTailHasItsLength) {
  const std::string lesson = kSeries + "118_stitch_and_pull_through.json";
  const LessonRun expert = run(lesson, "expert");
  ASSERT_TRUE(expert.ready());
  EXPECT_EQ(expert.outcome(), "passed");
  EXPECT_EQ(expert.happened("swage.pulled_off"), 0);
  EXPECT_EQ(expert.happened("pull.came_out"), 1);
  EXPECT_EQ(expert.happened("pull.went_back"), 0);
  EXPECT_NEAR(expert.metric("thread.tail"), 18e-3, 1e-3);
  EXPECT_LT(expert.metric("thread.tension"), 6e-3) << "N; the swage bears 0.14";
  EXPECT_LT(expert.metric("thread.cut"), 0.1e-3);
  EXPECT_LT(expert.metric("thread.sawn"), 0.1e-3);
  const LessonRun clumsy = run(lesson, "clumsy");
  ASSERT_TRUE(clumsy.ready());
  EXPECT_EQ(clumsy.outcome(), "failed");
  EXPECT_EQ(clumsy.reason(), "failed.torn");
}

// films hold the thread to everything it touches, and it stays on its needle
TEST(Suture, StaysOnItsNeedleInAMoistField) {
  const LessonRun expert = run(kSeries + "118_stitch_moist.json", "expert");
  ASSERT_TRUE(expert.ready());
  EXPECT_EQ(expert.outcome(), "passed");
  EXPECT_EQ(expert.happened("swage.pulled_off"), 0);
  EXPECT_EQ(base::text(expert.engine().stats().health), "");
}

}  // namespace suture_series_test
}  // namespace swage::stage
