// SPDX-License-Identifier: Apache-2.0
#include "console/view3d/sight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "console/view3d/clear_sight.hpp"

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

// A shaft from the needle to the eye 100 mm away: jaws are drawn, the part that hides the needle is not, and parts beside or behind it are.
TEST(ClearSight, LeavesOutOfAnInstrumentOnlyWhatStandsBeforeTheNeedle) {
  const ClearSight sight{{0, 0, 0}, 2, 2.5F};
  const QVector3D eye(0, -100, 0);
  EXPECT_EQ(cleared(sight, eye, {0, -2, 0}), 0) << "the jaws";
  EXPECT_EQ(cleared(sight, eye, {0, 30, 0}), 0) << "behind the needle";
  for (const float before : {5.F, 20.F, 60.F}) EXPECT_EQ(cleared(sight, eye, {0, -before, 0}), 1) << before << " mm before it";
  // half way to the eye a point 1.5 mm from the axis is projected to 3 mm
  EXPECT_EQ(cleared(sight, eye, {1.5F, -50, 0}), 0);
  EXPECT_EQ(cleared(sight, eye, {0.9F, -50, 0}), 1);
  EXPECT_EQ(cleared(sight, eye, {0, -120, 0}), 0) << "behind the eye";
  EXPECT_EQ(cleared({}, eye, {0, -20, 0}), 0);
}

TEST(ClearSight, FadesWithoutAnEdge) {
  const ClearSight sight{{0, 0, 0}, 2, 2.5F};
  const QVector3D eye(0, -100, 0);
  for (const bool aside : {true, false}) {
    float last = aside ? 1.F : 0.F;
    for (float mm = 0; mm < 4; mm += 0.05F) {
      const float now = aside ? cleared(sight, eye, {mm / 2, -50, 0}) : cleared(sight, eye, {0, -mm, 0});
      EXPECT_LT(std::abs(now - last), 0.15F) << mm;
      EXPECT_LE((aside ? 1.F : -1.F) * (now - last), 0) << mm;
      last = now;
    }
  }
}

}  // namespace
}  // namespace swage::console
