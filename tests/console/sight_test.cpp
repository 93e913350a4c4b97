// SPDX-License-Identifier: Apache-2.0
#include "console/view3d/sight.hpp"

#include <gtest/gtest.h>

#include <numbers>

namespace swage::console {
namespace {

// A box of 2 x 2 x 2 mm whose middle is the origin of its body.
SceneParts with_box(Role role) {
  SceneParts parts;
  ScenePart box;
  box.role = role;
  for (const float x : {-1.F, 1.F})
    for (const float y : {-1.F, 1.F})
      for (const float z : {-1.F, 1.F}) box.mesh.vertex.push_back({{x, y, z}, {0, 0, 1}});
  parts.part = {box};
  return parts;
}

TEST(Sight, WhatStandsBetweenAPlaceAndItsViewerHidesIt) {
  const std::vector<swage_pose> X_WB = {{{-5e-3, 0, 0}, {1, 0, 0, 0}}};
  EXPECT_TRUE(hidden(with_box(Role::kStage), X_WB, {0, 0, 0}, {-1, 0, 0}));
  EXPECT_FALSE(hidden(with_box(Role::kStage), X_WB, {0, 0, 0}, {1, 0, 0})) << "it stands behind the place";
  EXPECT_FALSE(hidden(with_box(Role::kStage), X_WB, {0, 1.1F, 0}, {-1, 0, 0})) << "one looks past it";
  EXPECT_FALSE(hidden(with_box(Role::kTool), X_WB, {0, 0, 0}, {-1, 0, 0})) << "a tool moves away";
}

TEST(Sight, ATurnedBoxHidesWhatItsEdgeReaches) {
  // turned about z by 45 deg its edge reaches 1.41 mm aside
  const double half = std::numbers::pi / 8;
  const std::vector<swage_pose> X_WB = {{{-5e-3, 0, 0}, {std::cos(half), 0, 0, std::sin(half)}}};
  EXPECT_TRUE(hidden(with_box(Role::kStage), X_WB, {0, 1.3F, 0}, {-1, 0, 0}));
  EXPECT_FALSE(hidden(with_box(Role::kStage), X_WB, {0, 1.5F, 0}, {-1, 0, 0}));
}

}  // namespace
}  // namespace swage::console
