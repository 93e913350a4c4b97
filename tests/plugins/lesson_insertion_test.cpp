// SPDX-License-Identifier: Apache-2.0
//
// The insertion lesson through the boundary: where the mark is drawn, cues, phases, metrics and the verdict; what the scene
// lacks. Its judge has lesson_insertion_judge_test.cpp.
#include "lesson_stage.hpp"
#include "lessons/common/sentences.hpp"
#include "lessons/insertion/sentences.hpp"

namespace swage::lesson_insertion {
namespace {

/// A needle that leads straight down into a half space, and all that the coupling that pierces would say.
class InsertionOnStage : public ::testing::Test, public stage::LessonStage {
 protected:
  InsertionOnStage() : LessonStage("swage.lesson.insertion", {"needle"}) {
    objects[1].instance = &needle_.raw;
    add_object("tissue", &tissue_.raw);
    add_coupling(
        "pierce",
        {"pierce.state", "pierce.angle", "pierce.cosine", "pierce.s", "pierce.entry_x", "pierce.entry_y",
         "pierce.entry_z", "pierce.wound", "pierce.area_ratio", "pierce.swept", "pierce.below", "pierce.pull",
         "pierce.depth", "pierce.exit_x", "pierce.exit_y", "pierce.exit_z"},
        {"pierce.entered", "pierce.exited", "pierce.passed", "pierce.deflected"});
    gripper_.state.tip_W = {0, 0, 5e-3};
  }
  /// The point is in at x [m], square.
  void enter(double x) {
    happen("pierce.entered");
    now("pierce.state") = 2;
    now("pierce.entry_x") = x;
    now("pierce.wound") = now("pierce.area_ratio") = 1;
    observe();
  }
  static stage::Params at_origin() {
    return {{"target_x", std::vector<double>{0, 0}}, {"target_y", std::vector<double>{0, 0}}};
  }

