// SPDX-License-Identifier: Apache-2.0
//
// Lesson 141: three stitches through both edges of a wound, each cut off the thread. The expert in every run; the novice and the mirror image
// are a soak.
#include <gtest/gtest.h>

#include <string>

#include "base/solver_health.hpp"
#include "one_mouse.hpp"
#include "run_lesson.hpp"
#include "test_places.hpp"

namespace swage::stage {
namespace {

const std::string kLesson = SWAGE_SOURCE_DIR "/lessons/series/141_interrupted_suture.json";
constexpr double kLongest = 200;  // s, of an attempt

LessonRun sew(const char* hand, bool mirror = false) {
  LessonRun attempt(kLesson, {hand, ""}, [&](auto& file) { file.mirror = mirror; });
  EXPECT_EQ(attempt.problems(), "");
  if (attempt.ready()) attempt.run(kLongest);
  return attempt;
}

TEST(InterruptedSuture, TheExpertSewsThreeEqualStitchesAndCutsThemOff) {
  const LessonRun expert = sew("expert");
  ASSERT_TRUE(expert.ready());
  EXPECT_EQ(expert.outcome(), "passed") << expert.reason();
  EXPECT_GT(expert.verdict().score, 80);
  EXPECT_EQ(expert.happened("cut.parted"), 3);
  EXPECT_EQ(expert.signal("suture", "thread.parted"), 2) << "the third part comes a step after the verdict";
  EXPECT_EQ(expert.happened("swage.pulled_off") + expert.happened("pull.went_back") + expert.happened("pull.went_through"), 0);
  EXPECT_EQ(expert.metric("stitch.count"), 3);
  EXPECT_EQ(expert.metric("thread.cuts_astray"), 0);
  EXPECT_LT(expert.metric("stitch.unevenness"), 0.1);
  EXPECT_LT(expert.metric("stitch.unequal_bites"), 0.3);
  EXPECT_LT(expert.metric("stitch.most_obliquity"), 0.1) << "rad";
  EXPECT_LT(expert.metric("stitch.step"), 0.1e-3) << "m";
  EXPECT_GT(expert.metric("thread.tail_least"), 2e-3) << "m";
  EXPECT_LT(expert.metric("thread.tail_most"), 4e-3) << "m";
  EXPECT_LT(expert.metric("thread.tension"), 10e-3) << "N; the swage bears 0.14";
  EXPECT_LT(expert.metric("thread.cut"), 0.2e-3) << "m";
  EXPECT_EQ(expert.engine().quarantined(), 0u);
  EXPECT_GT(expert.engine().divided(), 50u);
  EXPECT_LT(expert.engine().divided(), 500u) << "a thread that slides over the floor of the tray does not divide the step; it did in 900";
}

// At 4.06 s the needle, pinched and pressed on the tissue until it is bent, comes loose at one end and springs back. It was thrown out of the scene.
TEST(InterruptedSuture, ANeedleThatSpringsBackStaysInItsHolder) {
  LessonRun attempt(kLesson, "novice", {"seed=10"});
  ASSERT_EQ(attempt.problems(), "");
  while (attempt.outcome() == "running" && attempt.world().time() < 4.2) {
    attempt.step();
    ASSERT_LT(toolkit::vec(attempt.world().V_WB[attempt.body("needle")].v).norm(), 0.5) << "m/s at " << attempt.world().time() << " s";
  }
  EXPECT_EQ(attempt.engine().quarantined(), 0u);
  EXPECT_EQ(base::text(attempt.engine().stats().health), "");
}

TEST(InterruptedSuture, OneMouseLeadsNeedleAndScissors) {
  expect_one_mouse_leads(kLesson);
}

TEST(InterruptedSuture, TheClumsyHandTearsTheTissue) {
  const LessonRun clumsy = sew("clumsy");
  ASSERT_TRUE(clumsy.ready());
  EXPECT_EQ(clumsy.outcome(), "failed");
  EXPECT_EQ(clumsy.reason(), "failed.torn");
  EXPECT_LT(clumsy.verdict().score, 20) << "less than one stitch of three";
}

TEST(Soak, TheNovicePassesWithFewerPoints) {
  const LessonRun expert = sew("expert"), novice = sew("novice");
  ASSERT_TRUE(expert.ready() && novice.ready());
  EXPECT_EQ(novice.outcome(), "passed") << novice.reason();
  EXPECT_LT(novice.verdict().score, expert.verdict().score - 3);
}

TEST(Soak, TheLeftHandSewsTheMirrorImage) {
  const LessonRun right = sew("expert"), left = sew("expert", true);
  ASSERT_TRUE(right.ready() && left.ready());
  EXPECT_EQ(left.outcome(), "passed") << left.reason();
  EXPECT_NEAR(left.verdict().score, right.verdict().score, 1e-6);
}

}  // namespace
}  // namespace swage::stage
