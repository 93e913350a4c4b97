// SPDX-License-Identifier: Apache-2.0
#include "console/view3d/needle_circle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "console/pages/pointer_hand.hpp"

namespace swage::console {
namespace {

// a half circle of 3 mm that may be taken, its point at (3, 0, 0) mm of its own frame
snapshot::SceneCard scene() {
  snapshot::SceneCard card;
  card.objects.resize(1);
  card.objects[0].name = "needle";
  card.objects[0].n_body = 1;
  card.objects[0].traits = {SWAGE_TRAIT_GRASPABLE};
  card.start = {{{0, 0, 0}, {1, 0, 0, 0}}};
  card.motion = {SWAGE_MOTION_DYNAMIC};
  snapshot::CardShape arc;
  arc.kind = SWAGE_SHAPE_ARC;
  arc.flags = SWAGE_SHAPE_USUAL;
  arc.X_BS = {{0, 0, 0}, {1, 0, 0, 0}};
  arc.arc_radius = 3e-3;
  arc.radius = 50e-6;
  arc.sweep = std::numbers::pi;
  card.shapes = {arc};
  return card;
}

TEST(NeedleCircle, IsThatOfTheWireAtTheTipsWhereItIsNow) {
  const snapshot::SceneCard card = scene();
  const SceneParts parts = make_parts(card);
  // rotated about x by a right angle, and moved: its plane is xz now
  const double c = std::numbers::sqrt2 / 2;
  const std::vector<swage_pose> X_WB = {{{1e-3, 2e-3, 0}, {c, c, 0, 0}}};
  const auto circle = needle_circle(card, parts, X_WB, {1, 2, 3.2F});
  ASSERT_TRUE(circle);
  EXPECT_NEAR((circle->centre - QVector3D(1, 2, 0)).length(), 0, 1e-4);
  EXPECT_NEAR(circle->radius, 3, 1e-4);
  // the arc runs from its point at +x over +z: the point leads in the opposite rotation, which is about +y
  EXPECT_NEAR((circle->axis - QVector3D(0, 1, 0)).length(), 0, 1e-4);
  EXPECT_TRUE(needle_circle(card, parts, X_WB, {1, 2, 5})) << "held 2 mm behind the tips";
  EXPECT_FALSE(needle_circle(card, parts, X_WB, {1, 2, 6.5F})) << "3.5 mm from the tips is not held";
}

TEST(NeedleCircle, AStraightWireHasNone) {
  snapshot::SceneCard card = scene();
  card.shapes[0].sweep = 1e-4;
  EXPECT_FALSE(needle_circle(card, make_parts(card), card.start, {3, 0, 0}));
}

TEST(NeedleCircle, AClosedRingHasNone) {
  snapshot::SceneCard card = scene();
  card.shapes[0].sweep = 2 * std::numbers::pi;
  EXPECT_FALSE(needle_circle(card, make_parts(card), card.start, {3, 0, 0}));
}

TEST(NeedleCircle, ItsMirrorImageGoesPointFirstToo) {
  const NeedleCircle circle{{1, 2, 3}, {0, 1, 0}, 3};
  const NeedleCircle image = mirrored(circle);
  // a point on it moves along axis x lever; the mirrored lever gives the mirrored motion
  const QVector3D lever(3, 0, 0), way = QVector3D::crossProduct(circle.axis, lever);
  const QVector3D way_image = QVector3D::crossProduct(image.axis, QVector3D(-3, 0, 0));
  EXPECT_EQ(way_image, QVector3D(-way.x(), way.y(), way.z()));
  EXPECT_EQ(image.centre, QVector3D(-1, 2, 3));
}

// A component above 1 would be refused, and a needle that stands upright could not be driven.
TEST(NeedleCircle, ItsAxisIsWithinTheRangeOfAParameterWhateverTheRounding) {
  const float above = std::nextafter(1.0F, 2.0F);
  const auto params = nlohmann::json::parse(circle_params(NeedleCircle{{1, 2, 3}, {0, -above, 0}, 3}));
  EXPECT_EQ(params["circle_axis"], nlohmann::json({0.0, -1.0, 0.0}));
  EXPECT_NEAR(params["circle_centre"][2].get<double>(), 3e-3, 1e-9) << "m";
  EXPECT_EQ(nlohmann::json::parse(circle_params({}))["circle_axis"], nlohmann::json({0.0, 0.0, 0.0})) << "no needle";
}

}  // namespace
}  // namespace swage::console
