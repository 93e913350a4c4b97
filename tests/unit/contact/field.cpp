// SPDX-License-Identifier: Apache-2.0
//
// Wires against a height field, judged by distances to all its triangles.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

#include "base/rng.hpp"
#include "contact/detector.hpp"
#include "contact/narrow_phase.hpp"
#include "scene/kinematics.hpp"

namespace swage::contact {
namespace {

using toolkit::Quat;

constexpr double kCell = 0.2e-3;  // m
constexpr uint32_t kN = 25;

/// Heights over 24 x 24 cells, and the shape of a wire above them.
struct Ground {
  scene::World world;
  explicit Ground(const std::function<double(double, double)>& z) {
    scene::HeightFieldInfo info{kN, kN, kCell, kCell, 1e-3, {}, scene::kNone};
    for (uint32_t j = 0; j < kN; ++j)
      for (uint32_t i = 0; i < kN; ++i) info.height.push_back(z(i * kCell, j * kCell));
    world.field.push_back(info);
    world.shape.resize(1);
    world.shape[0].kind = SWAGE_SHAPE_HEIGHT_FIELD;
    world.shape[0].field = 0;
    world.shape[0].X_BS = Pose(Vec3(-2e-3, -2e-3, 0), Quat::Identity()).abi();
  }
  Solid solid() const { return make_solid(world, 0); }
  double at(double x, double y) const { return solid().field.height_at(x + 2e-3, y + 2e-3); }
};

Solid wire(int32_t kind, double radius, double half_length, double arc_radius = 0, double sweep = 0) {
  scene::Shape s;
  s.kind = kind;
  s.X_BS = Pose().abi();
  s.radius = radius, s.half_length = half_length, s.arc_radius = arc_radius, s.sweep = sweep;
  return make_solid(s, {});
}

/// Distance of p to a triangle, from Voronoi regions of its own (Ericson, Real-Time Collision Detection, 5.1.5).
double distance(const Vec3& p, const toolkit::HeightField::Corners& t) {
  const Vec3 ab = t.b - t.a, ac = t.c - t.a, ap = p - t.a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return ap.norm();
  const Vec3 bp = p - t.b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return bp.norm();
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return (ap - d1 / (d1 - d3) * ab).norm();
  const Vec3 cp = p - t.c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return cp.norm();
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return (ap - d2 / (d2 - d6) * ac).norm();
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6) return (bp - (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (t.c - t.b)).norm();
  return std::abs(t.normal().normalized().dot(ap));
}

/// Distance of a place above the surface, by looking at all triangles within 0.8 mm; farther, that.
double distance(const Vec3& p_H, const toolkit::HeightField& f) {
  double least = 4 * kCell;
  const auto near = [](double t, uint32_t k) { return std::abs(t / kCell - k) < 5; };
  for (uint32_t j = 0; j + 1 < f.ny; ++j)
    for (uint32_t i = 0; i + 1 < f.nx; ++i)
      if (near(p_H.x(), i) && near(p_H.y(), j))
        for (uint32_t half = 0; half < 2; ++half)
          least = std::min(least, distance(p_H, f.corners(2 * (j * f.nx + i) + half)));
  return least;
}

/// Least gap of a wire whose centre line is above the surface: samples, then golden section about the lowest ones.
template <class PointAt>
double searched_gap(const PointAt& point_H, const toolkit::HeightField& f, double radius) {
  constexpr int kSamples = 128;
  std::vector<double> d;
  for (int i = 0; i <= kSamples; ++i) d.push_back(distance(point_H(i / double{kSamples}), f));
  double best = *std::min_element(d.begin(), d.end());
  if (*std::max_element(d.begin(), d.end()) == best) return best - radius;  // a ball
  for (int i = 0; i <= kSamples; ++i) {
    if (d[static_cast<size_t>(i)] > best + 15e-6) continue;
    double a = std::max(0, i - 1) / double{kSamples}, b = std::min(kSamples, i + 1) / double{kSamples};
    for (int k = 0; k < 40; ++k) {
      const double c = b - 0.6180339887498949 * (b - a), e = a + 0.6180339887498949 * (b - a);
      (distance(point_H(c), f) < distance(point_H(e), f) ? b : a) =
          distance(point_H(c), f) < distance(point_H(e), f) ? e : c;
    }
    best = std::min(best, distance(point_H(0.5 * (a + b)), f));
  }
  return best - radius;
}

double least(const Manifold& m) {
  double gap = 1;
  for (int i = 0; i < m.count; ++i) gap = std::min(gap, m.candidate[static_cast<size_t>(i)].touch.gap);
  return gap;
}

Manifold touch(const Solid& a, const Pose& X_WA, const Solid& b, double margin = 20e-6,
               double flatness = 2e-3) {
  Manifold m;
  Separation none;
  Query query;
  query.margin = margin, query.flatness = flatness;
  collide(a, Frame(X_WA), b, Frame(), query, none, m);
  return m;
}

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

}  // namespace
}  // namespace swage::contact
