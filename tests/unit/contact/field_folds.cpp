// SPDX-License-Identifier: Apache-2.0
//
// Folded height fields: no place above or under the surface is without a contact. Judged by all triangles: above the surface the
// least distance, under it the height over the plane of the triangle straight above.
#include "field_scene.hpp"

namespace swage::contact {
namespace field_folds_test {

constexpr double kRadius = 50e-6, kMargin = 20e-6;  // m
/// A ridge of less than 0.03 rad is no feature: the gap at it is off by (radius + margin) 0.03^2 / 8 at most [m].
constexpr double kSmoothOff = 8e-9;

/// Where the triangle straight above changes at such a ridge, or groove, the height steps by this share of the depth at most, with the
/// slopes of here; a step is no minimum.
constexpr double kStep = 0.015;

/// Signed distance of a centre line's place, as the room promises it.
double signed_distance(const Vec3& p_H, const toolkit::HeightField& f) {
  if (p_H.z() >= f.height_at(p_H.x(), p_H.y())) return distance(p_H, f);
  const auto t = f.corners(f.triangle_at(p_H.x(), p_H.y()));
  return t.normal().normalized().dot(p_H - t.a);
}

Ground folded(double height, uint64_t seed) {
  base::Xoshiro256 random(seed);
  return Ground([&](double, double) { return random.uniform(-height, height); });
}

/// Balls about edges and vertices, in the strips where the faces beside them end square to themselves.
void compare_balls(double height, double deep, uint64_t seed) {
  const Ground ground = folded(height, seed);
  const Solid a = wire(SWAGE_SHAPE_SPHERE, kRadius, 0), b = ground.solid();
  base::Xoshiro256 random(seed + 100);
  int missing = 0, off = 0;
  for (int k = 0; k < 4000; ++k) {
    const auto i = static_cast<uint32_t>(random.uniform(4, kN - 5)), j = static_cast<uint32_t>(random.uniform(4, kN - 5));
    const int kind = k % 4;  // an edge along x, along y, the diagonal, a vertex
    const double s = kind == 3 ? 0 : random.uniform(0, 1);
    const Vec3 v = b.field.vertex(i, j), w = b.field.vertex(i + (kind != 1), j + (kind != 0));
    Vec3 p = v + s * (w - v);
    for (int axis = 0; axis < 2; ++axis) p[axis] += random.uniform(-3e-6, 3e-6);
    p.z() = b.field.height_at(p.x(), p.y()) + random.uniform(-deep, kRadius + 0.5 * kMargin);
    const double exact = signed_distance(p, b.field) - kRadius;
    const Manifold m = touch(a, Pose(b.X_BH * p, Quat::Identity()), b, kMargin, 0);
    missing += m.count == 0;
    off += m.count > 0 && std::abs(least(m) - exact) > kSmoothOff;
  }
  EXPECT_EQ(missing, 0);
  EXPECT_EQ(off, 0);
}

TEST(FieldFolds, ABallAboveAShallowFoldTouches) { compare_balls(1e-6, 0, 11); }
TEST(FieldFolds, ABallAboveAnyFoldTouches) { compare_balls(0.1e-3, 0, 12); }
TEST(FieldFolds, ABallUnderAShallowFoldTouches) { compare_balls(1e-6, 0.4e-3, 13); }
TEST(FieldFolds, ABallUnderAnyFoldTouches) { compare_balls(0.1e-3, 0.4e-3, 14); }

/// Least gap along a wire by samples 0.6 um apart or nearer, then by golden section about the lowest.
double searched(const std::function<Vec3(double)>& point_H, const toolkit::HeightField& f) {
  constexpr int kSamples = 4096;
  const auto at = [&](double s) { return signed_distance(point_H(s), f); };
  double best = 1, where = 0;
  for (int i = 0; i <= kSamples; ++i) {
    const double d = at(i / double{kSamples});
    if (d < best) best = d, where = i / double{kSamples};
  }
  double a = std::max(0.0, where - 1.0 / kSamples), b = std::min(1.0, where + 1.0 / kSamples);
  for (int k = 0; k < 40; ++k) {
    const double c = b - 0.6180339887498949 * (b - a), e = a + 0.6180339887498949 * (b - a);
    const double at_c = at(c), at_e = at(e);
    best = std::min({best, at_c, at_e});
    (at_c < at_e ? b : a) = at_c < at_e ? e : c;
  }
  return best - kRadius;
}

/// Wires whose centre line dips up to `deep` under the surface.
void compare_wires(const Solid& a, const std::function<Vec3(double)>& point_A, double height, double deep, uint64_t seed) {
  const Ground ground = folded(height, seed);
  const Solid b = ground.solid();
  base::Xoshiro256 random(seed + 100);
  const auto draw = [&](double size) { return random.uniform(-size, size); };
  for (int k = 0; k < 40; ++k) {
    Pose X(Vec3(draw(0.5e-3), draw(0.5e-3), 2e-3), toolkit::exp_rotation({draw(3), draw(3), draw(3)}));
    const auto on = [&](double s) { return b.X_BH.inverse_times(X * point_A(s)); };
    // the height over the surface goes down as the wire does
    double clear = 1;
    for (int i = 0; i <= 256; ++i) {
      const Vec3 p = on(i / 256.0);
      clear = std::min(clear, p.z() - b.field.height_at(p.x(), p.y()));
    }
    X.p.z() -= clear + random.uniform(-kRadius, deep);
    const double exact = searched(on, b.field);
    if (exact > kMargin) continue;
    for (const double flatness : {0.0, 2e-3}) {
      const Manifold m = touch(a, X, b, kMargin, flatness);
      ASSERT_GT(m.count, 0) << "pose " << k;
      ASSERT_GE(least(m), exact - 20e-9) << "pose " << k << ", flatness " << flatness;
      ASSERT_LE(least(m), exact + 20e-9 + kStep * std::max(0.0, -exact - kRadius)) << "pose " << k << ", flatness " << flatness;
    }
  }
}

Solid capsule() { return wire(SWAGE_SHAPE_CAPSULE, kRadius, 1e-3); }
Vec3 on_capsule(double s) { return {0, 0, 2e-3 * (s - 0.5)}; }
constexpr double kArc = 1e-3, kSweep = 2.4;  // m, rad
Solid arc() { return wire(SWAGE_SHAPE_ARC, kRadius, 0, kArc, kSweep); }
Vec3 on_arc(double s) { return {kArc * std::cos(s * kSweep), kArc * std::sin(s * kSweep), 0}; }

TEST(FieldFolds, CapsulesThatDipUnderShallowFoldsTouch) { compare_wires(capsule(), on_capsule, 2e-6, 0.4e-3, 21); }
TEST(FieldFolds, CapsulesThatDipUnderAnyFoldTouch) { compare_wires(capsule(), on_capsule, 0.05e-3, 0.4e-3, 22); }
TEST(FieldFolds, ArcsThatDipUnderShallowFoldsTouch) { compare_wires(arc(), on_arc, 2e-6, 0.4e-3, 23); }
TEST(FieldFolds, ArcsThatDipUnderAnyFoldTouch) { compare_wires(arc(), on_arc, 0.05e-3, 0.4e-3, 24); }

TEST(FieldFolds, ABallIsHandedOverAShallowRidgeByOneFaceToTheNext) {
  const Ground ridge([](double x, double) { return -0.01 * std::abs(x - 2.4e-3); });
  const Solid a = wire(SWAGE_SHAPE_SPHERE, kRadius, 0), b = ridge.solid();
  double last = 0;
  for (int k = -40; k <= 40; ++k) {
    const Pose X(Vec3(0.4e-3 + 7e-9 + 50e-9 * k, 0.03e-3, kRadius - 1e-6), Quat::Identity());
    const Manifold m = touch(a, X, b, kMargin, 0);
    ASSERT_EQ(m.count, 1) << k;
    if (k > -40) {
      EXPECT_NEAR(least(m), last, 0.011 * 50e-9);
    }
    last = least(m);
  }
}

}  // namespace field_folds_test
}  // namespace swage::contact
