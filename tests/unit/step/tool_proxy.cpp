// SPDX-License-Identifier: Apache-2.0
#include "step/tool_proxy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "fake_scene.hpp"
#include "toolkit/convex.hpp"

namespace swage::step {
namespace tool_proxy_test {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

constexpr double kRadius = 0.5e-3;  // m, of the tool of the fake scene

/// The ball of the fake scene as a fixed plate whose upper face is z = 0, 20 mm wide.
struct Plate : FakeScene {
  explicit Plate(double thickness = 1e-3, int32_t motion = SWAGE_MOTION_FIXED) {
    scene::World& w = rig.world;
    w.body[1].motion = motion;
    w.body[1].start = {{0, 0, -0.5 * thickness}, {1, 0, 0, 0}};
    std::vector<Vec3> vertex;
    for (int i = 0; i < 8; ++i)
      vertex.emplace_back((i & 1) ? 10e-3 : -10e-3, (i & 2) ? 10e-3 : -10e-3,
                          0.5 * ((i & 4) ? thickness : -thickness));
    const uint32_t start[] = {0, 4, 8, 12, 16, 20, 24};
    const uint32_t index[] = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};
    toolkit::Convex box;
    EXPECT_EQ(toolkit::build_convex(vertex, start, index, box), "");
    w.shape[1].kind = SWAGE_SHAPE_CONVEX;
    w.shape[1].convex = static_cast<uint32_t>(w.convex.size());
    w.convex.push_back(box);
    stand(1e-3);
    device_.exchange = [this](const swage_command*, swage_sample* s) {
      s->pose = {toolkit::raw(hand), {1, 0, 0, 0}};
      s->valid = SWAGE_VALID_POSE;
      return swage_result{SWAGE_OK};
    };
  }
  /// Where the tool begins, m above the plate.
  void stand(double z) { rig.world.body[0].start.p.z = rig.objects[0].X_WO.p.z = z; }
  Vec3 hand = Vec3(0, 0, 1e-3);
};

TEST(ToolProxy, AToolStopsAtAFixedSolidWhileItsHandRunsAhead) {
  Plate s;
  for (int i = 0; i < 200; ++i) {
    s.hand.z() -= 20e-6;
    s.run(1);
    ASSERT_GE(s.tool().p.z, kRadius - 2e-9) << i;
  }
  EXPECT_NEAR(s.tool().p.z, kRadius, 2e-9);
  EXPECT_LT(s.hand.z(), -2e-3);
  // the twist is the proxy's, not the hand's
  EXPECT_NEAR(s.rig.world.V_WB[0].v.z, 0, 1e-5);
}

// What an arm is given to feel of the plate: the anchor is where the device would be if the hand were where its tool is, whatever lies
// between them. Device +y is world +z, ten times as large.
class Anchor final : public DevicePort {
 public:
  void read(uint64_t, double, swage_sample& sample) noexcept override {
    sample.pose = {toolkit::raw(p_D), {1, 0, 0, 0}};
    sample.valid = valid;
    sample.buttons = buttons;
  }
  void send(const ToolForce& f) noexcept override { last = f; }
  Vec3 p_D = Vec3(3e-3, 0, 0);
  uint32_t valid = SWAGE_VALID_POSE | SWAGE_VALID_BUTTONS, buttons = 0;
  ToolForce last;
};

class FeltPlate : public ::testing::TestWithParam<bool> {
 protected:
  FeltPlate() {
    const double h = std::sqrt(0.5);
    s.device_.device.flags = SWAGE_DEVICE_FORCE;
    host::DeviceSlot& slot = s.rig.devices[0];
    slot.motion_scale = 10;
    slot.coupling = {200, 1};
    slot.X_WD0 = {{0, 0, 1e-3}, {h, h, 0, 0}};
    slot.filters.clutch = 1;
    s.rig.mirror = GetParam();
    engine = std::make_unique<Engine>(s.rig, Options{}, std::vector<DevicePort*>{&port});
  }
  void step(int n) {
    for (int i = 0; i < n; ++i) engine->step();
  }
  Plate s;
  Anchor port;
  std::unique_ptr<Engine> engine;
};

TEST_P(FeltPlate, TheAnchorStaysBehindAHandThatPressesAndNowhereElse) {
  step(200);
  EXPECT_NEAR(port.last.anchor.p.y, 0, 1e-12) << "the tool is where the hand is";
  EXPECT_NEAR(port.last.anchor.p.x, 3e-3, 1e-12);
  port.p_D = {3e-3, -20e-3, 0};
  step(200);
  // the hand is at z = -1 mm, its tool at 0.5 mm: 15 mm at the device
  EXPECT_NEAR(s.tool().p.z, kRadius, 2e-9);
  EXPECT_NEAR(port.last.anchor.p.y, -5e-3, 2e-8);
  EXPECT_NEAR(port.last.anchor.p.x, 3e-3, 1e-12);
  EXPECT_NEAR(port.last.anchor.p.z, 0, 1e-12);
  EXPECT_EQ(port.last.stiffness, 200);
  EXPECT_EQ(port.last.damping, 1);
  port.p_D = {3e-3, -2e-3, 0};
  step(200);
  EXPECT_NEAR(port.last.anchor.p.y, -2e-3, 1e-12);
}

TEST_P(FeltPlate, AClutchPullsNobodyBack) {
  step(200);
  port.buttons = 1;
  port.p_D = {3e-3, 40e-3, 0};
  step(200);
  EXPECT_NEAR(port.last.anchor.p.y, 40e-3, 1e-12) << "the hand goes back while its tool stays";
  port.buttons = 0;
  step(200);
  EXPECT_NEAR(port.last.anchor.p.y, 40e-3, 1e-12);
  port.p_D.y() -= 10e-3;
  step(200);
  EXPECT_NEAR(s.tool().p.z, kRadius, 2e-9) << "1 mm down in the scene, of which the plate takes a half";
  EXPECT_NEAR(port.last.anchor.p.y, 35e-3, 2e-8) << "5 mm to press against";
}

INSTANTIATE_TEST_SUITE_P(Hands, FeltPlate, ::testing::Bool(), [](const auto& one) { return one.param ? "left" : "right"; });

TEST(ToolProxy, ItSlidesAlongTheSurfaceAndComesOffWithoutSticking) {
  Plate s;
  s.hand = {0, 0, -1e-3};
  s.run(20);
  for (int i = 0; i < 100; ++i) {
    s.hand.x() += 10e-6;
    s.run(1);
  }
  s.run(100);
  EXPECT_NEAR(s.tool().p.x, 1e-3, 1e-9);
  EXPECT_NEAR(s.tool().p.z, kRadius, 2e-9);
  s.hand.z() = 0.8e-3;
  s.run(20);
  EXPECT_EQ(s.tool().p.z, 0.8e-3);
}

TEST(ToolProxy, AJumpThroughAThinPlateStopsOnItsNearSide) {
  for (int phase = 0; phase < 16; ++phase) {
    Plate s(0.3e-3);
    s.stand(1e-3 + 15e-6 * phase);
    s.hand = {1e-3, 0, -20e-3};
    for (int i = 0; i < 100; ++i) {
      s.run(1);
      ASSERT_GE(s.tool().p.z, kRadius - 2e-9) << "phase " << phase;
    }
  }
}

TEST(ToolProxy, WithoutAStopTheToolGoesWhereItsHandIs) {
  // a plate that moves is a matter of contact forces
  Plate s(1e-3, SWAGE_MOTION_FOLLOWS);
  s.hand = {0, 0, -1e-3};
  s.run(50);
  EXPECT_EQ(s.tool().p.z, -1e-3);
}

}  // namespace tool_proxy_test
}  // namespace swage::step
