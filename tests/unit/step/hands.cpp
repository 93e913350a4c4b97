// SPDX-License-Identifier: Apache-2.0
#include "step/hands.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

#include "fake_scene.hpp"
#include "step/limits.hpp"
#include "toolkit/math.hpp"

namespace swage::step {
namespace {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

constexpr double kDt = 1e-3;

// a device that stands at one pose
void stand(Fake& device, swage_pose X, uint32_t valid = SWAGE_VALID_POSE) {
  device.exchange = [X, valid](const swage_command*, swage_sample* s) {
    s->pose = X;
    s->valid = valid;
    ++s->sequence;
    return swage_result{SWAGE_OK};
  };
}

swage_pose at(double x, double y, double z) { return {{x, y, z}, {1, 0, 0, 0}}; }

TEST(Hands, ToolsFollowWithTheTwistThatLeadsThere) {
  FakeScene s;
  stand(s.device_, at(1e-4, 0, 0));
  s.run(1);
  EXPECT_DOUBLE_EQ(s.tool().p.x, 1e-4);
  EXPECT_DOUBLE_EQ(s.rig.world.V_WB[0].v.x, 0.1);
  s.run(1);
  EXPECT_DOUBLE_EQ(s.tool().p.x, 1e-4);
  EXPECT_EQ(s.rig.world.V_WB[0].v.x, 0);
}

// a jump of 10 mm: never faster than the limit, never past the goal, there in the time the limit takes
TEST(Hands, AJumpBecomesASweep) {
  FakeScene s;
  stand(s.device_, at(10e-3, 0, 0));
  const double most = kMaxToolSpeed * s.rig.world.length;
  double last = 0;
  for (int i = 0; i < static_cast<int>(10e-3 / (most * kDt)) + 1; ++i) {
    s.run(1);
    EXPECT_LE(s.rig.world.V_WB[0].v.x, most * (1 + 1e-12));
    EXPECT_GE(s.tool().p.x, last);
    last = s.tool().p.x;
  }
  EXPECT_DOUBLE_EQ(s.tool().p.x, 10e-3);
}

TEST(Hands, TurnsAreLimitedAndTakeTheShortWay) {
  FakeScene s;
  const double angle = 3.0;
  stand(s.device_,
        {{0, 0, 0}, {-std::cos(angle / 2), 0, 0, -std::sin(angle / 2)}});  // the other sign of the same turn
  for (int i = 0; i < 100; ++i) {
    s.run(1);
    ASSERT_LE(s.rig.world.V_WB[0].w.z, kMaxToolTurn * (1 + 1e-9));
    ASSERT_GE(s.rig.world.V_WB[0].w.z, 0);
  }
  EXPECT_NEAR(2 * std::atan2(s.tool().q.z, s.tool().q.w), angle, 1e-12);
}

// a drift of 1e-9 rad per step: arc cosines lose it in rounding
TEST(Hands, SlowTurnsAreNotLost) {
  FakeScene s;
  int n = 0;
  s.device_.exchange = [&n](const swage_command*, swage_sample* out) {
    const double angle = 1e-9 * ++n;
    out->pose.q = {std::cos(angle / 2), std::sin(angle / 2), 0, 0};
    out->valid = SWAGE_VALID_POSE;
    return swage_result{SWAGE_OK};
  };
  for (int i = 0; i < 10; ++i) {
    s.run(1);
    ASSERT_NEAR(s.rig.world.V_WB[0].w.x, 1e-6, 1e-12);
  }
}

TEST(Hands, HandSpaceIsScaledAndTurned) {
  FakeScene s;
  s.device_.device.flags = SWAGE_DEVICE_LOCKSTEP;
  s.rig.devices[0].motion_scale = 10;
  // device +y up to world +z: a quarter turn about x
  const double h = std::sqrt(0.5);
  s.rig.devices[0].X_WD0 = {{0, 0, 1e-3}, {h, h, 0, 0}};
  stand(s.device_, at(0, 2e-3, 0));
  s.run(1);
  EXPECT_NEAR(s.tool().p.y, 0, 1e-18);
  EXPECT_NEAR(s.tool().p.z, 1e-3 * kMaxToolSpeed * kDt, 1e-15);  // on its way
  s.run(20);
  EXPECT_NEAR(s.tool().p.z, 1e-3 + 0.2e-3, 1e-15);
}

// lesson for the left hand: what the hand does is reflected in x = 0, its own left and right with it
TEST(Hands, AMirroredHandDoesTheMirrorImage) {
  FakeScene s;
  s.rig.mirror = true;
  s.device_.device.flags = SWAGE_DEVICE_LOCKSTEP;
  swage_pose hand = at(1e-3, 2e-3, 3e-3);
  hand.q = toolkit::raw(toolkit::exp_rotation({0.3, -0.2, 0.5}));
  stand(s.device_, hand);
  s.run(200);
  EXPECT_NEAR(s.tool().p.x, -1e-3, 1e-15);
  EXPECT_NEAR(s.tool().p.y, 2e-3, 1e-15);
  const Quat q = toolkit::quat(s.tool().q), q0 = toolkit::quat(hand.q);
  const auto reflected = [](const Vec3& v) { return Vec3(-v.x(), v.y(), v.z()); };
  EXPECT_LT((q * Vec3::UnitX() - reflected(q0 * Vec3::UnitX())).norm(), 1e-12);
  EXPECT_LT((q * Vec3::UnitZ() - reflected(q0 * Vec3::UnitZ())).norm(), 1e-12);
  EXPECT_LT((q * Vec3::UnitY() + reflected(q0 * Vec3::UnitY())).norm(), 1e-12);
  // and the picture shows the hand where it is
  auto shown = std::make_unique<snapshot::Snapshot>();
  s.engine().fill(*shown);
  EXPECT_NEAR(shown->X_WB[0].p.x, 1e-3, 1e-15);
  EXPECT_LT((toolkit::quat(shown->X_WB[0].q).toRotationMatrix() - q0.toRotationMatrix()).norm(), 1e-12);
}

TEST(Hands, AMirroredPointerIsTheOtherHands) {
  FakeScene s;
  s.rig.mirror = true;
  swage_pointer pointer{};
  pointer.dx = 0.1;
  pointer.dy = 0.2;
  pointer.keys = uint64_t{1} << 0 | uint64_t{1} << 22 | uint64_t{1} << 37;  // A, W, right
  pointer.camera = toolkit::raw(toolkit::exp_rotation({0.4, 0.3, 0.2}));
  s.engine().point(pointer);
  s.run(2);  // twice: the picture is not turned again
  const swage_pointer& read = s.rig.attempt.pointer;
  EXPECT_EQ(read.dx, -0.1);
  EXPECT_EQ(read.dy, 0.2);
  EXPECT_EQ(read.keys, uint64_t{1} << 3 | uint64_t{1} << 22 | uint64_t{1} << 36);
  const Quat c = toolkit::quat(pointer.camera), m = toolkit::quat(read.camera);
  const auto reflected = [](const Vec3& v) { return Vec3(-v.x(), v.y(), v.z()); };
  EXPECT_LT((m * Vec3::UnitX() + reflected(c * Vec3::UnitX())).norm(), 1e-12);
  EXPECT_LT((m * Vec3::UnitY() - reflected(c * Vec3::UnitY())).norm(), 1e-12);
}

TEST(Hands, WithoutAValidPoseNothingMoves) {
  FakeScene s;
  stand(s.device_, at(1, 1, 1), SWAGE_VALID_CLOSURE);
  s.run(5);
  EXPECT_EQ(s.tool().p.x, 0);
}

TEST(Hands, ClosureAndGripReachTheObject) {
  FakeScene s;
  s.device_.exchange = [](const swage_command*, swage_sample* out) {
    out->closure = 1.5;
    out->grip_force = 0.4;
    out->buttons = 5;
    out->pose.q.w = 1;
    out->valid = SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE | SWAGE_VALID_GRIP | SWAGE_VALID_BUTTONS;
    return swage_result{SWAGE_OK};
  };
  const swage_input* seen = nullptr;
  s.tool_.forces = [&](const swage_object_step* step) {
    seen = step->input;
    return swage_result{SWAGE_OK};
  };
  s.run(1);
  ASSERT_NE(seen, nullptr);
  EXPECT_EQ(seen->closure, 1);
  EXPECT_EQ(seen->grip_force, 0.4);
  EXPECT_EQ(seen->buttons, 5u);
  EXPECT_EQ(seen->valid, SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE | SWAGE_VALID_GRIP | SWAGE_VALID_BUTTONS);
  s.ball_.forces = [&](const swage_object_step* step) {
    seen = step->input;
    return swage_result{SWAGE_OK};
  };
  s.run(1);
  EXPECT_EQ(seen, nullptr);  // nobody leads the ball
}

TEST(Hands, ASampleThatIsNotANumberCostsTheDevice) {
  FakeScene s;
  stand(s.device_, at(1e-4, 0, 0));
  s.run(2);
  stand(s.device_, at(std::numeric_limits<double>::quiet_NaN(), 0, 0));
  s.run(2);
  EXPECT_EQ(s.rig.devices[0].instance->fault.load(), host::FaultKind::kNotFinite);
  EXPECT_EQ(s.tool().p.x, 1e-4);
  EXPECT_TRUE(s.engine().hand_gone());
}

TEST(Hands, AScriptSaysWhenItIsOver) {
  FakeScene s;
  stand(s.device_, at(0, 0, 0));
  s.run(1);
  EXPECT_FALSE(s.engine().hand_gone());
  stand(s.device_, at(0, 0, 0), SWAGE_VALID_POSE | SWAGE_VALID_DONE);
  s.run(1);
  EXPECT_TRUE(s.engine().hand_gone());
}

// Of two hands that work together one may be done before the other.
TEST(Hands, TwoScriptsAreOverWhenBothAre) {
  Fake second;  // outlives the scene that destroys its instance
  FakeScene s;
  s.rig.devices.emplace_back();
  s.rig.devices[1].device = &second.device;
  s.rig.devices[1].instance = second.instance("second");
  stand(s.device_, at(0, 0, 0), SWAGE_VALID_POSE | SWAGE_VALID_DONE);
  stand(second, at(0, 0, 0));
  s.run(1);
  EXPECT_FALSE(s.engine().hand_gone());
  stand(second, at(0, 0, 0), SWAGE_VALID_POSE | SWAGE_VALID_DONE);
  s.run(1);
  EXPECT_TRUE(s.engine().hand_gone());
}

// a port that keeps what it was sent
class Keeper final : public DevicePort {
 public:
  void read(uint64_t, double, swage_sample& sample) noexcept override {
    sample.pose.q.w = 1;
    sample.valid = SWAGE_VALID_POSE;
  }
  void send(const ToolForce& f) noexcept override { last = f; }
  ToolForce last;
};

TEST(Hands, FeelTheContactForcesInTheirOwnSpace) {
  FakeScene s;
  s.device_.device.flags = SWAGE_DEVICE_FORCE;
  s.rig.devices[0].motion_scale = 10;
  s.rig.devices[0].force_scale = 100;
  const double h = std::sqrt(0.5);
  s.rig.devices[0].X_WD0 = {{0, 0, 1e-3}, {h, h, 0, 0}};  // device +y is world +z
  Keeper keeper;
  Hands hands(s.rig, {&keeper});
  scene::World& w = s.rig.world;
  w.X_WB = {{{0, 0, 2e-3}, {1, 0, 0, 0}}, {{0, 0, 0}, {1, 0, 0, 0}}};
  w.V_WB.resize(2);
  contact::ContactSet set;
  contact::Contact c;
  c.body_a = 0;
  c.body_b = 1;
  c.p_W = {1e-3, 0, 2e-3};
  c.f_a_W = {0, 0, 0.02};
  set.contact.push_back(c);
  std::swap(c.body_a, c.body_b);  // the same force, seen from the other side
  c.f_a_W = {0, 0, -0.01};
  set.contact.push_back(c);
  hands.send(set);
  EXPECT_NEAR(keeper.last.force.y, 3.0, 1e-12);
  EXPECT_NEAR(keeper.last.force.z, 0, 1e-12);
  // torque: r = 1 mm x, f = 30 mN z: -30 uN m about y in W, which is device -z... times both scales
  EXPECT_NEAR(keeper.last.torque.z, 0.03e-3 * 100 * 10, 1e-12);
}

TEST(Hands, AMirroredHandFeelsTheMirrorImage) {
  FakeScene s;
  s.device_.device.flags = SWAGE_DEVICE_FORCE;
  s.rig.devices[0].force_scale = 1;
  s.rig.mirror = true;
  Keeper keeper;
  Hands hands(s.rig, {&keeper});
  scene::World& w = s.rig.world;
  w.X_WB = {{{1e-3, 0, 0}, {1, 0, 0, 0}}, {{0, 0, 0}, {1, 0, 0, 0}}};
  w.V_WB.resize(2);
  contact::ContactSet set;
  contact::Contact c;
  c.body_a = 0;
  c.body_b = 1;
  c.p_W = {1e-3, 2e-3, 0};
  c.f_a_W = {0.3, 0, 0.1};
  set.contact.push_back(c);
  hands.send(set);
  EXPECT_EQ(keeper.last.force.x, -0.3);
  EXPECT_EQ(keeper.last.force.z, 0.1);
  // t = r x f = (2e-4, 0, -6e-4) N m in the scene; seen in a mirror couples about its normal stay, the others turn round
  EXPECT_NEAR(keeper.last.torque.x, 2e-4, 1e-15);
  EXPECT_NEAR(keeper.last.torque.z, 6e-4, 1e-15);
}

// A hand that says nothing valid any more, and comes back elsewhere with other jaws.
class LostHand : public ::testing::Test {
 protected:
  LostHand() {
    s.rig.objects[0].follow.closure_device = 0;
    s.device_.device.flags = SWAGE_DEVICE_LOCKSTEP;
    s.device_.exchange = [this](const swage_command*, swage_sample* out) {
      *out = {};
      out->sequence = ++n;
      out->pose = pose;
      out->closure = closure;
      out->grip_force = 2 * closure;
      out->valid = valid;
      return swage_result{SWAGE_OK};
    };
    s.tool_.forces = [this](const swage_object_step* step) {
      input = *step->input;
      return swage_result{SWAGE_OK};
    };
  }
  static constexpr uint32_t kAll = SWAGE_VALID_POSE | SWAGE_VALID_CLOSURE | SWAGE_VALID_GRIP;

