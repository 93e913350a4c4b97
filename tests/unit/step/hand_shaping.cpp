// SPDX-License-Identifier: Apache-2.0
//
// What lies between a device and the scene: the law of forces, and filters of poses.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <memory>

#include "fake_scene.hpp"
#include "step/hands.hpp"
#include "step/reaction.hpp"
#include "toolkit/math.hpp"

namespace swage::step {
namespace hand_shaping_test {

swage_pose at(double x, double y, double z) { return {{x, y, z}, {1, 0, 0, 0}}; }

// a port that keeps what it was sent
class Keeper final : public DevicePort {
 public:
  void read(uint64_t, double, swage_sample&) noexcept override {}
  void send(const ToolForce& f) noexcept override { last = f; }
  ToolForce last;
};

TEST(Reaction, LawsTurnSceneForcesIntoThoseOfTheHand) {
  using host::Law, host::Reaction;
  const Reaction soft{Law::kNullZone, 0.1, {}}, knock{Law::kThreshold, 0.1, {}}, square{Law::kQuadratic, 0.2, {}};
  const Reaction table{Law::kTable, 0, {{0, 0}, {0.1, 0.5}, {0.3, 0.6}}};
  const auto all = [&](double f) {
    return std::array{felt_force({}, f), felt_force(soft, f), felt_force(knock, f), felt_force(square, f), felt_force(table, f)};
  };
  using Five = std::array<double, 5>;
  const auto near = [](const Five& a, const Five& b) {
    double worst = 0;
    for (size_t i = 0; i < 5; ++i) worst = std::max(worst, std::abs(a[i] - b[i]));
    return worst;
  };
  EXPECT_LT(near(all(0), Five{0, 0, 0, 0, 0}), 1e-15);
  EXPECT_LT(near(all(0.05), Five{0.05, 0, 0, 0.0125, 0.25}), 1e-15);
  EXPECT_LT(near(all(0.2), Five{0.2, 0.1, 0.2, 0.2, 0.55}), 1e-15);
  EXPECT_LT(near(all(0.5), Five{0.5, 0.4, 0.5, 1.25, 0.7}), 1e-15);
}

TEST(Reaction, KeepsTheDirectionAndTakesTheScaleAfterTheLaw) {
  FakeScene s;
  s.device_.device.flags = SWAGE_DEVICE_FORCE;
  s.rig.devices[0].force_scale = 10;
  s.rig.devices[0].reaction = {host::Law::kNullZone, 0.02, {}};
  Keeper keeper;
  Hands hands(s.rig, {&keeper});
  s.rig.world.X_WB = {{{0, 0, 0}, {1, 0, 0, 0}}, {{0, 0, 0}, {1, 0, 0, 0}}};
  s.rig.world.V_WB.resize(2);
  contact::ContactSet set;
  contact::Contact c;
  c.body_a = 0;
  c.body_b = 1;
  c.f_a_W = {0.03, 0, 0.04};
  set.contact.push_back(c);
  hands.send(set);
  EXPECT_NEAR(keeper.last.force.x, 0.6 * 0.3, 1e-12);
  EXPECT_NEAR(keeper.last.force.z, 0.8 * 0.3, 1e-12);
  set.contact[0].f_a_W = {0.01, 0, 0};
  hands.send(set);
  EXPECT_EQ(keeper.last.force.x, 0);
}

/// A hand that is filtered: its tool is where the filter says.
class FilteredHand : public ::testing::Test {
 protected:
  void begin(const host::HandFilters& filters) {
    s.device_.device.flags = SWAGE_DEVICE_LOCKSTEP;
    s.rig.devices[0].filters = filters;
    s.device_.exchange = [this](const swage_command*, swage_sample* out) {
      ++out->sequence;
      out->pose = pose;
      out->buttons = buttons;
      out->valid = valid;
      return swage_result{SWAGE_OK};
    };
    s.run(1);
  }
  const swage_pose& hand() {
    s.engine().fill(*shown);
    return shown->device[0].X_WD;
  }
  double x() { return hand().p.x; }