  stage::FakeNeedle needle_;
  stage::FakeTissue tissue_;
};

TEST_F(InsertionOnStage, PassesAndSaysSo) {
  ASSERT_EQ(bind(at_origin()), SWAGE_OK);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_EQ(marks[0].kind, SWAGE_MARK_POINT);
  start();
  observe();
  EXPECT_EQ(phase, stage.index_of(SWAGE_DECLARE_PHASE, "take"));
  EXPECT_EQ(mark_cues[0], SWAGE_NONE);
  hold(0, 0.6, 0.7);
  observe(800);
  EXPECT_EQ(phase, stage.index_of(SWAGE_DECLARE_PHASE, "aim"));
  EXPECT_EQ(mark_cues[0], cue("target.near"));
  enter(0.1e-3);
  EXPECT_EQ(phase, stage.index_of(SWAGE_DECLARE_PHASE, "drive"));
  EXPECT_EQ(cues[1], cue("insert.good"));
  now("pierce.angle") = 0.5;
  observe();
  EXPECT_EQ(cues[1], cue("insert.angle_off"));
  now("pierce.angle") = 0;
  now("pierce.wound") = 3;
  observe();
  EXPECT_EQ(cues[2], cue("tissue.tear"));
  now("pierce.wound") = 1;
  now("pierce.s") = 0.4;
  observe();
  EXPECT_EQ(ends, 1);
  EXPECT_EQ(passed, 1);
  EXPECT_EQ(reason, SWAGE_NONE);
  EXPECT_EQ(mark_cues[0], cue("target.done"));
  EXPECT_NEAR(metric("insert.entry_distance"), 0.1e-3, 1e-12);
  EXPECT_NEAR(metric("stitch.bite_in"), 9, 1e-9);  // 0.9 mm from the edge, 0.1 mm of wire
  EXPECT_NEAR(metric("force.mean"), 0.7, 0.02);
  EXPECT_NEAR(metric("force.peak"), 0.7, 0.02);
  EXPECT_EQ(metric("tissue.stray"), 0);
  EXPECT_EQ(metric("wound.size"), 1);
}

TEST_F(InsertionOnStage, APointThatTheTissueTurnsAwayIsSigned) {
  ASSERT_EQ(bind(at_origin()), SWAGE_OK);
  start();
  hold(0, 0.6, 0.7);
  observe(10);
  EXPECT_EQ(cues[2], SWAGE_NONE);
  happen("pierce.deflected"), observe();
  EXPECT_EQ(cues[2], cue("tissue.deflected"));
  observe(500);
  EXPECT_EQ(cues[2], cue("tissue.deflected")) << "long enough to be read";
  observe(3000);
  EXPECT_EQ(cues[2], SWAGE_NONE);
  happen("pierce.deflected"), observe();
  enter(0);
  EXPECT_EQ(cues[2], SWAGE_NONE);
}

// thesis 6.2.3 in 6.4: the four grades of a grasp, until the point goes in
TEST_F(InsertionOnStage, TheNeedleShowsHowItIsHeldUntilItGoesIn) {
  stage::Params params = at_origin();
  params.insert({"region", std::vector<double>{0.4, 0.6}});
  ASSERT_EQ(bind(params), SWAGE_OK);
  ASSERT_EQ(marks.size(), 2u);
  EXPECT_EQ(marks[1].kind, SWAGE_MARK_ARC_RANGE);
  EXPECT_EQ(std::string(marks[1].meaning.data, marks[1].meaning.size), "region.target");
  start();
  observe();
  EXPECT_EQ(cues[1], SWAGE_NONE) << "nobody holds it";
  const struct {
    double s, reach;
    const char* shown;
  } all[] = {{0.3, 0.5e-3, "grasp.wrong"}, {0.3, 0.2e-3, "grasp.tips_only"}, {0.5, 0.5e-3, "grasp.point_only"}, {0.5, 0.2e-3, "grasp.good"}};
  for (const auto& [s, reach, shown] : all) {
    hold(0, s, 0.7);
    now("grasp.tip_reach") = reach;
    observe();
    EXPECT_EQ(cues[1], cue(shown));
  }
  enter(0);
  EXPECT_EQ(cues[1], cue("insert.good")) << "from here on the angle counts";
}

// thesis D4, beside the wound about its first puncture; and the exit's
TEST_F(InsertionOnStage, TellsTheWoundAboutItsCentreAndTheExits) {
  add_coupling("pierce", {"pierce.wound_wide", "pierce.exit_wound"}, {});
  ASSERT_EQ(bind(at_origin()), SWAGE_OK);
  start();
  hold(0, 0.6, 0.7);
  observe();
  EXPECT_EQ(metrics.count(stage.index_of(SWAGE_DECLARE_METRIC, "wound.wide")), 0u);
  enter(0);
  now("pierce.wound") = 3;
  now("pierce.wound_wide") = 2;
  observe();
  EXPECT_EQ(metric("wound.size"), 3);
  EXPECT_EQ(metric("wound.wide"), 2);
  EXPECT_EQ(metrics.count(stage.index_of(SWAGE_DECLARE_METRIC, "wound.exit")), 0u) << "it is not out";
  now("pierce.exit_wound") = 1.5;
  observe();
  EXPECT_EQ(metric("wound.exit"), 1.5);
}

TEST_F(InsertionOnStage, APointThatGoesInBesideTheMarkHasLeftIt) {
  stage::Params params = at_origin();
  params.insert({"tolerance", 0.2e-3});
  ASSERT_EQ(bind(params), SWAGE_OK);
  start();
  hold(0, 0.6, 0.7);
  observe();
  enter(0.3e-3);
  EXPECT_EQ(mark_cues[0], cue("target.left"));
  EXPECT_EQ(ends, 0) << "it may be pulled out, and go in again";
}

TEST_F(InsertionOnStage, ANeedleThatIsBentStaysSigned) {
  add_coupling("needle", {"needle.stress"}, {});
  ASSERT_EQ(bind(at_origin()), SWAGE_OK);
  start();
  hold(0, 0.6, 0.7);
  now("needle.stress") = 0.99;
  observe(10);
  EXPECT_EQ(cues[1], SWAGE_NONE);
  now("needle.stress") = 1.01;
  observe();
  now("needle.stress") = 0;
  observe(100);
  EXPECT_EQ(cues[1], cue("needle.bent"));
}

TEST_F(InsertionOnStage, ANeedleThatWasDroppedIsSignedUntilItIsTakenAgain) {
  ASSERT_EQ(bind(at_origin()), SWAGE_OK);
  start();
  hold(0, 0.6, 0.7);
  observe(10);
  let_go(0);
  observe(10);
  EXPECT_EQ(cues[1], SWAGE_NONE) << "let go, but it stays";
  X_WB[objects[1].first_body].p.z -= 20e-3;
  observe(2);
  EXPECT_EQ(cues[1], cue("needle.dropped"));
  hold(0, 0.6, 0.7);
  observe();
  EXPECT_EQ(cues[1], SWAGE_NONE);
}

TEST_F(InsertionOnStage, TheEntryFromItsOwnCurve) {
  ASSERT_EQ(bind(at_origin()), SWAGE_OK);
  start();
  hold(0, 0.6, 0.7);
  observe();
  // 0.1 mm outside the circle at its point, all the way
  enter(-0.1e-3);
  now("pierce.s") = 0.2;
  observe(2);
  EXPECT_NEAR(metric("insert.arc_error"), 0.1e-3, 1e-9);
}

TEST_F(InsertionOnStage, AStitchTellsItsBitesAndMovesTheMarkOn) {
  stage::Params params = at_origin();
  params.insert({"task", 1});
  params.insert({"stitches", 2});
  params.insert({"spacing", 0.7e-3});
  params.insert({"tolerance", 0.5e-3});
  ASSERT_EQ(bind(params), SWAGE_OK);
  start();
  hold(0, 0.6, 0.7);
  observe();
  enter(0.4e-3);
  happen("pierce.exited", 0.2);
  now("pierce.exit_x") = 0.8e-3;
  now("pierce.exit_y") = 0.4e-3;
  observe();
  EXPECT_EQ(phase, stage.index_of(SWAGE_DECLARE_PHASE, "release"));
  EXPECT_EQ(metric("insert.exit_angle"), 0.2);
  EXPECT_EQ(metrics.count(stage.index_of(SWAGE_DECLARE_METRIC, "insert.exit_distance")), 0u)
      << "no mark, no distance";
  EXPECT_NEAR(metric("stitch.bite_in"), 6, 1e-9);
  EXPECT_NEAR(metric("stitch.bite_out"), 2, 1e-9);
  EXPECT_NEAR(metric("stitch.asymmetry"), 1, 1e-9);
  EXPECT_NEAR(metric("stitch.obliquity"), 0.25 * 3.14159265358979, 1e-6);
  let_go(0);
  observe();
  EXPECT_EQ(phase, stage.index_of(SWAGE_DECLARE_PHASE, "retake"));
  EXPECT_EQ(cues[1], SWAGE_NONE) << "it is let go as asked: no warning";
  now("pierce.s") = 0.8;
  hold(0, 0.2, 0.7);
  observe();
  EXPECT_EQ(phase, stage.index_of(SWAGE_DECLARE_PHASE, "pull"));
  EXPECT_EQ(mark_cues[0], cue("target.near")) << "it went in there; nothing is to be moved there";
  const swage_vec3 before = mark_p_W[0];
  happen("pierce.passed");
  observe();
  observe();
  EXPECT_EQ(mark_cues[0], SWAGE_NONE) << "the next one is yet to be reached";
  EXPECT_EQ(ends, 0);
  EXPECT_EQ(metric("stitch.count"), 1);
  EXPECT_NEAR(std::abs(mark_p_W[0].y - before.y), 0.7e-3, 1e-9);  // the edge leads along y
  EXPECT_NEAR(mark_p_W[0].x, before.x, 1e-9);
}

TEST_F(InsertionOnStage, WhereItShouldComeOutIsAMarkOfItsOwn) {
  stage::Params params = at_origin();
  params.insert({"task", 1});
  params.insert({"stitches", 2});
  params.insert({"spacing", 0.7e-3});
  params.insert({"exit", std::vector<double>{0.5e-3, 0, -1e-3}});
  ASSERT_EQ(bind(params), SWAGE_OK);
  ASSERT_EQ(marks.size(), 2u);
  EXPECT_EQ(std::string(marks[1].meaning.data, marks[1].meaning.size), "exit.point");
  start();
  hold(0, 0.6, 0.7);
  observe();
  EXPECT_EQ(mark_p_W[1].x, 0.5e-3);
  EXPECT_EQ(mark_p_W[1].z, -1e-3);
  enter(0);
  EXPECT_EQ(metrics.count(stage.index_of(SWAGE_DECLARE_METRIC, "insert.exit_distance")), 0u);
  happen("pierce.exited");
  now("pierce.exit_x") = 0.8e-3;
  now("pierce.exit_y") = 0.4e-3;
  observe();
  // 3, 4, 5; how deep the exit is does not count
  EXPECT_NEAR(metric("insert.exit_distance"), 0.5e-3, 1e-12);
  EXPECT_EQ(mark_cues[1], SWAGE_NONE) << "further off than the tolerance";
  happen("pierce.exited");
  now("pierce.exit_x") = 0.6e-3;
  now("pierce.exit_y") = 0;
  observe();
  EXPECT_NEAR(metric("insert.exit_distance"), 0.1e-3, 1e-12);
  EXPECT_EQ(mark_cues[1], cue("target.near"));

  // the next stitch takes both marks along
  let_go(0);
  observe();
  now("pierce.s") = 0.8;
  hold(0, 0.2, 0.7);
  happen("pierce.passed");
  observe();
  observe();
  EXPECT_NEAR(std::abs(mark_p_W[0].y), 0.7e-3, 1e-9);
  EXPECT_NEAR(mark_p_W[1].y, mark_p_W[0].y, 1e-12);
  EXPECT_NEAR(mark_p_W[1].x, 0.5e-3, 1e-12);
  EXPECT_EQ(mark_cues[1], SWAGE_NONE);
}

TEST_F(InsertionOnStage, FailsWithAReasonAndCountsWhatIsStray) {
  ASSERT_EQ(bind({{"max_wound", 2}, {"force", std::vector<double>{0.1, 0.5}}}), SWAGE_OK);
  start();
  needle_.at.z = 1e-3;  // away from the tissue
  gripper_.state.tip_W = {0, 0, -0.1e-3};
  hold(0, 0.6, 0.7);
  observe();
  EXPECT_EQ(cues[0], cue("grip.too_hard"));
  EXPECT_EQ(metric("tissue.stray"), 1);
  enter(0);
  now("pierce.wound") = 2.1;
  observe();
  EXPECT_EQ(passed, 0);
  EXPECT_EQ(reason, stage.index_of(SWAGE_DECLARE_EVENT, "failed.torn"));
}

TEST_F(InsertionOnStage, StrayIsWhatOfTheWholeNeedleTouchesOutsideTheRegion) {
  ASSERT_EQ(bind(at_origin()), SWAGE_OK);
  start();
  observe();
  EXPECT_EQ(metric("tissue.stray"), 0) << "the point touches at the mark";
  // the point is 0.2 mm above the mark, the wire leads away along the surface and down to it 0.8 mm off
  needle_.turn = 0.5 * 3.14159265358979;
  needle_.at.z = 0.2e-3;
  observe(10);
  EXPECT_EQ(metric("tissue.stray"), 1);
  needle_.turn = 0;
  observe(200);
  EXPECT_EQ(metric("tissue.stray"), 1);
  // square to the surface, but 0.5 mm beside the mark
  needle_.at = {-0.5e-3, 0, 0};
  observe(10);
  EXPECT_EQ(metric("tissue.stray"), 2);
}

TEST_F(InsertionOnStage, WhatIsInItsTrackOrAtItsHolesIsNotStray) {
  stage::Params params = at_origin();
  params.insert({"task", 1});
  ASSERT_EQ(bind(params), SWAGE_OK);
  start();
  hold(0, 0.6, 0.7);
  needle_.at.z = -1.1e-3;  // the point is out below; the wire crosses the surface at s = asin(0.55) / 90 deg
  now("pierce.s") = 0.371;
  now("pierce.depth") = 0.371 * stage::FakeNeedle::kRadius * stage::FakeNeedle::kSweep;
  now("pierce.exit_z") = -1e-3;
  enter(0.33e-3);
  EXPECT_EQ(metric("tissue.stray"), 0);
  happen("pierce.exited", 0);
  now("pierce.state") = 3;
  now("pierce.depth") = 0.34 * stage::FakeNeedle::kRadius * stage::FakeNeedle::kSweep;
  observe(10);
  EXPECT_EQ(metric("tissue.stray"), 0);
  // the same wire, if it had come out 0.6 mm further on: then its point would lean on the far side
  now("pierce.exit_x") = 0.6e-3;
  now("pierce.exit_y") = 0.6e-3;
  now("pierce.entry_x") = 0.9e-3;
  needle_.at.z = -1.02e-3;
  observe(10);
  EXPECT_EQ(metric("tissue.stray"), 1);
}

TEST_F(InsertionOnStage, StrayIsAJawInTheTissueAnywhereFromHingeToTip) {
  ASSERT_EQ(bind(at_origin()), SWAGE_OK);
  start();
  gripper_.state.tip_W = {-5e-3, 0, 2e-3};
  X_WB[1].p = X_WB[2].p = {0.5e-3, 0, 1e-3};
  gripper_.state.opening = 0.1;
  observe();
  EXPECT_EQ(metric("tissue.stray"), 0);
  // the tips are up, the jaws lead down to the hinge
  X_WB[1].p = X_WB[2].p = {0.5e-3, 0, -0.5e-3};
  observe(10);
  EXPECT_EQ(metric("tissue.stray"), 1);
  X_WB[1].p = X_WB[2].p = {0.5e-3, 0, 1e-3};
  observe(200);
  // nearly closed over the surface: one of the tips is below it
  gripper_.state.tip_W = {-5e-3, 0, 0.1e-3};
  observe(10);
  EXPECT_EQ(metric("tissue.stray"), 2);
}

TEST_F(InsertionOnStage, TheMarkLiesInItsFieldAndTheSameSeedDrawsItAgain) {
  ASSERT_EQ(bind({{"target_x", std::vector<double>{-1e-3, -0.5e-3}},
                  {"target_y", std::vector<double>{0.2e-3, 0.4e-3}}}),
            SWAGE_OK);
  start();
  observe();
  const swage_vec3 p = mark_p_W[0];
  EXPECT_TRUE(p.x >= -1e-3 && p.x <= -0.5e-3 && p.y >= 0.2e-3 && p.y <= 0.4e-3);
  EXPECT_EQ(p.z, 0);
  observe();
  EXPECT_EQ(mark_p_W[0].x, p.x);
}

TEST_F(InsertionOnStage, SaysWhatTheSceneLacks) {
  EXPECT_LT(bind({{"tissue", std::string("needle")}}), 0);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0], say::kNotPierced("needle"));
  problems.clear();
  signals.pop_back();
  EXPECT_LT(bind(), 0);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].starts_with("\"pierce\"")) << problems[0];
  EXPECT_NE(problems[0].find("\"pierce.exit_z\", " + lessons::say::kWatched()), std::string::npos) << problems[0];
  EXPECT_NE(problems[0].find(": pierce.state"), std::string::npos) << problems[0];
  problems.clear();
  signals.resize(7);  // nothing pierces
  EXPECT_LT(bind(), 0);
  EXPECT_EQ(problems.size(), 1u);
}

TEST_F(InsertionOnStage, RefusesAForceWithoutAWidth) {
  EXPECT_LT(stage.configure({{"force", std::vector<double>{1, 1}}}), 0);
  EXPECT_EQ(stage.errors.size(), 1u);
}

}  // namespace
}  // namespace swage::lesson_insertion
