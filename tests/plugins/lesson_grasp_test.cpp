// SPDX-License-Identifier: Apache-2.0
//
// The grasp lesson through the boundary: marks, cues, phases, metrics and the verdict; what the scene lacks. Its judge has
// lesson_grasp_judge_test.cpp.
#include "lesson_stage.hpp"
#include "lessons/common/sentences.hpp"

namespace swage::lesson_grasp {
namespace {

/// The plugin on a small scene.
class OnStage : public ::testing::Test, public stage::LessonStage {
 protected:
  OnStage() : LessonStage("swage.lesson.grasp", {"needle"}) {}
  bool tells(const char* id) const { return metrics.contains(stage.index_of(SWAGE_DECLARE_METRIC, id)); }
  void move_it(const stage::Params& params);
};

TEST_F(OnStage, PassesAndSaysSo) {
  ASSERT_EQ(bind({{"hold_time", 0.5}}), SWAGE_OK);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_EQ(marks[0].kind, SWAGE_MARK_ARC_RANGE);
  EXPECT_EQ(marks[0].object, 1u);
  EXPECT_EQ(marks[0].number[1], 0.75);
  start();
  observe(100);
  EXPECT_EQ(phase, stage.index_of(SWAGE_DECLARE_PHASE, "approach"));
  EXPECT_EQ(cues[1], SWAGE_NONE);
  hold(0, 0.6, 0.6);
  observe(10);
  EXPECT_EQ(cues[1], cue("grasp.good"));
  EXPECT_EQ(phase, stage.index_of(SWAGE_DECLARE_PHASE, "hold"));
  observe(600);
  EXPECT_EQ(ends, 1);
  EXPECT_EQ(passed, 1);
  EXPECT_EQ(reason, SWAGE_NONE);
  EXPECT_NEAR(score, 100, 1e-9);
  EXPECT_EQ(metric("grasp.tries"), 1);
  EXPECT_EQ(metric("hold.progress"), 1);
  EXPECT_NEAR(metric("force.mean"), 0.6, 0.02);  // the filter needs its time at the start
}

/// What is told of a needle that is held for 0.3 s and moved by 1 mm in between.
void OnStage::move_it(const stage::Params& params) {
  ASSERT_EQ(bind(params), SWAGE_OK);
  start();
  observe(10);
  hold(0, 0.6, 0.6);
  observe(100);
  X_WB[3].p = {0, 0, 1e-3};
  observe(200);
}

TEST_F(OnStage, TellsTheForceOfALiftWhereOneIsAskedFor) {
  move_it({{"lift", 0.5e-3}});
  EXPECT_TRUE(tells("force.steadiness"));
  EXPECT_TRUE(tells("force.slip_risk"));
  EXPECT_EQ(metric("force.slip_risk"), 0);
}

TEST_F(OnStage, TellsNoForceOfALiftWhereNoneIsAskedForAndNoRestOfAHandThatHasNotSetOff) {
  move_it({});
  EXPECT_TRUE(tells("force.mean"));
  EXPECT_FALSE(tells("force.steadiness"));
  EXPECT_FALSE(tells("force.slip_risk"));
  EXPECT_FALSE(tells("time.idle"));
}

TEST_F(OnStage, FailsWithAReason) {
  ASSERT_EQ(bind({{"max_over_time", 0.2}}), SWAGE_OK);
  start();
  hold(0, 0.6, 1.5);
  observe(1000);
  EXPECT_EQ(ends, 1);
  EXPECT_EQ(passed, 0);
  EXPECT_EQ(reason, stage.index_of(SWAGE_DECLARE_EVENT, "failed.too_hard"));
  EXPECT_EQ(cues[0], cue("grip.too_hard"));
}

TEST_F(OnStage, SaysWhatTheSceneLacks) {
  signals.pop_back();
  EXPECT_LT(bind({{"needle", std::string("nadle")}}), 0);
  EXPECT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0], lessons::say::kNoObject("nadle", "holder, needle"));
  problems.clear();
  EXPECT_LT(bind({{"gripper", std::string("needle")}}), 0);
  EXPECT_EQ(problems.size(), 1u);
  problems.clear();
  EXPECT_LT(bind(), 0);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].starts_with("\"grasp\"")) << problems[0];
  EXPECT_NE(problems[0].find("\"grasp.balance\", " + lessons::say::kWatched()), std::string::npos) << problems[0];
  EXPECT_NE(problems[0].find(": grasp."), std::string::npos) << problems[0];
  problems.clear();
  signals.clear();
  EXPECT_LT(bind(), 0);
  EXPECT_EQ(problems.size(), 1u);
}

TEST_F(OnStage, RefusesAnEmptyRegion) {
  EXPECT_LT(stage.configure({{"region", std::vector<double>{0.75, 0.5}}}), 0);
  ASSERT_EQ(stage.errors.size(), 1u);
}

}  // namespace
}  // namespace swage::lesson_grasp
