// SPDX-License-Identifier: Apache-2.0
//
// A needle from one tool to the other: by two scripted hands that answer each other, and by one mouse with Tab.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "run_lesson.hpp"
#include "test_places.hpp"
#include "two_tools.hpp"

namespace swage::stage {
namespace {

const std::string kPass = SWAGE_SOURCE_DIR "/lessons/series/045_pass_the_needle.json";

// Two hands answer each other by what they do: the taker comes when the needle is there, the giver lets go when it is held.
TEST(Pass, TwoHandsPassTheNeedle) {
  LessonRun attempt(kPass, "expert");
  ASSERT_EQ(attempt.problems(), "");
  double both_s = 0, nobody_s = 0, first_s = -1;
  while (attempt.outcome() == "running" && attempt.world().time() < 40) {
    attempt.step();
    const bool first = attempt.signal("grasp_first", "grasp.force") > 0.05, second = attempt.signal("grasp_second", "grasp.force") > 0.05;
    if (first && first_s < 0) first_s = attempt.world().time();
    both_s += first && second ? 1e-3 : 0;
    nobody_s += first_s >= 0 && !first && !second ? 1e-3 : 0;
  }
  EXPECT_EQ(attempt.outcome(), "passed") << attempt.reason() << " in phase " << attempt.phase() << " after " << attempt.world().time();
  EXPECT_EQ(attempt.metric("pass.count"), 1);
  EXPECT_EQ(attempt.metric("pass.snatches"), 0);
  EXPECT_EQ(attempt.happened("pass.done"), 1);
  EXPECT_GT(both_s, 0.5);
  EXPECT_EQ(nobody_s, 0) << "somebody always holds it";
  EXPECT_EQ(attempt.engine().quarantined(), 0u);
}

/// The place on the needle at which it is level.
toolkit::Vec3 level_place(const LessonRun& run) {
  using toolkit::Vec3, toolkit::Pose;
  Vec3 best = Vec3::Zero();
  double least = 1;
  for (const snapshot::CardShape& s : run.rig().card.shapes) {
    if (s.body != run.body("needle") || !(s.arc_radius > 0)) continue;
    const Pose X_WS = Pose(run.world().X_WB[s.body]) * Pose(s.X_BS);
    for (double a = 0; a <= s.sweep; a += 0.01) {
      const double slope = std::abs((X_WS.q * Vec3(-std::sin(a), std::cos(a), 0)).z());
      if (slope < least) least = slope, best = X_WS * Vec3(s.arc_radius * Vec3(std::cos(a), std::sin(a), 0));
    }
  }
  return best;
}

TEST(Pass, OneMouseAndTabAreEnough) {
  using toolkit::Vec3;
  LessonRun attempt(kPass, "mouse");
  ASSERT_EQ(attempt.problems(), "");
  TwoTools person(attempt);
  person.wait(0.3);
  ASSERT_TRUE(person.lead("first", {-0.7e-3, 0, 2.392e-3}));
  person.close();
  ASSERT_NEAR(attempt.signal("grasp_first", "grasp.force"), 0.6, 0.1);
  ASSERT_TRUE(person.lead("first", {-0.7e-3, 0, 6.4e-3}));
  person.tab();
  person.wait(0.5);
  const Vec3 stays = toolkit::vec(attempt.world().X_WB[attempt.body("first")].p);
  // where the needle is level its radius is upright: the second comes as it stands
  const Vec3 top = level_place(attempt);
  ASSERT_TRUE(person.lead("second", {-2e-3, top.y(), top.z()}));
  ASSERT_TRUE(person.lead("second", {0.6e-3, top.y(), top.z()}));
  person.close();
  ASSERT_NEAR(attempt.signal("grasp_second", "grasp.force"), 0.6, 0.1);
  EXPECT_LT((toolkit::vec(attempt.world().X_WB[attempt.body("first")].p) - stays).norm(), 1e-9);
  EXPECT_NEAR(attempt.signal("grasp_first", "grasp.force"), 0.6, 0.15) << "it stays and holds";
  person.wait(0.5);
  person.tab();
  person.open();
  person.lead("first", {3e-3, 0, 6.4e-3});
  person.wait(4);
  EXPECT_EQ(attempt.outcome(), "passed") << attempt.phase();
  EXPECT_EQ(attempt.metric("pass.count"), 1);
  EXPECT_EQ(attempt.metric("grasp.drops"), 0);
  EXPECT_GT(attempt.verdict().score, 80);
}

// the same hands, the taker at half and at twice its speed: nothing hangs on the clock
TEST(Pass, HandsOfAnySpeedMeet) {
  for (const char* speed : {"0.5", "2"}) {
    LessonRun attempt(kPass, {"expert", ""}, [&](auto& file) {
      for (auto& choice : file.devices[1].choices)
        if (choice.as == "expert") choice.params.insert(choice.params.size() - 1, std::string(", \"speed\": ") + speed);
    });
    ASSERT_EQ(attempt.problems(), "");
    attempt.run(60);
    EXPECT_EQ(attempt.outcome(), "passed") << speed << ": " << attempt.phase();
    EXPECT_EQ(attempt.metric("grasp.drops"), 0);
  }
}

}  // namespace
}  // namespace swage::stage
