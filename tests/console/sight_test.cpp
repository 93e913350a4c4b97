// SPDX-License-Identifier: Apache-2.0
#include "console/view3d/sight.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "console/view3d/clear_sight.hpp"
#include "console/view3d/view_point.hpp"

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

// Wires leave their boxes nearly empty: the ring on one is seen.
TEST(Sight, AFixedWireHidesNothing) {
  SceneParts wire = with_box(Role::kStage);
  wire.part[0].wire = true;
  EXPECT_FALSE(hidden(wire, std::vector<swage_pose>{{{-5e-3, 0, 0}, {1, 0, 0, 0}}}, {0, 0, 0}, {-1, 0, 0}));
}

// the cue of a tissue whose thread is held elsewhere stands on the tissue
TEST(Sight, AnAnchorOffATissueIsMovedOntoIt) {
  SceneParts parts = with_box(Role::kOther);
  const std::vector<swage_pose> X_WB = {{{-5e-3, 0, 0}, {1, 0, 0, 0}}};
  EXPECT_EQ(on_tissue(parts, X_WB, 0, {3, 4, 0.5F}), QVector3D(3, 4, 0.5F)) << "it is no tissue";
  parts.part[0].soft = true;
  EXPECT_EQ(on_tissue(parts, X_WB, 0, {3, 4, 0.5F}), QVector3D(-4, 1, 0.5F));
  EXPECT_EQ(on_tissue(parts, X_WB, 0, {-5.5F, 0, 0}), QVector3D(-5.5F, 0, 0)) << "it is on it";
  EXPECT_EQ(on_tissue(parts, X_WB, 1, {3, 4, 0.5F}), QVector3D(3, 4, 0.5F)) << "another object";
}

snapshot::CardShape block(uint32_t body, const swage_vec3& low, const swage_vec3& high) {
  snapshot::CardShape s;
  s.kind = SWAGE_SHAPE_CONVEX;
  s.flags = SWAGE_SHAPE_USUAL;
  s.body = s.object = body;
  s.X_BS.q = {1, 0, 0, 0};
  for (int i = 0; i < 8; ++i) s.vertex.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
  s.face = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return s;
}

// A ball of 1 mm at the origin in the tips of a holder 30 mm long; `yaw`: of its handle, 0 along x, rad; a wall stands behind on wish.
bool side_is_from_behind(double yaw, bool walled, bool two_tools = false) {
  snapshot::SceneCard card;
  card.objects = {{"holder", "x", "1", {SWAGE_TRAIT_GRIPPER}, 0, 1, 0, 0}, {"ball", "x", "1", {SWAGE_TRAIT_GRASPABLE}, 1, 1, 0, 0}};
  card.motion = {SWAGE_MOTION_FOLLOWS, SWAGE_MOTION_DYNAMIC};
  card.start = {{{0, 0, 0}, {std::cos(yaw / 2), 0, 0, std::sin(yaw / 2)}}, {{0, 0, 0}, {1, 0, 0, 0}}};
  snapshot::CardShape ball;
  ball.kind = SWAGE_SHAPE_SPHERE;
  ball.flags = SWAGE_SHAPE_USUAL;
  ball.body = ball.object = 1;
  ball.X_BS.q = {1, 0, 0, 0};
  ball.radius = 0.5e-3;
  card.shapes = {block(0, {0, -0.3e-3, -0.3e-3}, {30e-3, 0.3e-3, 0.3e-3}), ball};
  if (walled) {
    card.objects.push_back({"wall", "x", "1", {SWAGE_TRAIT_SOLID}, 2, 1, 0, 0});
    card.motion.push_back(SWAGE_MOTION_FIXED);
    card.start.push_back({{0, 0, 0}, {1, 0, 0, 0}});
    card.shapes.push_back(block(2, {-10e-3, 5e-3, -10e-3}, {10e-3, 6e-3, 10e-3}));
  }
  if (two_tools) {  // the other comes from the opposite side, a little nearer to who looks from the front
    const auto own = static_cast<uint32_t>(card.objects.size());
    card.objects.push_back({"other", "x", "1", {SWAGE_TRAIT_GRIPPER}, own, 1, 0, 0});
    card.motion.push_back(SWAGE_MOTION_FOLLOWS);
    card.start.push_back({{0, -2e-3, 0}, {std::cos(yaw / 2), 0, 0, std::sin(yaw / 2)}});
    card.shapes.push_back(block(own, {-32e-3, -0.3e-3, -0.3e-3}, {-2e-3, 0.3e-3, 0.3e-3}));
  }
  SceneState scene;
  scene.set_card(card);
  ViewPoint point(scene);
  point.frame(CameraPreset::kSide);
  return point.camera.eye().y() > point.camera.focus().y();
}

