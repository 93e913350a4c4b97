// SPDX-License-Identifier: Apache-2.0
//
// Wires against a height field, judged by distances to all its triangles.
#include "field_scene.hpp"

#include "contact/detector.hpp"
#include "scene/kinematics.hpp"

namespace swage::contact {
namespace field_test {

/// Compares the least gap with the search at random poses of a wire over a rough ground (slopes up to 50 deg).
void compare(const Solid& a, const std::function<Vec3(double)>& point_B, int poses, uint64_t seed) {
  base::Xoshiro256 random(seed);
  Ground ground([&](double, double) { return random.uniform(-0.1e-3, 0.1e-3); });
  const Solid b = ground.solid();
  int touching = 0;
  for (int k = 0; k < poses; ++k) {
    const auto draw = [&](double size) { return random.uniform(-size, size); };
    Pose X(Vec3(draw(1.5e-3), draw(1.5e-3), 0), toolkit::exp_rotation({draw(3), draw(3), draw(3)}));
    const auto on = [&](double s) { return b.X_BH.inverse_times(X * point_B(s)); };
    // lowered until it is nearly there: the distance bounds the way
    X.p.z() = 2e-3;
    for (int i = 0; i < 16; ++i) {
      double d = 1;
      for (int q = 0; q <= 16; ++q) d = std::min(d, distance(on(q / 16.0), b.field));
      X.p.z() -= d - 0.9 * a.radius;
      if (d < a.radius + 1e-6) break;
    }
    const double exact = searched_gap(on, b.field, a.radius);
    if (exact > 15e-6 || exact < -0.9 * a.radius) continue;
    ++touching;
    ASSERT_NEAR(least(touch(a, X, b)), exact, 1e-9) << "pose " << k;
    // flatness zero: nothing but minima, and the least one is the same
    ASSERT_NEAR(least(touch(a, X, b, 20e-6, 0)), exact, 1e-9) << "pose " << k;
  }
  EXPECT_GT(touching, poses / 2);
}

TEST(Field, BallsAgreeWithASearchOverAllTriangles) {
  compare(
      wire(SWAGE_SHAPE_SPHERE, 50e-6, 0), [](double) { return Vec3(0, 0, 0); }, 60, 1);
}

TEST(Field, CapsulesAgreeWithASearchOverAllTriangles) {
  compare(
      wire(SWAGE_SHAPE_CAPSULE, 50e-6, 1e-3), [](double s) { return Vec3(0, 0, 2e-3 * (s - 0.5)); }, 12, 2);
}

TEST(Field, ArcsAgreeWithASearchOverAllTriangles) {
  const double R = 1e-3, sweep = 2.4;
  const auto point = [&](double s) { return Vec3(R * std::cos(s * sweep), R * std::sin(s * sweep), 0); };
  compare(wire(SWAGE_SHAPE_ARC, 50e-6, 0, R, sweep), point, 12, 3);
}

TEST(Field, AWireLaidOnAPlaneTouchesWithBothEndsWhereverItLies) {
  const Ground plane([](double x, double y) { return 0.1 * x + 0.05 * y; });
  const Solid b = plane.solid(), a = wire(SWAGE_SHAPE_CAPSULE, 50e-6, 0.9e-3);
  const Vec3 n = Vec3(-0.1, -0.05, 1).normalized();
  for (int k = 0; k < 40; ++k) {
    // along an edge of the grid, along its diagonal, and anyhow
    const double angle = k == 0 ? 0 : k == 1 ? M_PI / 4 : k == 2 ? M_PI / 2 : 0.1 * k;
    const Vec3 along =
        (Vec3(std::cos(angle), std::sin(angle), 0) - n * (n.x() * std::cos(angle) + n.y() * std::sin(angle)))
            .normalized();
    const Vec3 p(0.4e-3 * (k % 2), 0, plane.at(0.4e-3 * (k % 2), 0));
    const Pose X(p + (50e-6 - 1e-6) * n, Quat::FromTwoVectors(Vec3::UnitZ(), along));
    const Manifold m = touch(a, X, b);
    ASSERT_EQ(m.count, 2) << "angle " << angle;
    for (size_t i = 0; i < 2; ++i) {
      EXPECT_NEAR(m.candidate[i].touch.gap, -1e-6, 1e-12);
      EXPECT_LT((m.candidate[i].touch.n_W - n).norm(), 1e-12);
      EXPECT_NEAR(std::abs((m.candidate[i].touch.p_W - X.p).dot(along)), 0.9e-3, 1e-9);
    }
  }
}

TEST(Field, AWireAcrossARidgeTouchesTheRidge) {
  const Ground ridge([](double x, double) { return -0.5 * std::abs(x - 2.4e-3); });
  const Solid b = ridge.solid(), a = wire(SWAGE_SHAPE_CAPSULE, 50e-6, 0.9e-3);
  const Pose X(Vec3(0.4e-3, 0.03e-3, 50e-6 - 1e-6), Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitX()));
  // and its flanks beside it, less deep
  const Manifold m = touch(a, X, b);
  int deep = 0;
  for (int i = 0; i < m.count; ++i) {
    const Candidate& c = m.candidate[static_cast<size_t>(i)];
    if (c.touch.gap >= 0) continue;
    ++deep;
    EXPECT_NEAR(c.touch.gap, -1e-6, 1e-15);
    EXPECT_EQ(c.b.kind, Feature::kSegment);
    EXPECT_LT((c.touch.n_W - Vec3::UnitZ()).norm(), 1e-12);
  }
  EXPECT_EQ(deep, 1);
}

TEST(Field, ABallInAGrooveTouchesBothFlanks) {
  const Ground groove([](double x, double) { return std::abs(x - 2.4e-3); });
  const Solid b = groove.solid(), a = wire(SWAGE_SHAPE_SPHERE, 50e-6, 0);
  const double height = std::sqrt(2.0) * (50e-6 - 1e-6);
  const Manifold m = touch(a, Pose(Vec3(0.4e-3, 0.03e-3, height), Quat::Identity()), b, 20e-6, 0);
  ASSERT_EQ(m.count, 2);
  for (size_t i = 0; i < 2; ++i) EXPECT_NEAR(m.candidate[i].touch.gap, -1e-6, 1e-12);
  EXPECT_NEAR(m.candidate[0].touch.n_W.dot(m.candidate[1].touch.n_W), 0, 1e-12);
}

TEST(Field, ReevaluationAgreesWithAFreshLook) {
  base::Xoshiro256 random(5);
  const Ground ground([&](double, double) { return random.uniform(-0.05e-3, 0.05e-3); });
  const Solid b = ground.solid(), a = wire(SWAGE_SHAPE_CAPSULE, 50e-6, 0.5e-3);
  int seen = 0;
  for (int k = 0; k < 200; ++k) {
    const Pose X(Vec3(random.uniform(-1e-3, 1e-3), random.uniform(-1e-3, 1e-3), 0.09e-3),
                 toolkit::exp_rotation({random.uniform(-2, 2), random.uniform(-2, 2), 0}));
    const Manifold m = touch(a, X, b, 60e-6);
    for (int i = 0; i < m.count; ++i, ++seen) {
      const Candidate& c = m.candidate[static_cast<size_t>(i)];
      const Touch again = reevaluate(c, Frame(X), Frame());
      EXPECT_NEAR(again.gap, c.touch.gap, 1e-12);
      EXPECT_LT((again.p_W - c.touch.p_W).norm(), 1e-9);
      EXPECT_LT((again.n_W - c.touch.n_W).norm(), 1e-6);
    }
  }
  EXPECT_GT(seen, 100);
}

TEST(Field, DeeperThanItsSolidReachesNothingIsTouched) {
  const Ground plane([](double, double) { return 0.0; });
  const Solid b = plane.solid(), a = wire(SWAGE_SHAPE_SPHERE, 50e-6, 0);
  EXPECT_EQ(touch(a, Pose(Vec3(0, 0, -0.9e-3), Quat::Identity()), b).count, 3);
  EXPECT_EQ(touch(a, Pose(Vec3(0, 0, -1.1e-3), Quat::Identity()), b).count, 0);
}

TEST(Field, TheDetectorReadsHeightsThatTheObjectKeeps) {
  Ground ground([](double, double) { return 0.0; });
  scene::World& w = ground.world;
  w.body.resize(2);
  for (auto& body : w.body) body.start = Pose().abi();
  w.shape.resize(2);
  w.shape[0].body = 0, w.shape[0].object = 0;
  w.shape[1].kind = SWAGE_SHAPE_SPHERE;
  w.shape[1].body = 1, w.shape[1].object = 1;
  w.shape[1].X_BS = Pose().abi();
  w.shape[1].radius = 50e-6;
  w.field[0].state = 1;  // after one other number
  w.plugin_state.assign(1 + kN * kN, 0.0);
  scene::reset(w);
  w.X_WB[1].p = {0.1e-3, 0.1e-3, 0.3e-3};
  Pair pair;
  pair.object_a = 1, pair.object_b = 0;
  Detector detector(w, {pair}, {});
  ContactSet set;
  detector.reserve(set);
  detector.detect(w, set);
  EXPECT_TRUE(set.contact.empty());
  std::fill(w.plugin_state.begin() + 1, w.plugin_state.end(), 0.251e-3);
  detector.detect(w, set);
  ASSERT_EQ(set.contact.size(), 3u);
  EXPECT_NEAR(set.contact[0].gap, -1e-6, 1e-15);
}

}  // namespace field_test
}  // namespace swage::contact
