// SPDX-License-Identifier: Apache-2.0
//
// Which of two tools the mouse drives: the tool at the position of the device that sends buttons.
#include "console/view3d/led_tool.hpp"

#include <gtest/gtest.h>
#include <swage/abi/object.h>

#include <memory>

namespace swage::console {
namespace {

snapshot::SceneCard two_tools() {
  snapshot::SceneCard card;
  card.objects = {{"needle", "x", "1", {SWAGE_TRAIT_GRASPABLE}, 0, 1, 0, 0},
                  {"first", "x", "1", {SWAGE_TRAIT_GRIPPER}, 1, 1, 0, 0},
                  {"second", "x", "1", {SWAGE_TRAIT_GRIPPER}, 2, 1, 0, 0}};
  // a third-party device counts as well: its flag marks it as a pointer device
  card.devices = {{"left", "swage.device.mouse", "1", SWAGE_DEVICE_POINTER}, {"right", "org.example.pad", "1", SWAGE_DEVICE_POINTER}};
  card.motion = {SWAGE_MOTION_DYNAMIC, SWAGE_MOTION_FOLLOWS, SWAGE_MOTION_FOLLOWS};
  return card;
}

TEST(LedTool, IsWhereTheHandWithButtonsIs) {
  const snapshot::SceneCard card = two_tools();
  EXPECT_EQ(mouse_hands(card), 2);
  auto now = std::make_unique<snapshot::Snapshot>();
  now->n_body = 3;
  now->n_device = 2;
  now->X_WB[1].p = {1e-3, 0, 0};
  now->X_WB[2].p = {-1e-3, 0, 0};
  now->device[0].X_WD.p = {-1.1e-3, 0, 0};  // the order of devices differs from that of tools
  now->device[1].X_WD.p = {1e-3, 0, 0};
  EXPECT_EQ(led_tool(card, *now), SWAGE_NONE) << "nobody has told yet";
  now->device[0].valid = SWAGE_VALID_POSE | SWAGE_VALID_BUTTONS;
  now->device[1].valid = SWAGE_VALID_POSE;
  EXPECT_EQ(led_tool(card, *now), 2u);
  std::swap(now->device[0].valid, now->device[1].valid);
  EXPECT_EQ(led_tool(card, *now), 1u);
}

TEST(LedTool, IsNobodysWhereOneHandIsLed) {
  snapshot::SceneCard card = two_tools();
  card.devices[1].flags = SWAGE_DEVICE_SCRIPTED;
  EXPECT_EQ(mouse_hands(card), 1);
  auto now = std::make_unique<snapshot::Snapshot>();
  now->n_body = 3;
  now->n_device = 2;
  now->device[1].valid = SWAGE_VALID_POSE | SWAGE_VALID_BUTTONS;
  EXPECT_EQ(led_tool(card, *now), SWAGE_NONE);
}

}  // namespace
}  // namespace swage::console
