// SPDX-License-Identifier: Apache-2.0
//
// The insertion lesson through the two edges of a wound: what one bite is, where it begins anew, the step between the edges.
#include <gtest/gtest.h>

#include "insertion_attempt.hpp"

namespace swage::lesson_insertion {
namespace {

Rules two_edges() {
  Rules rules;
  rules.task = Task::kStitch;
  rules.far = {true, 0.2e-3};
  return rules;
}

/// A bite told step by step, each part of it as the couplings of both edges tell it.
struct Bite : Attempt {
  explicit Bite(const Rules& rules = two_edges()) : Attempt(rules) { hold(); }
  Finding go() {
    const Finding finding = Attempt::go();
    now.far.entered = now.far.exited = now.far.passed = now.far.deflected = false;
    return finding;
  }
  /// The bites are distances from the edges, m.
  Finding near_in(double bite) {
    now.hole.edge = bite;
    now.hole.edge_W = Vec3::UnitX();
    enter();
    return drive(0.2, 20, now.angle);
  }
  Finding near_out(double bite) {
    now.exited = true;
    now.hole.edge = bite;
    return go();
  }
  Finding far_in(double bite, double angle = 0) {
    now.far.entered = now.far.in_tissue = true;
    now.far.angle = angle, now.far.wound = 1, now.far.s = 0;
    now.far.hole.edge = bite;
    return go();
  }
  Finding far_out(double bite) {
    now.far.s = 0.2, now.s = 0.4;
    now.far.exited = true;
    now.far.hole.edge = bite;
    now.far.hole.p_W = Vec3(0, 0, 1e-3);
    return go();
  }
  Finding taken_on_the_other_side() {
    now.held = false;
    go();
    hold();
    now.grip_s = 0.1;
    return go();
  }
  Finding through() {
    now.passed = true;
    go();
    now.in_tissue = false;
    now.far.passed = true;
    now.far.s = 0.6;
    return go();
  }
};

TEST(TwoEdges, OneBiteGoesThroughBothAndTheSecondEntryIsNoSecondAttempt) {
  Bite a;
  EXPECT_EQ(a.near_in(1.2e-3).stage, Stage::kDrive);
  EXPECT_EQ(a.near_out(1.15e-3).stage, Stage::kCross);
  const Finding in = a.far_in(1.1e-3);
  EXPECT_EQ(in.stage, Stage::kCross);
  EXPECT_FALSE(in.far_first);
  EXPECT_EQ(a.memory.entries, 1);
  EXPECT_EQ(a.memory.missed, 0);
  EXPECT_EQ(a.far_out(1e-3).stage, Stage::kRelease);
  EXPECT_EQ(a.taken_on_the_other_side().stage, Stage::kPull);
  a.now.passed = true;
  EXPECT_EQ(a.go().end, End::kRunning) << "its blunt end is in the near edge alone";
  a.now.far.passed = true;
  const Finding end = a.go();
  EXPECT_EQ(end.end, End::kPassed);
  EXPECT_DOUBLE_EQ(a.memory.stitch.bite_in, 1.2e-3);
  EXPECT_DOUBLE_EQ(a.memory.stitch.bite_out, 1e-3);
  EXPECT_EQ(end.lost.step, 0) << "up to half of what is allowed";
  EXPECT_NEAR(end.lost.bites, 10 * 0.2 / 1.1, 1e-9);
  EXPECT_NEAR(end.score, 100 - end.lost.bites, 1e-9);
}

TEST(TwoEdges, TheExitWoundIsThatOfTheFarEdgesOuterSurface) {
  const auto sewn = [](double inner, double outer) {
    Bite a;
    a.near_in(1e-3), a.near_out(1e-3), a.far_in(1e-3), a.far_out(1e-3), a.taken_on_the_other_side();
    a.now.exit_wound = inner;
    a.now.far.exit_wound = outer;
    return a.through().lost.exit;
  };
  EXPECT_EQ(sewn(5, 1.5), 0);
  EXPECT_NEAR(sewn(1.5, 4), 7.5, 1e-12);
}

TEST(TwoEdges, UnlikeDepthsCostPointsAndBeyondTheStepTheAttempt) {
  const auto sewn = [](double inner_far) {
    Bite a;
    a.near_in(1e-3), a.near_out(1e-3), a.far_in(inner_far), a.far_out(1e-3), a.taken_on_the_other_side();
    return a.through();
  };
  EXPECT_NEAR(sewn(1.15e-3).lost.step, 15 * 0.5, 1e-9);
  EXPECT_NEAR(sewn(0.81e-3).lost.step, 15 * 0.9, 1e-9);
  EXPECT_EQ(sewn(0.85e-3).end, End::kPassed);
  EXPECT_EQ(sewn(1.21e-3).end, End::kStep);
  EXPECT_EQ(sewn(0.79e-3).end, End::kStep);
}

TEST(TwoEdges, OnlyByWayOfTheNearEdge) {
  Bite a;
  EXPECT_TRUE(a.far_in(1e-3).far_first) << "the near edge was passed by";
  a.now.far.in_tissue = false;
  a.go();
  a.near_in(1e-3);
  EXPECT_TRUE(a.far_in(1e-3).far_first) << "the point has not left the near edge";
  EXPECT_EQ(a.memory.far.first, 2);
  a.far_out(1e-3);
  EXPECT_EQ(a.memory.exited, 0);
  EXPECT_EQ(a.memory.stitch.out, 0);
}

TEST(TwoEdges, WhatComesBackOutBeginsThatEdgeAnew) {
  Bite a;
  a.near_in(1e-3), a.near_out(1e-3), a.far_in(1.5e-3), a.far_out(1e-3);
  a.now.far.in_tissue = false;
  EXPECT_EQ(a.go().stage, Stage::kCross) << "back in the gap";
  EXPECT_EQ(a.memory.exited, 0);
  EXPECT_EQ(FarEdge::step(a.memory.far), 0);
  a.far_in(1.05e-3);
  EXPECT_NEAR(FarEdge::step(a.memory.far), 0.05e-3, 1e-12);
  a.far_out(1e-3), a.taken_on_the_other_side();
  EXPECT_EQ(a.through().end, End::kPassed);
}

TEST(TwoEdges, AngleAndWoundOfBothEdgesCount) {
  Bite a;
  a.near_in(1e-3), a.near_out(1e-3);
  EXPECT_TRUE(a.far_in(1e-3, 0.5).angle_off);
  const double before = a.memory.travel;
  a.now.far.s = 0.25;
  a.go();
  EXPECT_NEAR(a.memory.travel - before, 0.25 * a.now.length, 1e-12);
  EXPECT_LT(in_angle_share(a.memory), 0.5);
  a.now.far.angle = 0, a.now.far.wound = 2.5;
  EXPECT_TRUE(a.go().torn);
  a.now.far.wound = 6.1;
  EXPECT_EQ(a.go().end, End::kTorn);
}

// let go between the edges the needle is stuck, and it is taken there only beyond the far one
TEST(TwoEdges, ItIsTakenBeyondTheFarEdge) {
  Bite a;
  a.near_in(1e-3), a.near_out(1e-3), a.far_in(1e-3);
  a.now.held = false;
  EXPECT_TRUE(a.go().stuck);
  a.hold();
  a.far_out(1e-3);
  a.now.held = false;
  EXPECT_FALSE(a.go().stuck) << "out of the far edge it is to be let go";
  a.hold();
  a.now.grip_s = 0.3;  // between the edges: the far one is crossed at 0.2, the near one at 0.4
  EXPECT_EQ(a.go().stage, Stage::kRetake);
  a.now.grip_s = 0.15;
  EXPECT_EQ(a.go().stage, Stage::kPull);
}

}  // namespace
}  // namespace swage::lesson_insertion