TEST(SideView, IsFromWhereTheShaftDoesNotHideTheWork) {
  const double right_angle = std::numbers::pi / 2;
  EXPECT_TRUE(side_is_from_behind(-right_angle, false)) << "the handle points at who looks from the front";
  EXPECT_TRUE(side_is_from_behind(-1, false));
  EXPECT_FALSE(side_is_from_behind(0, false, true)) << "neither of two points at the viewer";
  EXPECT_FALSE(side_is_from_behind(right_angle, false));
  EXPECT_FALSE(side_is_from_behind(0, false)) << "it is seen from the side";
  EXPECT_FALSE(side_is_from_behind(-right_angle, true)) << "a wall hides more";
}

/// Compass direction, deg, from which Side looks at an upright needle whose plane's normal is +x, with a tool that comes from +x; `other`: beside
/// another hand's, which comes from -x and rests far away.
float side_at_a_needle(bool tissue, bool other = false) {
  const double turn = std::sqrt(0.5);
  snapshot::SceneCard card;
  card.objects = {{"needle", "x", "1", {SWAGE_TRAIT_GRASPABLE}, 0, 1, 0, 0},
                  {"assistant", "x", "1", {SWAGE_TRAIT_GRIPPER}, 1, 1, 0, 0},
                  {"pad", "x", "1", {SWAGE_TRAIT_SOLID}, 2, 1, 0, 0}};
  if (tissue) card.objects[2].traits.push_back(SWAGE_TRAIT_PIERCEABLE);
  card.motion = {SWAGE_MOTION_DYNAMIC, SWAGE_MOTION_FOLLOWS, SWAGE_MOTION_FIXED};
  card.start = {{{0, 0, 0}, {turn, 0, turn, 0}}, {{0, 0, 0}, {1, 0, 0, 0}}, {{0, 0, -9e-3}, {1, 0, 0, 0}}};
  snapshot::CardShape arc;
  arc.kind = SWAGE_SHAPE_ARC;
  arc.flags = SWAGE_SHAPE_USUAL;
  arc.X_BS.q = {1, 0, 0, 0};
  arc.radius = 0.05e-3, arc.arc_radius = 2e-3, arc.sweep = 2;
  card.shapes = {arc, block(1, {2e-3, -0.3e-3, -0.3e-3}, {32e-3, 0.3e-3, 0.3e-3}), block(2, {-3e-3, -3e-3, -1e-3}, {3e-3, 3e-3, 0})};
  if (other) {
    card.objects.push_back({"scissors", "x", "1", {SWAGE_TRAIT_GRIPPER}, 3, 1, 0, 0});
    card.motion.push_back(SWAGE_MOTION_FOLLOWS);
    card.start.push_back({{-40e-3, 0, 0}, {1, 0, 0, 0}});
    card.shapes.push_back(block(3, {-32e-3, -0.3e-3, -0.3e-3}, {-2e-3, 0.3e-3, 0.3e-3}));
  }
  SceneState scene;
  scene.set_card(card);
  ViewPoint point(scene);
  point.frame(CameraPreset::kSide);
  const QVector3D from = point.camera.eye() - point.camera.focus();
  return std::atan2(from.y(), from.x()) * static_cast<float>(180 / std::numbers::pi);
}

TEST(SideView, IsAcrossAShaftWhoseTiltAtTheNeedleIsJudged) {
  EXPECT_NEAR(side_at_a_needle(false), -90, 0.1F) << "along the shaft its jaws would hide the needle";
  EXPECT_NEAR(std::abs(side_at_a_needle(true)), 180, 0.1F) << "a needle that is driven is seen square to its plane, away from the handle";
  EXPECT_NEAR(std::abs(side_at_a_needle(true, true)), 180, 0.1F) << "the handle of the hand that drives it, wherever the other one rests";
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
