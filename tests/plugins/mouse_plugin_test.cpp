// SPDX-License-Identifier: Apache-2.0
//
// The plugin of the mouse: without a pointer, its start, two hands, and what it refuses.
#include "mouse_pointer.hpp"
#include "stage.hpp"

namespace swage::mouse {
namespace {

TEST(Mouse, RefusesAProgramWithoutAPointer) {
  stage::Stage stage("swage.device.mouse");
  ASSERT_EQ(stage.configure(), SWAGE_OK);
  ASSERT_EQ(stage.activate(), SWAGE_OK);
  EXPECT_LT(stage.table<swage_device>(SWAGE_EXT_DEVICE).open(stage.raw()), 0);
  EXPECT_EQ(stage.reports.size(), 1u);
  // and stands still for a host that goes on regardless
  stage.on_rt();
  const swage_command command{};
  swage_sample sample{};
  EXPECT_EQ(stage.table<swage_device>(SWAGE_EXT_DEVICE).exchange(stage.raw(), &command, &sample), SWAGE_OK);
  EXPECT_EQ(sample.pose.p.x, -8e-3);
}

swage_pointer g_pointer;

TEST(Mouse, StartsWhereItIsToldAndReadsThePointer) {
  stage::Stage stage("swage.device.mouse");
  const swage_host_pointer table{[](const swage_host*) -> const swage_pointer* { return &g_pointer; }};
  stage.pointer_table = &table;
  ASSERT_EQ(stage.configure({{"start", std::vector<double>{1e-3, 2e-3, 3e-3}},
                             {"start_axis", std::vector<double>{0, 0, -1}},
                             {"start_closing", std::vector<double>{1, 0, 0}},
                             {"smoothing", 0}}),
            SWAGE_OK);
  ASSERT_EQ(stage.activate(), SWAGE_OK);
  const auto& device = stage.table<swage_device>(SWAGE_EXT_DEVICE);
  ASSERT_EQ(device.open(stage.raw()), SWAGE_OK);
  stage.on_rt();

  g_pointer = still();
  swage_command command{};
  swage_sample sample{};
  ASSERT_EQ(device.exchange(stage.raw(), &command, &sample), SWAGE_OK);
  EXPECT_EQ(sample.pose.p.z, 3e-3);
  EXPECT_LT((toolkit::quat(sample.pose.q) * Vec3::UnitX() + Vec3::UnitZ()).norm(), 1e-12);

  g_pointer.buttons = kLeftButton;
  g_pointer.dy = 0.1;
  command.time_s = 1e-3;
  device.exchange(stage.raw(), &command, &sample);
  EXPECT_NEAR(sample.pose.p.z, 4e-3, 1e-15);
  EXPECT_EQ(sample.sequence, 2u);
}

/// Two instruments of one mouse, as the host asks them: the first, then the second, each step.
struct TwoHands {
  TwoHands() {
    for (int i = 0; i < 2; ++i) {
      EXPECT_EQ(hand[i].configure({{"hand", i + 1}, {"hands", 2}, {"smoothing", 0}, {"rest_force", 0}, {"latch", false}}), SWAGE_OK);
      hand[i].pointer_table = &table;
      EXPECT_EQ(hand[i].activate(), SWAGE_OK);
      EXPECT_EQ(device(i).open(hand[i].raw()), SWAGE_OK);
      hand[i].on_rt();
      sample[i].pose.q.w = 1;
    }
    g_pointer = still();
    step(1);
  }
  const swage_device& device(int i) { return hand[i].table<swage_device>(SWAGE_EXT_DEVICE); }
  void step(int n) {
    for (int k = 0; k < n; ++k) {
      command.time_s += 1e-3;
      for (int i = 0; i < 2; ++i) device(i).exchange(hand[i].raw(), &command, &sample[i]);
    }
  }
  bool led(int i) const { return (sample[i].valid & SWAGE_VALID_BUTTONS) != 0; }

  const swage_host_pointer table{[](const swage_host*) -> const swage_pointer* { return &g_pointer; }};
  stage::Stage hand[2] = {stage::Stage("swage.device.mouse"), stage::Stage("swage.device.mouse")};
  swage_command command{};
  swage_sample sample[2] = {};
};

TEST(Mouse, TabHandsOverAndTheOtherToolStaysAndHolds) {
  TwoHands two;
  EXPECT_TRUE(two.led(0));
  EXPECT_FALSE(two.led(1));
  g_pointer.keys = kSpace | letter('d');
  two.step(500);
  const swage_sample first = two.sample[0], second = two.sample[1];
  EXPECT_NEAR(first.closure, 0.5 * 1 / 1.5, 0.01);
  EXPECT_NEAR(second.pose.p.x, -8e-3, 1e-15) << "only the first is led";
  EXPECT_EQ(second.closure, 0);

  // the keys are still down while Tab is pressed: they do not close the other jaws, and do not lead it
  g_pointer.keys |= kTab;
  two.step(100);
  EXPECT_FALSE(two.led(0));
  EXPECT_TRUE(two.led(1));
  EXPECT_EQ(two.sample[1].closure, 0);
  EXPECT_NEAR(two.sample[1].pose.p.x, -8e-3, 1e-15);
  g_pointer.keys = 0;
  two.step(10);
  g_pointer.keys = letter('d');
  two.step(250);
  EXPECT_NEAR(two.sample[1].pose.p.x, -7e-3, 1e-5);
  EXPECT_EQ(two.sample[0].pose.p.x, first.pose.p.x) << "it stays";
  EXPECT_EQ(two.sample[0].closure, first.closure) << "and holds, also where jaws spring open when the key is let go";

  // and back; one press is one hand-over, however long it lasts
  g_pointer.keys = kTab;
  two.step(300);
  EXPECT_TRUE(two.led(0));
  g_pointer.keys = 0;
  two.step(10);
  g_pointer.keys = letter('a');
  two.step(100);
  EXPECT_LT(two.sample[0].pose.p.x, first.pose.p.x);
  EXPECT_NEAR(two.sample[1].pose.p.x, -7e-3, 1e-5);
}

TEST(Mouse, AloneItDoesNotHearTab) {
  stage::Stage stage("swage.device.mouse");
  EXPECT_LT(stage.configure({{"hand", 2}}), 0) << "there is one hand";
}

TEST(Mouse, RefusesAStartWithoutDirection) {
  stage::Stage stage("swage.device.mouse");
  EXPECT_LT(stage.configure({{"start_axis", std::vector<double>{0, 1, 0}}}), 0);
  EXPECT_EQ(stage.errors.size(), 1u);
}

}  // namespace
}  // namespace swage::mouse