  FakeScene s;
  swage_pose pose = at(1e-4, 0, 0);
  double closure = 0.8;
  uint32_t valid = kAll;
  uint64_t n = 0;
  swage_input input{};
};

TEST_F(LostHand, HoldsPoseClosureAndGrip) {
  s.run(50);
  valid = 0;
  pose = at(9e-3, 9e-3, 9e-3);
  closure = 0;
  for (int i = 0; i < 1000; ++i) {
    s.run(1);
    ASSERT_EQ(s.tool().p.x, 1e-4) << i;
    ASSERT_EQ(input.closure, 0.8) << i;
    ASSERT_EQ(input.grip_force, 1.6) << i;
    ASSERT_EQ(input.valid & kAll, kAll) << "an object that asks whether the closure is valid must not open: " << i;
  }
}

TEST_F(LostHand, IsMetAgainWithoutALeap) {
  s.run(50);
  valid = 0;
  s.run(200);
  valid = kAll;
  pose = {{5e-3, 0, 1e-3}, toolkit::raw(toolkit::exp_rotation({0, 0, 0.5}))};
  s.run(1);
  EXPECT_NEAR(s.tool().p.x, 1e-4, 1e-15) << "it goes on from where it stood";
  EXPECT_NEAR(s.tool().q.w, 1, 1e-12);
  // what the hand does from here on the tool does: 0.1 mm along x, and a turn about the world's z
  pose.p.x += 1e-4;
  pose.q = toolkit::raw(Quat(toolkit::exp_rotation({0, 0, 0.01}) * toolkit::quat(pose.q)));
  s.run(20);
  EXPECT_NEAR(s.tool().p.x, 2e-4, 1e-12);
  EXPECT_NEAR(2 * std::asin(s.tool().q.z), 0.01, 1e-9);
}

TEST_F(LostHand, TakesTheJawsOverWhereBothMeet) {
  s.run(50);
  valid = 0;
  s.run(200);
  valid = kAll;
  closure = 0.1;
  s.run(10);
  EXPECT_EQ(input.closure, 0.8) << "an open hand that comes back does not drop the needle";
  for (; closure < 0.75; closure += 0.01) s.run(1);
  EXPECT_EQ(input.closure, 0.8);
  closure = 0.79;
  s.run(1);
  EXPECT_EQ(input.closure, 0.79);
  closure = 0.2;
  s.run(1);
  EXPECT_EQ(input.closure, 0.2) << "from here on the hand leads";
}

TEST_F(LostHand, AShortDropOutIsNoClutch) {
  s.run(50);
  valid = 0;
  s.run(20);
  valid = kAll;
  pose = at(2e-4, 0, 0);
  closure = 0.5;
  s.run(5);
  EXPECT_DOUBLE_EQ(s.tool().p.x, 2e-4);
  EXPECT_EQ(input.closure, 0.5);
}

TEST_F(LostHand, IsPartOfTheSavedState) {
  s.run(50);
  valid = 0;
  s.run(200);
  std::vector<std::byte> image(s.engine().image_size());
  ASSERT_TRUE(s.engine().save(image));
  const auto back = [&] {
    valid = kAll;
    pose = at(5e-3, 0, 0);
    s.run(30);
    return s.engine().hash();
  };
  const uint64_t first = back();
  ASSERT_TRUE(s.engine().restore(image));
  EXPECT_EQ(back(), first);
}

}  // namespace
}  // namespace swage::step
