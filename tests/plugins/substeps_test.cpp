// SPDX-License-Identifier: Apache-2.0
//
// Steps that are divided (step/substeps.cpp), on a thread that is wound, taken, drawn out of its loop and crossed: it snaps from one shape
// to the next, by up to forty of its radii in a millisecond.
#include <gtest/gtest.h>

#include <string>

#include "run_lesson.hpp"
#include "test_places.hpp"

namespace swage::stage {
namespace {

// 15 s in, and again at 18.7 s, it went through itself when steps were whole
TEST(Substeps, ASnatchedThreadDoesNotPassThroughItself) {
  LessonRun attempt(SWAGE_SOURCE_DIR "/tests/plugins/half_knot/half_knot.json", "expert");
  ASSERT_EQ(attempt.problems(), "");
  while (attempt.outcome() == "running" && attempt.world().time() < 24) attempt.step();
  EXPECT_EQ(attempt.outcome(), "running") << attempt.reason() << " after " << attempt.world().time() << " s";
  EXPECT_EQ(attempt.signal("suture", "thread.passed"), 0);
  EXPECT_EQ(attempt.signal("winding", "winding.passages"), 0);
  EXPECT_LT(attempt.metric("wound.gap"), 0.3e-3) << "the crossed strands draw the edges together";
  EXPECT_EQ(attempt.engine().quarantined(), 0u);
  EXPECT_GT(attempt.engine().divided(), 10u);
  EXPECT_LT(attempt.engine().divided(), 2000u) << "few steps are divided";
}

// what a divided step takes back and leaves is whole: with the state saved and restored before every step it ends the same
TEST(Substeps, ADividedStepLeavesNothingBesideTheState) {
  const std::string lesson = SWAGE_SOURCE_DIR "/tests/plugins/half_knot/half_knot.json";
  LessonRun plain(lesson, "expert"), restored(lesson, "expert");
  ASSERT_EQ(plain.problems() + restored.problems(), "");
  const double h = plain.world().dt;
  while (plain.engine().divided() < 10 && plain.world().time() < 24) {
    plain.step();
    ASSERT_TRUE(restored.save_and_restore());
    restored.step();
    ASSERT_EQ(plain.engine().hash(), restored.engine().hash()) << "at " << plain.world().time() << " s";
    ASSERT_EQ(plain.world().dt, h);
  }
  EXPECT_GE(plain.engine().divided(), 10u);
  EXPECT_EQ(plain.engine().divided(), restored.engine().divided());
}

}  // namespace
}  // namespace swage::stage
