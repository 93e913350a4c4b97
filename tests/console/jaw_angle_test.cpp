// SPDX-License-Identifier: Apache-2.0
//
// Before they touch: how far jaws are from standing across the wire, and which key turns them there.
#include "console/view3d/jaw_angle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace swage::console {
namespace {

constexpr float kDegree = std::numbers::pi_v<float> / 180;

/// A half circle of 3 mm about the origin in the plane xz, with jaws at its top, where it runs along x. They are 2 mm open.
struct Jaws {
  snapshot::SceneCard card;
  SceneParts parts;
  std::vector<swage_pose> X_WB;
  std::vector<Spot> tips = {{1, {0, 0, 0}}, {2, {0, 0, 0}}};

  explicit Jaws(const QVector3D& closing, const QVector3D& at = {0, 0, 3}, float open_mm = 2) {
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
    parts = make_parts(card);
    const double c = std::numbers::sqrt2 / 2;
    X_WB = {{{0, 0, 0}, {c, c, 0, 0}}};
    for (const float side : {-0.5F, 0.5F}) {
      const QVector3D p = at + side * open_mm * closing;
      X_WB.push_back({{p.x() / kMmPerM, p.y() / kMmPerM, p.z() / kMmPerM}, {1, 0, 0, 0}});
    }
  }
  std::optional<JawAngle> angle() const { return jaw_angle(card, parts, X_WB, tips); }
};

/// Closing direction of jaws that come along y, `off` [rad] from perpendicular to the wire, which runs along x.
QVector3D closing(float off) { return {std::sin(off), 0, std::cos(off)}; }

// the viewer looks along +y with z up
const QQuaternion kFrontView = QQuaternion::fromAxisAndAngle(1, 0, 0, 90);

TEST(JawAngle, IsThatBetweenTheFacesAndTheWire) {
  for (const float off : {0.F, 10.F, 20.F, 30.F, 75.F}) {
    const Jaws jaws(closing(off * kDegree));
    ASSERT_TRUE(jaws.angle()) << off;
    EXPECT_NEAR(jaws.angle()->angle / kDegree, off, 0.2) << "of a wire in pieces of 6 deg";
    EXPECT_NEAR(QVector3D::dotProduct(jaws.angle()->faces, jaws.angle()->closing), 0, 1e-5);
  }
}

TEST(JawAngle, IsToldNearAWireWhileTheJawsAreOpen) {
  EXPECT_TRUE(Jaws(closing(0), {0, 0, 4.4F}).angle());
  EXPECT_FALSE(Jaws(closing(0), {0, 0, 4.6F}).angle()) << "1.6 mm from the wire";
  EXPECT_FALSE(Jaws(closing(0), {0, 0, 3}, 0.2F).angle()) << "closed on it";
  Jaws one(closing(0));
  one.tips.pop_back();
  EXPECT_FALSE(one.angle()) << "a tool of one tip";
}

// The outermost place of a jaw may be on its back: jaws that hold a wire are closed, however thick they are.
TEST(JawAngle, IsNotToldOfJawsThatHoldTheWire) {
  const auto held = [](float open_mm) {
    Jaws jaws(closing(0), {0, 0, 3}, open_mm);
    for (const float side : {-1.F, 1.F}) {  // faces 0.25 mm inside of the backs
      ScenePart jaw;
      jaw.role = Role::kTool;
      jaw.body = side < 0 ? 1 : 2;
      for (const float depth : {0.F, 0.25F}) {
        Vertex v{};
        v.p[2] = -side * depth;
        jaw.mesh.vertex.push_back(v);
      }
      jaws.parts.part.push_back(jaw);
    }
    return !jaws.angle();
  };
  EXPECT_TRUE(held(0.5F + 0.12F));
  EXPECT_FALSE(held(0.5F + 0.4F));
}

TEST(JawAngle, TheKeyTurnsTheJawsAcrossTheWire) {
  // seen from the front they roll: clockwise on the screen takes the upper jaw to the right
  const Jaws right(closing(20 * kDegree)), left(closing(-20 * kDegree));
  const auto back = jaw_turn(*right.angle(), kFrontView);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->key, Qt::Key_Z);
  EXPECT_NEAR(back->angle / kDegree, 20, 0.2);
  const auto on = jaw_turn(*left.angle(), kFrontView);
  ASSERT_TRUE(on);
  EXPECT_EQ(on->key, Qt::Key_X);
  EXPECT_FALSE(jaw_turn(*Jaws(closing(8 * kDegree)).angle(), kFrontView)) << "near enough";
}

// whatever the view: the rotation that the mouse gives the hand for that key, by that angle, brings the faces along the wire
TEST(JawAngle, TheKeyIsRightInEveryView) {
  const std::vector<std::pair<int, QVector3D>> keys = {{Qt::Key_Z, {0, 0, 1}}, {Qt::Key_X, {0, 0, -1}}, {Qt::Key_Right, {0, 1, 0}},
                                                       {Qt::Key_Left, {0, -1, 0}}, {Qt::Key_Down, {1, 0, 0}}, {Qt::Key_Up, {-1, 0, 0}}};
  const Jaws jaws(QVector3D(0.5F, 0.2F, 0.8F).normalized());
  const auto angle = jaws.angle();
  ASSERT_TRUE(angle);
  for (const QQuaternion& q_WC : {kFrontView, QQuaternion(), QQuaternion::fromEulerAngles(50, 30, 0), QQuaternion::fromAxisAndAngle(0, 0, 1, 90) * kFrontView}) {
    const auto turn = jaw_turn(*angle, q_WC);
    ASSERT_TRUE(turn);
    const auto key = std::find_if(keys.begin(), keys.end(), [&](const auto& k) { return k.first == turn->key; });
    ASSERT_NE(key, keys.end());
    const QQuaternion R = QQuaternion::fromAxisAndAngle(q_WC.rotatedVector(key->second), turn->angle / kDegree);
    EXPECT_NEAR(QVector3D::dotProduct(R.rotatedVector(angle->closing), angle->wire), 0, 1e-3);
  }
}

}  // namespace
}  // namespace swage::console