  FakeScene s;
  swage_pose pose = at(0, 0, 0);
  uint32_t buttons = 0, valid = SWAGE_VALID_POSE | SWAGE_VALID_BUTTONS;
  std::unique_ptr<snapshot::Snapshot> shown = std::make_unique<snapshot::Snapshot>();
};

TEST_F(FilteredHand, ALowPassLagsAsItsCutOffSays) {
  begin({.low_pass = 10});
  pose = at(1e-3, 0, 0);
  s.run(16);  // 1/(2 pi 10 Hz) = 15.9 ms
  EXPECT_NEAR(x(), 1e-3 * (1 - std::exp(-2 * 3.141592653589793 * 10 * 0.016)), 1e-12);
  s.run(200);
  EXPECT_NEAR(x(), 1e-3, 1e-8);
}

TEST_F(FilteredHand, ADeadBandHasPlayAndNoLeap) {
  begin({.dead_band = 0.1e-3, .dead_turn = 0.1});
  for (const double shake : {0.09e-3, -0.09e-3, 0.05e-3}) {
    pose = at(shake, 0, 0);
    pose.q = toolkit::raw(toolkit::exp_rotation({0, 0, 900 * shake}));
    s.run(1);
    EXPECT_EQ(x(), 0);
    EXPECT_EQ(hand().q.w, 1);
  }
  pose = at(0.3e-3, 0, 0);
  s.run(1);
  EXPECT_NEAR(x(), 0.2e-3, 1e-15);
  pose = at(0.15e-3, 0, 0);
  s.run(1);
  EXPECT_NEAR(x(), 0.2e-3, 1e-15) << "back through the play";
}

TEST_F(FilteredHand, ADeflectionLeads) {
  begin({.rate = 2, .dead_band = 1e-3});
  pose = at(6e-3, 0, 0);
  s.run(100);
  EXPECT_NEAR(x(), 0.1 * 2 * 5e-3, 1e-12);
  pose = at(0.9e-3, 0, 0);
  const double there = x();
  s.run(100);
  EXPECT_EQ(x(), there) << "near its rest it leads nowhere";
  // lost and back: it goes on from there
  valid = 0;
  s.run(300);
  valid = SWAGE_VALID_POSE | SWAGE_VALID_BUTTONS;
  s.run(1);
  EXPECT_NEAR(x(), there, 1e-12);
}

class ClutchedHand : public FilteredHand, public ::testing::WithParamInterface<double> {};
INSTANTIATE_TEST_SUITE_P(LowPass, ClutchedHand, ::testing::Values(0.0, 10.0));

TEST_P(ClutchedHand, StaysAndGoesOnWithoutALeap) {
  begin({.low_pass = GetParam(), .clutch = 4});
  pose.p.x = 1e-3;
  s.run(500);
  const double before = x();
  buttons = 6;
  for (int i = 0; i < 20; ++i) {  // shorter than a drop-out
    pose.p.x += 0.1e-3;
    s.run(1);
    ASSERT_EQ(x(), before);
  }
  buttons = 2;
  s.run(1);
  EXPECT_NEAR(x(), before, 1e-12);
  pose.p.x += 0.5e-3;
  s.run(500);
  EXPECT_NEAR(x(), before + 0.5e-3, 1e-8);
}

// The buttons of another device: what a foot does while both hands are at work.
class Pedal : public FilteredHand {
 protected:
  Pedal() {
    host::DeviceSlot& slot = s.rig.devices.emplace_back();
    slot.instance = foot_.instance("pedal");
    slot.device = &foot_.device;
    slot.X_WD0 = at(0, 0, 0);
    foot_.device.flags = SWAGE_DEVICE_LOCKSTEP;
    foot_.exchange = [this](const swage_command*, swage_sample* out) {
      ++out->sequence;
      out->buttons = down;
      out->valid = foot_valid;
      return swage_result{SWAGE_OK};
    };
    begin({.clutch = 2, .clutch_device = 1});
  }
  Fake foot_;
  uint32_t down = 0, foot_valid = SWAGE_VALID_BUTTONS;
};

TEST_F(Pedal, OfAnotherDeviceIsAClutch) {
  pose.p.x = 1e-3;
  buttons = 2;
  s.run(50);
  EXPECT_NEAR(x(), 1e-3, 1e-12) << "its own button is none";
  down = 2;
  s.run(2);  // the foot is read after the hand
  for (int i = 0; i < 50; ++i) {
    pose.p.x += 0.1e-3;
    s.run(1);
    ASSERT_EQ(x(), 1e-3);
  }
  down = 1;
  s.run(2);
  EXPECT_NEAR(x(), 1e-3, 1e-12) << "no leap";
  pose.p.x += 0.5e-3;
  s.run(1);
  EXPECT_NEAR(x(), 1.5e-3, 1e-12);
}

TEST_F(Pedal, ThatIsLostStaysAsItWas) {
  down = 2;
  s.run(10);
  foot_valid = 0;
  pose.p.x = 3e-3;
  s.run(300);
  EXPECT_EQ(x(), 0) << "pressed when it was pulled out";
  foot_valid = SWAGE_VALID_BUTTONS;
  down = 0;
  s.run(3);
  EXPECT_NEAR(x(), 0, 1e-12);
  foot_valid = 0;
  pose.p.x = 3.5e-3;
  s.run(3);
  EXPECT_NEAR(x(), 0.5e-3, 1e-12) << "free when it was pulled out";
}

// A lesson for the left hand is stepped as its mirror image; what is seen is where the hand is, wherever its device was placed. So an arm
// and its tool are in one place there, too.
TEST(PlacedHand, IsSeenWhereItIsInAMirroredLesson) {
  for (const bool mirror : {false, true}) {
    FakeScene s;
    s.rig.mirror = mirror;
    s.device_.device.flags = 0;  // a live arm
    host::DeviceSlot& slot = s.rig.devices[0];
    slot.motion_scale = 4;
    slot.X_WD0 = {{2e-3, -1e-3, 0.5e-3}, toolkit::raw(toolkit::exp_rotation({0.9, 0.2, -0.4}))};
    const swage_pose hand{{8e-3, 4e-3, -2e-3}, toolkit::raw(toolkit::exp_rotation({0.3, -0.2, 0.5}))};
    class Arm final : public DevicePort {
     public:
      void read(uint64_t, double, swage_sample& out) noexcept override {
        ++out.sequence;
        out.pose = X;
        out.valid = SWAGE_VALID_POSE;
      }
      void send(const ToolForce&) noexcept override {}
      swage_pose X{};
    } arm;
    arm.X = hand;
    Engine engine(s.rig, Options(), {&arm});
    for (int i = 0; i < 300; ++i) engine.step();
    auto shown = std::make_unique<snapshot::Snapshot>();
    engine.fill(*shown);
    const toolkit::Pose wanted = toolkit::Pose(slot.X_WD0) * toolkit::Pose(toolkit::vec(hand.p) / 4, toolkit::quat(hand.q));
    EXPECT_LT((toolkit::vec(shown->X_WB[0].p) - wanted.p).norm(), 1e-12) << mirror;
    EXPECT_LT((toolkit::quat(shown->X_WB[0].q).toRotationMatrix() - wanted.q.toRotationMatrix()).norm(), 1e-9) << mirror;
  }
}

}  // namespace hand_shaping_test
}  // namespace swage::step
