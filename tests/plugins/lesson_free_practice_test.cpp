// SPDX-License-Identifier: Apache-2.0
//
// Free practice: what counts as a thing held, drops, both ways to end, and what the scene must offer.
#include "lesson_stage.hpp"
#include "lessons/free_practice/sentences.hpp"

namespace swage::lesson_free_practice {
namespace {

const stage::Params kTwo = {{"things", std::string("ball, rod")}, {"goal", 2}};

class Practice : public ::testing::Test, public stage::LessonStage {
 protected:
  Practice() : LessonStage("swage.lesson.free_practice", {"ball", "rod"}) {}
  int count(const char* id) {
    const uint32_t event = stage.index_of(SWAGE_DECLARE_EVENT, id);
    return static_cast<int>(
        std::count_if(said.begin(), said.end(), [&](const auto& s) { return s.event == event; }));
  }
};

TEST_F(Practice, PassesWhenDifferentThingsWereHeld) {
  ASSERT_EQ(bind(kTwo), SWAGE_OK);
  start();
  observe(10);
  hold(0, 0.5, 0.3);
  observe(400);
  EXPECT_EQ(metric("practice.different"), 0) << "not long enough";
  EXPECT_EQ(cues[1], cue("thing.held"));
  EXPECT_EQ(cues[2], SWAGE_NONE);
  observe(200);
  EXPECT_EQ(metric("practice.different"), 1);
  let_go(0);
  observe(10);
  EXPECT_EQ(cues[1], SWAGE_NONE);
  hold(0, 0.5, 0.3);  // the same again
  observe(600);
  EXPECT_EQ(metric("practice.different"), 1);
  EXPECT_EQ(ends, 0);
  let_go(0);
  hold(1, 0.5, 0.3);
  observe(600);
  EXPECT_EQ(ends, 1);
  EXPECT_EQ(passed, 1);
  EXPECT_EQ(score, 100);
  EXPECT_EQ(metric("practice.grasps"), 3);
  EXPECT_EQ(metric("practice.touches"), 3);
  EXPECT_EQ(count("thing.grasped"), 2);
}

TEST_F(Practice, CountsWhatFalls) {
  ASSERT_EQ(bind(kTwo), SWAGE_OK);
  start();
  observe(10);
  X_WB[4].p = {0, 0, -5e-3};  // the rod was knocked away
  observe(10);
  EXPECT_EQ(metric("practice.drops"), 1);
  EXPECT_EQ(metric("practice.touches"), 1) << "it was pushed by another side of the jaws";
  EXPECT_EQ(said.back().value, 1);
  X_WB[4].p = {0, 0, 0};  // somebody puts it back
  observe(10);
  X_WB[4].p = {0, 0, -5e-3};
  observe(10);
  EXPECT_EQ(count("thing.dropped"), 2);
  EXPECT_EQ(metric("practice.touches"), 2);
  hold(0, 0.5, 0.3);
  observe(10);
  let_go(0);
  X_WB[3].p = {0, 0, -5e-3};  // what was touched, and then fell, was touched once
  observe(10);
  EXPECT_EQ(metric("practice.drops"), 3);
  EXPECT_EQ(metric("practice.touches"), 3);
}

TEST_F(Practice, TimeRunsOutOnAGoal) {
  stage::Params params = kTwo;
  params.insert_or_assign("max_time", 1);
  ASSERT_EQ(bind(params), SWAGE_OK);
  start();
  hold(0, 0.5, 0.3);
  observe(1200);
  EXPECT_EQ(passed, 0);
  EXPECT_EQ(reason, stage.index_of(SWAGE_DECLARE_EVENT, "failed.out_of_time"));
  EXPECT_NEAR(score, 20, 1e-12);
}

TEST_F(Practice, WithoutAGoalTheTimeIsTheEnd) {
  ASSERT_EQ(bind({{"things", std::string("ball,rod")}, {"goal", 0}, {"max_time", 1}}), SWAGE_OK);
  start();
  hold(1, 0.5, 0.3);
  observe(1200);
  EXPECT_EQ(passed, 1);
  EXPECT_NEAR(score, 50, 1e-12);
}

TEST_F(Practice, NeedsOneGraspCouplingForEachThing) {
  EXPECT_LT(bind({{"things", std::string("ball")}, {"goal", 1}}), 0);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0], say::kGraspEach(1, 2));
}

TEST_F(Practice, RefusesAGoalThatCannotBeReached) {
  EXPECT_LT(stage.configure({{"things", std::string("ball, rod")}, {"goal", 3}}), 0);
  EXPECT_EQ(stage.errors.size(), 1u);
}

}  // namespace
}  // namespace swage::lesson_free_practice
