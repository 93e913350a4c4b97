// SPDX-License-Identifier: Apache-2.0
//
// The looking lesson: signals that it is told to measure, and what it says when they are not there.
#include "lesson_stage.hpp"
#include "lessons/look/sentences.hpp"

namespace swage::stage {
namespace {

class LookOnStage : public ::testing::Test, public LessonStage {
 protected:
  LookOnStage() : LessonStage("swage.lesson.look", {"needle"}) {}
};

TEST_F(LookOnStage, TellsTheGreatestValueOfWhatItMeasures) {
  ASSERT_EQ(bind({{"duration", 0.02}, {"measures", std::string("grasp grasp.force 1,  grasp grasp.s 1")}}),
            SWAGE_OK);
  start();
  now("grasp.force") = 0.4;
  observe(5);
  now("grasp.force") = 0.9;
  now("grasp.s") = 0.6;
  observe(5);
  now("grasp.force") = 0.1;
  observe(5);
  EXPECT_EQ(metric("grasp.force"), 0.9);
  EXPECT_EQ(metric("grasp.s"), 0.6);
  EXPECT_EQ(ends, 0);
  observe(10);
  EXPECT_EQ(passed, 1);
  EXPECT_NEAR(metric("time.task"), 0.02, 1e-12);
}

TEST_F(LookOnStage, TellsTheSameSignalOfTwoCouplingsApart) {
  add_coupling("press", {"contact.force"}, {});
  add_coupling("rest", {"contact.force"}, {});
  ASSERT_EQ(bind({{"duration", 0.02},
                  {"measures", std::string("press contact.force 1, rest contact.force 1, grasp grasp.s 1")}}),
            SWAGE_OK);
  start();
  signal[signal.size() - 2] = 0.3;
  signal[signal.size() - 1] = 0.7;
  observe(5);
  EXPECT_EQ(metric("press.contact.force"), 0.3);
  EXPECT_EQ(metric("rest.contact.force"), 0.7);
  EXPECT_EQ(metric("grasp.s"), 0);
}

TEST_F(LookOnStage, NeedsNothingWhenItMeasuresNothing) {
  ASSERT_EQ(bind({{"duration", 0.001}}), SWAGE_OK);
  start();
  observe(3);
  EXPECT_EQ(passed, 1);
}

TEST_F(LookOnStage, SaysWhatIsNotThereAndWhatIsToldInAnotherUnit) {
  EXPECT_LT(bind({{"measures", std::string("needle needle.stress 1, grasp grasp.force N")}}), 0);
  ASSERT_EQ(problems.size(), 2u);
  EXPECT_TRUE(problems[0].starts_with("\"needle\" has no signal \"needle.stress\", " + lesson_look::say::kNamed() + ". It has: ")) << problems[0];
  EXPECT_EQ(problems[1], lesson_look::say::kOtherUnit("grasp.force", "1", "N"));
}

// of a name that nobody has: who there is
TEST_F(LookOnStage, SaysWhoHasSignalsWhereTheNamedOneHasNone) {
  EXPECT_LT(bind({{"measures", std::string("nobody grasp.force 1")}}), 0);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_NE(problems[0].find("those of: "), std::string::npos) << problems[0];
  EXPECT_NE(problems[0].find("grasp", problems[0].find("those of: ")), std::string::npos) << problems[0];
}

TEST_F(LookOnStage, RefusesWhatIsNotThreeWords) {
  for (const char* text : {"grasp.force", "grasp grasp.force", "grasp grasp.force 1 and more"}) {
    Stage refused("swage.lesson.look");
    EXPECT_LT(refused.configure({{"measures", std::string(text)}}), 0) << text;
  }
}

}  // namespace
}  // namespace swage::stage
