// SPDX-License-Identifier: Apache-2.0
//
// The ring lesson: what counts as a touch, as the way along the wire and as a post; what the scene must offer.
#include "lesson_stage.hpp"
#include "lessons/common/sentences.hpp"
#include "lessons/ring/judge.hpp"

namespace swage::lesson_ring {
namespace {

/// A ring of 1 mm radius on a wire of 10 mm, step by step.
class RingJudge : public ::testing::Test {
 protected:
  RingJudge() {
    rules.posts = 1;
    look.wire = {0, 0.8e-3, 1};
    look.post = {1, 10e-3, 0};
    look.touch = 15e-6;  // hangs on the wire
  }
  Finding step(int n = 1) {
    const Judge judge(rules, 1e-3);
    Finding finding;
    for (int i = 0; i < n && finding.end == End::kRunning; ++i) {
      look.time_s += 1e-3;
      finding = judge.look(memory, look);
      look.taken = false;
    }
    return finding;
  }
  void grasp() {
    look.held = look.taken = true;
    look.force = 0.5;
  }
  /// Off the wire, the wire in its middle.
  void lift() {
    look.touch = 0;
    look.wire.distance = 0;
    look.ring_W.z() += 0.8e-3;
    step(300);
  }
  /// Along the wire to this share of it, at 5 mm/s.
  void carry(double to) {
    while (look.wire.s < to) {
      look.wire.s += 5e-4;
      look.ring_W.x() += 5e-6;
      step();
    }
  }
  /// Off its free end.
  void leave() {
    look.wire.distance = 5e-3;
    step();
  }
  Rules rules;
  Memory memory;
  Look look;
};

TEST_F(RingJudge, PassesOffTheWireAndLetGoOverThePost) {
  EXPECT_EQ(step(100).stage, Stage::kTake);
  grasp();
  lift();
  carry(0.99);
  EXPECT_EQ(memory.touches, 0);
  leave();
  EXPECT_EQ(memory.free, 1);
  look.post = {0.5, 0.1e-3, 1};
  EXPECT_EQ(step(1000).end, End::kRunning) << "not let go";
  look.held = false;
  look.force = 0;
  look.ring_W.z() -= 5e-3;  // it falls to the foot of the post
  const Finding end = step(1000);
  EXPECT_EQ(end.end, End::kPassed);
  EXPECT_EQ(memory.drops, 0);
  EXPECT_DOUBLE_EQ(end.score, 100);
  EXPECT_LT(by_way(memory, memory.off2), 1e-12);
}

TEST_F(RingJudge, TouchesCountOnceTheRingIsCarried) {
  grasp();
  look.touch = 0.05;  // pressed on the wire by the closing jaws
  step(500);
  EXPECT_EQ(memory.touches, 0);
  lift();
  for (int i = 0; i < 3; ++i) {
    look.touch = 0.02;
    EXPECT_TRUE(step().touched);
    step(49);
    look.touch = 0;
    step(100);  // too short a pause
    look.touch = 0.01;
    EXPECT_FALSE(step().touched);
    look.touch = 0;
    step(200);
  }
  EXPECT_EQ(memory.touches, 3);
  EXPECT_NEAR(memory.touch_s, 3 * 0.051, 1e-9);
  EXPECT_DOUBLE_EQ(memory.touch_peak, 0.02);
}

TEST_F(RingJudge, DraggingAlongTheWireIsATouch) {
  grasp();
  look.touch = 0.02;
  carry(0.5);
  EXPECT_EQ(memory.touches, 1);
  EXPECT_GT(touch_share(memory), 0.99);
}

TEST_F(RingJudge, ARingBesideTheWireIsNotOnItsWay) {
  grasp();
  lift();
  look.wire.cosine = 0.2;  // lies on the wire, which does not go through it
  carry(0.5);
  EXPECT_EQ(memory.reached, 0);
  leave();
  EXPECT_EQ(memory.free, 0) << "left in the middle";
}

TEST_F(RingJudge, TooManyTouchesFailInATestOnly) {
  rules.max_touches = 1;
  for (const bool ends : {false, true}) {
    memory = {};
    rules.ends = ends;
    grasp();
    look.touch = 0;
    look.ring_W.z() = 0;
    step();
    lift();
    for (int i = 0; i < 2; ++i) {
      look.touch = 0.01;
      step(10);
      look.touch = 0;
      step(200);
    }
    look.touch = 0.01;
    EXPECT_EQ(step().end, ends ? End::kTouched : End::kRunning);
    look.touch = 0;
  }
}

TEST_F(RingJudge, ADropAndHardGripCostPoints) {
  rules.posts = 0;
  rules.par_time = 1000;
  grasp();
  lift();
  carry(0.5);
  look.held = false;
  look.force = 0;
  look.ring_W.z() -= 3e-3;
  EXPECT_TRUE(step().dropped);
  grasp();
  look.force = 2;
  carry(0.99);
  leave();
  const Finding end = step();
  EXPECT_EQ(memory.drops, 1);
  EXPECT_EQ(memory.passed, 1);
  EXPECT_GT(over_share(memory), 0.2);
  (void)end;
}

class OnStage : public ::testing::Test, public stage::LessonStage {
 protected:
  OnStage() : LessonStage("swage.lesson.ring", {"ring", "wire"}) {
    add_coupling("ring_wire", {"contact.force"}, {});
  }
};

TEST_F(OnStage, TellsTouchesOfTheCouplingsThatItNames) {
  ASSERT_EQ(bind({{"touches", std::string("ring_wire")}}), SWAGE_OK);
  start();
  observe(10);
  hold(0, 0.5, 0.5);
  observe(200);
  X_WB[3].p = {0.5e-3, 0, 0};
  observe(200);
  EXPECT_EQ(cues[1], cue("ring.clear"));
  now("contact.force") = 0.01;
  observe();
  EXPECT_EQ(cues[1], cue("ring.touching"));
  EXPECT_EQ(metric("ring.touches"), 1);
  EXPECT_TRUE(marks.empty()) << "no posts";
}

// what is marked is the next thing to do: the end of the wire while the ring is on it, not yet the post
struct WithAPost : public ::testing::Test, public stage::LessonStage {
  WithAPost() : LessonStage("swage.lesson.ring", {"ring", "wire", "post"}) { add_coupling("ring_wire", {"contact.force"}, {}); }
};

TEST_F(WithAPost, MarksTheEndOfTheWireBeforeThePost) {
  ASSERT_EQ(bind({{"touches", std::string("ring_wire")}, {"posts", std::string("post")}}), SWAGE_OK);
  start();
  X_WB[3].p = {0, -2e-3, 0};
  observe(10);
  ASSERT_EQ(marks.size(), 1u);
  EXPECT_NEAR(mark_p_W[0].y, 5e-3, 0.5e-3) << "of 10 mm";
  hold(0, 0.5, 0.5);
  X_WB[3].p = {0, 0, 0};
  observe(200);
  EXPECT_NEAR(mark_p_W[0].y, 5e-3, 0.5e-3);
}

TEST_F(OnStage, SaysWhatTheSceneLacks) {
  EXPECT_LT(bind({{"touches", std::string("ring_wire")}, {"posts", std::string("pole")}}), 0);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_EQ(problems[0], lessons::say::kNoObject("pole", "holder, ring, wire"));
  problems.clear();
  EXPECT_LT(bind({{"touches", std::string("grasp")}}), 0);
  ASSERT_EQ(problems.size(), 1u);
  EXPECT_TRUE(problems[0].starts_with("\"grasp\"")) << problems[0];
  EXPECT_NE(problems[0].find("\"contact.force\", " + lessons::say::kWatched()), std::string::npos) << problems[0];
  problems.clear();
  EXPECT_LT(bind(), 0);
  EXPECT_EQ(problems.size(), 1u);
}

}  // namespace
}  // namespace swage::lesson_ring
