// SPDX-License-Identifier: Apache-2.0
//
// The angle lesson through the boundary: what is shown where, questions, signs, metrics; what the scene lacks. Its judge has
// lesson_angles_judge_test.cpp.
#include "lesson_stage.hpp"

namespace swage::lesson_angles {
namespace {

class AnglesOnStage : public ::testing::Test, public stage::LessonStage {
 protected:
  AnglesOnStage() : LessonStage("swage.lesson.angles", {"needle"}) {
    objects[1].instance = &needle_.raw;
    add_object("assistant", &assistant_.raw);
    add_object("tissue", &tissue_.raw);
    gripper_.state.opening = 0.2;
  }
  toolkit::Vec3 mark(uint32_t i) { return toolkit::vec(mark_p_W[i]); }
  /// The lean that the mark asks for: in the plane x, z.
  double wanted() {
    const toolkit::Vec3 up = -mark(0).normalized();
    return std::atan2(up.x(), up.z());
  }
  /// Answers `to` the mark 1 or 2 and opens again.
  void answer(uint32_t to) {
    gripper_.state.tip_W = mark_p_W[to];
    gripper_.state.opening = 0.01;
    observe();
    gripper_.state.opening = 0.2;
    observe();
  }
  /// Shows what is wanted, step by step, until the question is put.
  template <class Show>
  void ask(Show&& show) {
    for (int i = 0; i < 1000 && !asked(); ++i) {
      show();
      observe();
    }
  }
  bool asked() { return phase == stage.index_of(SWAGE_DECLARE_PHASE, "ask"); }

  stage::FakeNeedle needle_;
  stage::FakeGripper assistant_;
  stage::FakeTissue tissue_;
};

TEST_F(AnglesOnStage, ShowsAsksAndTells) {
  ASSERT_EQ(bind({{"place", std::vector<double>{0, 0, 0}}, {"show_time", 0.1}, {"tell_time", 0.1}}),
            SWAGE_OK);
  ASSERT_EQ(marks.size(), 3u);
  start();
  observe();
  EXPECT_EQ(phase, stage.index_of(SWAGE_DECLARE_PHASE, "show"));
  EXPECT_NEAR(mark(0).norm(), 10e-6, 1e-12) << "it must not be seen which way";
  EXPECT_EQ(mark(1), mark(2)) << "no question yet";
  int sides = 0, answers = 0;
  for (int i = 0; i < 4; ++i) {
    ask([&] { needle_.lean = wanted(); });
    ASSERT_TRUE(asked());
    const toolkit::Vec3 way = mark(2) - mark(1);
    EXPECT_NEAR(way.norm(), 4e-3, 1e-9);
    const bool side = std::abs(way.x()) > 3e-3;
    sides += side ? 1 : 0;
    said.clear();
    // to the side: always right; in depth: the needle stands square, and is taken to lean away
    answer(side && wanted() < 0 ? 1 : 2);
    ++answers;
    EXPECT_FALSE(asked());
    EXPECT_EQ(cues[1], cue(side ? "answer.right" : "answer.wrong"));
    ASSERT_EQ(said.size(), 1u);
    EXPECT_NEAR(said[0].value, side ? wanted() : 0, 1e-9);
    EXPECT_EQ(metric("angle.answers"), answers);
    observe(100);
    EXPECT_EQ(cues[1], SWAGE_NONE);
  }
  EXPECT_EQ(sides, 2) << "each staircase once";
  EXPECT_NEAR(metric("angle.right"), 0.5, 1e-12);
  EXPECT_EQ(metric("view.stereo"), 0);
  EXPECT_EQ(ends, 0);
}

TEST_F(AnglesOnStage, JawsAgainstTheNeedle) {
  ASSERT_EQ(bind({{"between", 1},
                  {"place", std::vector<double>{0, 0, 0}},
                  {"sight", std::vector<double>{1, 0, 0}},
                  {"stereo", 1},
                  {"show_time", 0.1}}),
            SWAGE_OK);
  start();
  // the plane of this needle has the normal y: jaws that come from there point to -y
  assistant_.state.axis_W = {0, -1, 0};
  observe();
  EXPECT_EQ(metric("view.stereo"), 1) << "the view has two eyes";
  const toolkit::Vec3 way = mark(0).normalized();
  EXPECT_NEAR(std::acos(-way.y()) * 57.2957795, 16, 1e-3);
  ask([&] { assistant_.state.axis_W = toolkit::raw(way); });
  ASSERT_TRUE(asked());
  const toolkit::Vec3 to_other = (mark(2) - mark(1)).normalized();
  answer(-way.dot(to_other) > 0 ? 2 : 1);
  EXPECT_EQ(cues[2], cue("answer.right"));
  EXPECT_EQ(metric("view.stereo"), 1) << "as the lesson says";
}

TEST_F(AnglesOnStage, InMonoWhereTheHostSaysSo) {
  stage.eyes = SWAGE_EYES_MONO;
  ASSERT_EQ(bind({{"stereo", 1}}), SWAGE_OK);
  start();
  observe();
  EXPECT_EQ(metric("view.stereo"), 0);
}

TEST_F(AnglesOnStage, InStereoWhereTheHostSaysSo) {
  stage.eyes = SWAGE_EYES_STEREO;
  ASSERT_EQ(bind({}), SWAGE_OK);
  start();
  observe();
  EXPECT_EQ(metric("view.stereo"), 1);
}

TEST_F(AnglesOnStage, SaysWhatTheSceneLacks) {
  EXPECT_LT(bind({{"tissue", std::string("needle")}}), 0);
  ASSERT_EQ(problems.size(), 1u);
  problems.clear();
  EXPECT_LT(bind({{"assistant", std::string("tissue")}}), 0);
  ASSERT_EQ(problems.size(), 1u);
  problems.clear();
  EXPECT_EQ(bind({{"between", 1}, {"tissue", std::string("nowhere")}}), SWAGE_OK) << "jaws need no surface";
  EXPECT_LT(stage.configure({{"questions", 10}}), 0);
  EXPECT_LT(stage.configure({{"sight", std::vector<double>{0, 0, 0}}}), 0);
}

}  // namespace
}  // namespace swage::lesson_angles
