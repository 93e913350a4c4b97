// SPDX-License-Identifier: Apache-2.0
//
// The hand of the mouse: directions of every axis seen in the view, speeds, jaw, smoothing.
#include "mouse/mouse_hand.hpp"

#include "mouse_pointer.hpp"
#include "stage.hpp"

namespace swage::mouse {
namespace {

Speeds quick() {
  Speeds speeds;
  speeds.smoothing = 0;
  return speeds;
}

/// Where the hand is after holding `p` for n steps of 1 ms. Deltas count once.
MouseHand after(swage_pointer p, int n = 1, Speeds speeds = quick()) {
  MouseHand hand(speeds, Pose());
  for (int i = 0; i < n; ++i) {
    hand.step(p, 1e-3);
    p.dx = p.dy = p.wheel = 0;
  }
  return hand;
}

TEST(MouseHand, DragMovesInTheViewPlaneAndTheWheelAlongTheView) {
  swage_pointer p = still();
  p.buttons = kLeftButton;
  p.dx = 0.5;
  p.dy = 0.25;
  EXPECT_LT((after(p).pose().p - Vec3(5e-3, 0, 2.5e-3)).norm(), 1e-15);
  p = still();
  p.wheel = 3;  // away from the user
  EXPECT_LT((after(p).pose().p - Vec3(0, 0.6e-3, 0)).norm(), 1e-15);
  // without a button a movement is only a movement
  p = still();
  p.dx = 0.5;
  EXPECT_EQ(after(p).pose().p, Vec3::Zero());
}

TEST(MouseHand, RightDragTurnsTheNearSideAlong) {
  swage_pointer p = still();
  p.buttons = kRightButton;
  p.dx = 0.1;
  // the near side of the tool is at -Y; it goes to the right, +X
  EXPECT_GT((after(p).pose().q * Vec3(0, -1, 0)).x(), 0.2);
  p.dx = 0;
  p.dy = 0.1;
  EXPECT_GT((after(p).pose().q * Vec3(0, -1, 0)).z(), 0.2);
  // with control it rolls: what is up goes to the right
  p.dy = 0;
  p.dx = 0.1;
  p.modifiers = kControl;
  EXPECT_GT((after(p).pose().q * Vec3(0, 0, 1)).x(), 0.2);
}

TEST(MouseHand, KeysGiveSixAxes) {
  const auto moved = [](uint64_t key) {
    swage_pointer p = still();
    p.keys = key;
    return after(p, 1000);
  };
  const double way = Speeds{}.key_move;
  EXPECT_LT((moved(letter('d')).pose().p - Vec3(way, 0, 0)).norm(), 1e-12);
  EXPECT_LT((moved(letter('a')).pose().p - Vec3(-way, 0, 0)).norm(), 1e-12);
  EXPECT_LT((moved(letter('w')).pose().p - Vec3(0, 0, way)).norm(), 1e-12);
  EXPECT_LT((moved(letter('s')).pose().p - Vec3(0, 0, -way)).norm(), 1e-12);
  EXPECT_LT((moved(letter('q')).pose().p - Vec3(0, way, 0)).norm(), 1e-12);
  EXPECT_LT((moved(letter('e')).pose().p - Vec3(0, -way, 0)).norm(), 1e-12);
  const double turn = Speeds{}.key_turn;
  const auto turned = [&](uint64_t key) { return toolkit::log_rotation(moved(key).pose().q); };
  EXPECT_LT((turned(kRight) - Vec3(0, 0, turn)).norm(), 1e-9);
  EXPECT_LT((turned(kLeft) - Vec3(0, 0, -turn)).norm(), 1e-9);
  EXPECT_LT((turned(kDown) - Vec3(turn, 0, 0)).norm(), 1e-9);
  EXPECT_LT((turned(kUp) - Vec3(-turn, 0, 0)).norm(), 1e-9);
  EXPECT_LT((turned(kPageUp) - Vec3(0, -turn, 0)).norm(), 1e-9);
  EXPECT_LT((turned(kPageDown) - Vec3(0, turn, 0)).norm(), 1e-9);
}

// the needle's circle: about +X through a centre 3 mm below the tips, which start at the origin
Circle below() { return {{0, 0, -3e-3}, {1, 0, 0}}; }

TEST(MouseHand, KeysDriveAboutTheNeedlesCircle) {
  MouseHand hand(quick(), Pose());
  hand.set_circle(below());
  swage_pointer p = still();
  p.keys = letter('t');
  for (int i = 0; i < 1000; ++i) hand.step(p, 1e-3);
  const Quat turn = toolkit::exp_rotation(Speeds{}.key_turn * Vec3(1, 0, 0));
  EXPECT_LT((hand.pose().p - (Vec3(0, 0, -3e-3) + turn * Vec3(0, 0, 3e-3))).norm(), 1e-12);
  EXPECT_LT(toolkit::log_rotation(hand.pose().q * turn.conjugate()).norm(), 1e-9);
  p.keys = letter('g');
  for (int i = 0; i < 1000; ++i) hand.step(p, 1e-3);
  EXPECT_LT(hand.pose().p.norm(), 1e-12) << "and back the same way";
  // without a circle there is nothing to turn about
  EXPECT_EQ(after(p, 1000).pose().p, Vec3::Zero());
}

TEST(MouseHand, ADragDrivesSoThatTheTipsFollowThePointer) {
  // seen along the axis, from +X: right is +Y
  const Quat side = toolkit::exp_rotation({0, 0, 0.5 * std::numbers::pi}) * kFrontView;
  for (const bool alt : {false, true}) {
    MouseHand hand(quick(), Pose());
    hand.set_circle(below());
    swage_pointer p = still();
    p.camera = toolkit::raw(side);
    p.buttons = kLeftButton;
    p.keys = alt ? 0 : letter('c');
    p.modifiers = alt ? kAlt : 0;
    p.dx = 1e-3;
    for (int i = 0; i < 100; ++i) hand.step(p, 1e-3);
    EXPECT_NEAR((hand.pose().p - Vec3(0, 0, -3e-3)).norm(), 3e-3, 1e-12) << "they stay on the circle";
    EXPECT_NEAR(hand.pose().p.y(), 1e-3, 0.06e-3) << "1 mm to the right";
    EXPECT_NEAR(toolkit::log_rotation(hand.pose().q).x(), -std::asin(1.0 / 3), 0.02) << "and turn with it";
  }
  // a circle that is seen edge on is not driven by a drag along the line of sight, and nothing runs away
  MouseHand hand(quick(), Pose());
  hand.set_circle(below());
  swage_pointer p = still();
  p.buttons = kLeftButton;
  p.keys = letter('c');
  p.dx = p.dy = 0.1;
  hand.step(p, 1e-3);
  EXPECT_EQ(hand.pose().p, Vec3::Zero());
}

TEST(MouseHand, ShiftIsFine) {
  swage_pointer p = still();
  p.keys = letter('d');
  p.modifiers = kShift;
  EXPECT_NEAR(after(p, 1000).pose().p.x(), 0.2 * Speeds{}.key_move, 1e-12);
}

// Shift let go before the key: the stroke stays fine to its end; what is pressed after it is not.
TEST(MouseHand, AKeyThatWasPressedWithShiftStaysFine) {
  MouseHand hand(quick(), Pose());
  swage_pointer p = still();
  const auto steps = [&](uint64_t keys, uint32_t modifiers, int n) {
    p.keys = keys, p.modifiers = modifiers;
    const Vec3 from = hand.pose().p;
    for (int i = 0; i < n; ++i) hand.step(p, 1e-3);
    return Vec3(hand.pose().p - from);
  };
  const double fine = 0.2 * Speeds{}.key_move, fast = Speeds{}.key_move;
  EXPECT_NEAR(steps(letter('d'), kShift, 500).x(), 0.5 * fine, 1e-12);
  EXPECT_NEAR(steps(letter('d'), 0, 500).x(), 0.5 * fine, 1e-12);
  const Vec3 both = steps(letter('d') | letter('w'), 0, 500);
  EXPECT_NEAR(both.x(), 0.5 * fine, 1e-12);
  EXPECT_NEAR(both.z(), 0.5 * fast, 1e-12);
  EXPECT_NEAR(steps(letter('w'), kShift, 500).z(), 0.5 * fine, 1e-12) << "shift slows what is down";
  EXPECT_NEAR(steps(letter('w'), 0, 500).z(), 0.5 * fast, 1e-12) << "for as long as it is down";
  steps(0, 0, 100);
  EXPECT_NEAR(steps(letter('d'), 0, 500).x(), 0.5 * fast, 1e-12) << "pressed again";
}

// A stroke that lasts one step of the host moves by the documented least step, with shift by a fifth of it, and then ends.
TEST(MouseHand, TheShortestStrokeOfAKeyIsItsLeastStep) {
  const auto stroke = [](uint64_t keys, uint32_t modifiers, int steps) {
    MouseHand hand(quick(), Pose());
    swage_pointer p = still();
    for (int i = 0; i < 400; ++i) {
      p.keys = i < steps ? keys : 0;
      p.modifiers = i < steps ? modifiers : 0;
      hand.step(p, 1e-3);
    }
    return hand.pose();
  };
  for (const int steps : {1, 10, 25}) EXPECT_NEAR(stroke(letter('d'), 0, steps).p.x(), 0.1e-3, 1e-12) << steps << " steps";
  EXPECT_NEAR(stroke(letter('d'), kShift, 1).p.x(), 0.02e-3, 1e-12) << "shift went up with the key";
  EXPECT_NEAR(stroke(letter('d'), 0, 100).p.x(), 0.4e-3, 1e-12) << "a longer one lasts as long as the key is down";
  EXPECT_NEAR(toolkit::log_rotation(stroke(kRight, 0, 1).q).norm(), 0.025 * 0.25 * std::numbers::pi, 1e-12);
  EXPECT_EQ(stroke(kSpace | letter('c'), 0, 1).p, Vec3::Zero());
}

TEST(MouseHand, AStrokeEndsWithTheHandOver) {
  MouseHand hand(quick(), Pose());
  swage_pointer p = still();
  p.keys = letter('d');
  hand.step(p, 1e-3);
  hand.rest(1e-3);
  const Pose there = hand.pose();
  p.keys = 0;
  for (int i = 0; i < 50; ++i) hand.step(p, 1e-3);
  EXPECT_EQ(hand.pose().p, there.p);
}

TEST(MouseHand, NewSpeedsHoldFromTheNextStepAndMoveNothing) {
  swage_pointer p = still();
  p.buttons = kLeftButton;
  p.dx = 0.1;
  MouseHand hand = after(p);
  Speeds slow = quick();
  slow.drag /= 2;
  hand.set_speeds(slow);
  EXPECT_NEAR(hand.pose().p.x(), 1e-3, 1e-15);
  hand.step(p, 1e-3);
  EXPECT_NEAR(hand.pose().p.x(), 1.5e-3, 1e-15);
}

TEST(MouseHand, ClosingRestsAtTheForceOfTheLessonUntilTheKeyIsPressedAgain) {
  Speeds speeds;
  speeds.rest_force = 0.6;
  MouseHand hand(speeds, Pose());
  swage_pointer p = still();
  // jaws that touch at a closure of 0.2 and then hold with 2 N per closure
  const auto grip = [&] { return 2 * std::max(0.0, hand.closure() - 0.2); };
  const auto run = [&](double seconds) {
    for (int i = 0; i < static_cast<int>(1000 * seconds); ++i) hand.step(p, 1e-3, {grip(), 0, 0});
  };
  p.keys = kSpace;
  run(3);
  EXPECT_NEAR(grip(), 0.6, 2e-3);
  p.keys = 0;
  run(1);
  EXPECT_NEAR(grip(), 0.6, 2e-3) << "it stays when the key is let go";
  p.keys = kSpace;
  run(0.5);
  EXPECT_NEAR(grip(), 0.6 + 2 * 0.6 * 0.5, 5e-3) << "a second press goes on";
  p.keys = 0;
  run(0.1);
  p.keys = kEnter;
  run(0.5);
  EXPECT_NEAR(grip(), 0.6, 5e-3) << "opening never rests";
}

TEST(MouseHand, TheRepeatOfAHeldKeyIsNoSecondPress) {
  Speeds speeds;
  speeds.rest_force = 0.6;
  MouseHand hand(speeds, Pose());
  swage_pointer p = still();
  const auto grip = [&] { return 2 * std::max(0.0, hand.closure() - 0.2); };
  for (int ms = 0; ms < 3000; ++ms) {
    p.keys = ms > 600 && ms % 40 < 5 ? 0 : kSpace;  // up for 5 ms at each repeat
    hand.step(p, 1e-3, {grip(), 0, 0});
  }
  EXPECT_NEAR(grip(), 0.6, 2e-3);
}

TEST(MouseHand, SqueezeWhileHeldAndStay) {
  swage_pointer p = still();
  MouseHand hand(quick(), Pose());
  p.keys = kSpace;
  for (int i = 0; i < 500; ++i) hand.step(p, 1e-3);
  EXPECT_NEAR(hand.closure(), 0.3, 1e-12);
  p.keys = 0;
  for (int i = 0; i < 500; ++i) hand.step(p, 1e-3);
  EXPECT_NEAR(hand.closure(), 0.3, 1e-12);
  p.keys = letter('b');
  for (int i = 0; i < 1000; ++i) hand.step(p, 1e-3);
  EXPECT_EQ(hand.closure(), 0);
  // one hand on the mouse is enough
  p = still();
  p.buttons = kMiddleButton;
  for (int i = 0; i < 500; ++i) hand.step(p, 1e-3);
  EXPECT_NEAR(hand.closure(), 0.3, 1e-12);
  p.modifiers = kControl;
  for (int i = 0; i < 250; ++i) hand.step(p, 1e-3);
  EXPECT_NEAR(hand.closure(), 0.15, 1e-12);
  p.buttons = 0;
  p.wheel = 1;
  hand.step(p, 1e-3);
  EXPECT_NEAR(hand.closure(), 0.17, 1e-12);
  EXPECT_EQ(hand.pose().p, Vec3::Zero()) << "with control the wheel closes and does not move";
}

TEST(MouseHand, WithoutLatchTheJawsOpenAgain) {
  Speeds speeds = quick();
  speeds.latch = false;
  MouseHand hand(speeds, Pose());
  swage_pointer p = still();
  p.keys = kSpace;
  for (int i = 0; i < 500; ++i) hand.step(p, 1e-3);
  EXPECT_NEAR(hand.closure(), 0.3, 1e-12);
  p.keys = 0;
  for (int i = 0; i < 400; ++i) hand.step(p, 1e-3);
  EXPECT_EQ(hand.closure(), 0);
}

// the report of a mouse is a step; the hand must neither step nor overshoot, and must arrive
TEST(MouseHand, SmoothingTakesOutTheStep) {
  MouseHand hand(Speeds{}, Pose());
  swage_pointer p = still();
  p.buttons = kLeftButton;
  p.dx = 0.1;
  double last = 0, quickest = 0;
  for (int i = 0; i < 300; ++i) {
    hand.step(p, 1e-3);
    p.dx = 0;
    const double x = hand.pose().p.x();
    EXPECT_GE(x, last);
    quickest = std::max(quickest, (x - last) / 1e-3);
    last = x;
  }
  EXPECT_NEAR(last, 1e-3, 1e-3 * 1e-4);
  // critically damped: at most 1/e of the step per time constant
  EXPECT_LT(quickest, 1.05 * 1e-3 / 20e-3 / std::exp(1.0) * 1.03);
}

}  // namespace
}  // namespace swage::mouse
