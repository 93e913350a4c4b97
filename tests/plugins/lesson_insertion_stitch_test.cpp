// SPDX-License-Identifier: Apache-2.0
//
// The insertion lesson as a stitch: where the needle is taken again, its exit, one stitch after another.
#include <gtest/gtest.h>

#include "insertion_attempt.hpp"

namespace swage::lesson_insertion {
namespace {

/// The point is out: the needle is let go and taken between its point and the tissue.
void take_on_the_other_side(Attempt& a) {
  a.now.held = false;
  a.go();
  a.hold();
  a.now.grip_s = 0.1;
  a.go();
}

// 141: a needle that is held near its point is driven in two grasps
TEST(InsertionJudge, JawsAtTheTissueAreToTakeTheNeedleFurtherBack) {
  Rules rules;
  rules.task = Task::kStitch;
  Attempt a(rules);
  a.hold();
  a.now.grip_s = 0.35;
  a.enter();
  EXPECT_EQ(a.drive(0.2, 20, 0).stage, Stage::kDrive) << "0.6 mm are left of 4";
  EXPECT_EQ(a.drive(0.27, 20, 0).stage, Stage::kRegrasp);
  a.now.held = false;
  const Finding free = a.go();
  EXPECT_EQ(free.stage, Stage::kRegrasp);
  EXPECT_FALSE(free.stuck) << "it is let go as asked";
  a.hold();
  a.now.grip_s = 0.3;
  EXPECT_EQ(a.go().stage, Stage::kRegrasp) << "no further back";
  a.now.grip_s = 0.7;
  EXPECT_EQ(a.go().stage, Stage::kDrive);
  a.now.held = false;
  EXPECT_TRUE(a.go().stuck) << "nobody has asked for that";
}

// an insertion ends where enough of the needle is in: jaws that come to the tissue there are right
TEST(InsertionJudge, JawsReachTheTissueTooEarlyOnlyBeforeEnoughIsIn) {
  Attempt a;
  a.hold();
  a.now.grip_s = 0.4;
  a.enter();
  EXPECT_EQ(a.drive(0.27, 20, 0).stage, Stage::kDrive);
  EXPECT_EQ(a.drive(0.32, 20, 0).stage, Stage::kRegrasp);
  EXPECT_EQ(a.drive(0.36, 20, 0).end, End::kPassed) << "nothing forbids it";
}

TEST(InsertionJudge, AStitchGoesOutIsTakenThereAndComesThrough) {
  Rules rules;
  rules.task = Task::kStitch;
  Attempt a(rules);
  a.hold();
  a.enter();
  EXPECT_EQ(a.drive(0.5, 50, 0).stage, Stage::kDrive);
  a.now.exited = true;
  a.now.exit_angle = 0.2;
  EXPECT_EQ(a.go().stage, Stage::kRelease);
  a.now.held = false;
  EXPECT_EQ(a.go().stage, Stage::kRetake);
  // taken behind again: not the other side
  a.hold();
  a.now.grip_s = 0.8;
  EXPECT_EQ(a.go().stage, Stage::kRetake);
  a.now.grip_s = 0.1;
  EXPECT_EQ(a.go().stage, Stage::kPull);
  a.now.passed = true;
  EXPECT_EQ(a.go().end, End::kPassed);
  EXPECT_EQ(a.memory.exit_angle, 0.2);
}

// a wound of careful hands costs nothing at the exit, and the worst one of several stitches counts
TEST(InsertionJudge, AWideExitCostsPointsAndFailsNoStitch) {
  const auto sewn = [](double first, double second, Task task) {
    Rules rules;
    rules.task = task;
    rules.stitches = 2;
    rules.max_wound = 6;
    Attempt a(rules);
    Finding f;
    for (const double wound : {first, second}) {
      a.hold();
      a.enter();
      f = a.drive(task == Task::kInsert ? 0.36 : 0.3, 20, 0);
      a.now.exited = true;
      a.now.exit_wound = wound;
      if (task == Task::kInsert) continue;
      a.go();
      take_on_the_other_side(a);
      a.now.passed = true;
      f = a.go();
      a.now.in_tissue = false;
    }
    EXPECT_EQ(f.end, End::kPassed);
    return f.lost;
  };
  EXPECT_EQ(sewn(1.7, 2, Task::kStitch).exit, 0);
  EXPECT_NEAR(sewn(1.7, 3, Task::kStitch).exit, 15 * 0.25, 1e-12);
  EXPECT_NEAR(sewn(4, 1.7, Task::kStitch).exit, 15 * 0.5, 1e-12) << "the first of two stitches";
  EXPECT_EQ(sewn(9, 9, Task::kStitch).exit, 15) << "and not more";
  EXPECT_EQ(sewn(9, 9, Task::kStitch).wound, sewn(1, 1, Task::kStitch).wound) << "the entry's points are others";
  EXPECT_EQ(sewn(9, 9, Task::kInsert).exit, 0) << "an insertion has no exit to make";
}

TEST(InsertionJudge, TheNextStitchBeginsWhereTheLastOneEnded) {
  Rules rules;
  rules.task = Task::kStitch;
  rules.stitches = 3;
  Attempt a(rules);
  const double places[] = {0, 1e-3, 2.5e-3};
  Finding f;
  for (int i = 0; i < 3; ++i) {
    a.hold();
    a.now.hole = {Vec3(0, places[i], 0), Vec3::UnitX(), Vec3::UnitZ(), 0.3e-3};
    a.enter();
    a.drive(0.5, 20, 0);
    a.now.exited = true;
    a.now.hole = {Vec3(0.8e-3, places[i], 0), -Vec3::UnitX(), Vec3::UnitZ(), 0.5e-3};
    a.go();
    take_on_the_other_side(a);
    EXPECT_EQ(Stitches::unevenness(a.memory.stitch), -1);
    a.now.passed = true;
    f = a.go();
    EXPECT_EQ(f.stitched, i < 2);
    a.now.in_tissue = false;
    if (i == 2) break;
    EXPECT_EQ(a.go().stage, Stage::kAim);
  }
  EXPECT_EQ(f.end, End::kPassed);
  EXPECT_EQ(a.memory.stitch.count, 3);
  EXPECT_NEAR(Stitches::asymmetry(a.memory.stitch), 0.2 / 0.4, 1e-12);
  EXPECT_NEAR(Stitches::unequal(a.memory.stitch), 0.2 / 0.4, 1e-12) << "bites of 0.3 and 0.5 mm";
  EXPECT_NEAR(f.lost.bites, 10 * 0.5, 1e-12);
  EXPECT_NEAR(f.lost.even, 10 * 2 * 0.25 * std::sqrt(2.0) / 1.25, 1e-9);
  EXPECT_NEAR(f.lost.oblique, 0, 1e-6);
  EXPECT_NEAR(a.memory.stitch.oblique, 0, 1e-7);
  // distances 1 and 1.5 mm: mean 1.25, standard deviation 0.25 sqrt(2)
  EXPECT_NEAR(Stitches::unevenness(a.memory.stitch), 0.25 * std::sqrt(2.0) / 1.25, 1e-12);
}

TEST(InsertionJudge, AStitchAslantIsOblique) {
  StitchState s;
  Stitches::enter(s, {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ(), 0.3e-3});
  Stitches::exit(s, {Vec3(1e-3, 1e-3, 0), -Vec3::UnitX(), Vec3::UnitZ(), 0.3e-3}, 0.2e-3);
  EXPECT_NEAR(s.oblique, 45 * kDegree, 1e-12);
  EXPECT_EQ(Stitches::asymmetry(s), 0);
  // through a wall it may lean along the edge, not across; one that is too short has no direction; out without in is none at all
  const auto through = [&s](const Vec3& way) {
    Stitches::enter(s, {Vec3::Zero(), Vec3::UnitX(), Vec3::UnitZ(), 0.3e-3});
    Stitches::exit(s, {way, -Vec3::UnitX(), Vec3::UnitZ(), 0.3e-3}, 0.2e-3);
    return s.oblique;
  };
  EXPECT_NEAR(through({0.3e-3, 0, -1e-3}), 0, 1e-12);
  EXPECT_NEAR(through({0, -0.5e-3, -0.5e-3 * std::sqrt(3.0)}), 30 * kDegree, 1e-12);
  EXPECT_EQ(through({0.1e-3, 0.05e-3, 0}), -1);
  EXPECT_NEAR(s.most_oblique, 45 * kDegree, 1e-12) << "of all of them";
  StitchState none;
  Stitches::exit(none, {}, 0);
  EXPECT_EQ(none.out, 0);
}

}  // namespace
}  // namespace swage::lesson_insertion
