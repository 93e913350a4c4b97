// SPDX-License-Identifier: Apache-2.0
//
// Polyhedron against polyhedron, judged by distances and directions of all their features.
#include "toolkit/convex.hpp"

#include <gtest/gtest.h>

#include "base/rng.hpp"
#include "contact/narrow_phase.hpp"
#include "contact/sweep.hpp"
#include "least.hpp"
#include "solids.hpp"

namespace swage::contact {
namespace convex_test {

using toolkit::Convex;
using toolkit::Quat;

Solid solid_of(const Convex& convex) { return make_solid(bench::convex_shape(), {convex}); }

/// A box about the origin.
Solid box(const Vec3& size) {
  std::vector<Vec3> vertex;
  for (int i = 0; i < 8; ++i)
    vertex.push_back(
        0.5 * Vec3(i & 1 ? size.x() : -size.x(), i & 2 ? size.y() : -size.y(), i & 4 ? size.z() : -size.z()));
  const uint32_t start[] = {0, 4, 8, 12, 16, 20, 24};
  const uint32_t index[] = {0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};
  Convex c;
  EXPECT_EQ(toolkit::build_convex(vertex, start, index, c), "");
  return solid_of(c);
}

Manifold touch(const Solid& a, const Pose& X_WA, const Solid& b, const Pose& X_WB, double margin = 20e-6) {
  Manifold m;
  Separation none;
  Query query;
  query.margin = margin;
  collide(a, Frame(X_WA), b, Frame(X_WB), query, none, m);
  return m;
}

/// How far two polyhedra are apart along n (unit, W), n from b to a.
double apart_along(const Convex& a, const Convex& b, const Vec3& n) {
  double low = 1e300, high = -1e300;
  for (const Vec3& v : a.vertex) low = std::min(low, n.dot(v));
  for (const Vec3& v : b.vertex) high = std::max(high, n.dot(v));
  return low - high;
}

/// Largest separation over all normals of faces and cross products of edges: the depth, when negative.
double depth(const Convex& a, const Convex& b) {
  double most = -1e300;
  for (const auto& f : a.face) most = std::max(most, apart_along(a, b, -f.n));
  for (const auto& f : b.face) most = std::max(most, apart_along(a, b, f.n));
  for (const auto& e : a.edge)
    for (const auto& f : b.edge) {
      const Vec3 n = e.u.cross(f.u);
      if (n.norm() < 1e-6) continue;
      most = std::max({most, apart_along(a, b, n.normalized()), apart_along(a, b, -n.normalized())});
    }
  return most;
}

/// Distance of two that are apart: all edges against all edges, all vertices against all faces.
double distance(const Convex& a, const Convex& b) {
  double d = 1e300;
  for (const auto& e : a.edge)
    for (const auto& f : b.edge) {
      const toolkit::Segment p{a.vertex[e.v0], a.vertex[e.v1]}, q{b.vertex[f.v0], b.vertex[f.v1]};
      const auto at = closest(p, q);
      d = std::min(d, (p.point(at.s) - q.point(at.t)).norm());
    }
  const auto over = [&](const Convex& base, const Convex& other) {
    for (const auto& f : base.face)
      for (const Vec3& v : other.vertex) {
        bool inside = f.n.dot(v) > f.d;
        for (size_t k = 0; k < f.side.size(); ++k) inside = inside && f.side[k].dot(v) <= f.side_d[k];
        if (inside) d = std::min(d, f.n.dot(v) - f.d);
      }
  };
  over(a, b), over(b, a);
  return d;
}

TEST(ConvexConvex, GapsAgreeWithASearchOverAllFeatures) {
  const Solid a = bench::contact_solid(bench::jaw(1)), b = box({3e-3, 2e-3, 1e-3});
  base::Xoshiro256 random(11);
  const auto draw = [&](double size) {
    return Vec3(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
  };
  int near = 0, deep = 0;
  for (int k = 0; k < 20000; ++k) {
    const Pose X(draw(3e-3) - Vec3(7e-3, 0, 0), Quat::Identity()),
        turned(Vec3::Zero(), toolkit::exp_rotation(draw(2)));
    const Pose X_WA = turned * X, X_WB(draw(1e-3), toolkit::exp_rotation(draw(2)));
    const Convex p = transformed(a.convex, X_WA), q = transformed(b.convex, X_WB);
    const double sat = depth(p, q);
    const double exact = sat > 0 ? distance(p, q) : sat;
    if (exact > 0.2e-3 || exact < -0.1e-3) continue;
    const Manifold m = touch(a, X_WA, b, X_WB, 0.2e-3);
    ASSERT_GT(m.count, 0) << "pose " << k << " at " << exact;
    // a face is preferred while it is no more than 40 nm worse than a pair of edges
    ASSERT_NEAR(least(m), exact, 41e-9) << "pose " << k;
    (exact > 0 ? near : deep) += 1;
    for (int i = 0; i < m.count; ++i) {
      const Candidate& c = m.candidate[static_cast<size_t>(i)];
      ASSERT_NEAR(c.touch.n_W.norm(), 1, 1e-12);
      ASSERT_NEAR(reevaluate(c, Frame(X_WA), Frame(X_WB)).gap, c.touch.gap, 1e-15);
    }
  }
  EXPECT_GT(near, 200);
  EXPECT_GT(deep, 100);
}

TEST(ConvexConvex, WhatIsFartherApartThanTheMarginIsNotReported) {
  const Solid a = box({1e-3, 1e-3, 1e-3}), b = box({1e-3, 1e-3, 1e-3});
  for (const double gap : {19e-6, 21e-6}) {
    const Pose X(Vec3(0.3e-3, 0, 1e-3 + gap), Quat::Identity());
    EXPECT_EQ(touch(a, X, b, Pose()).count, gap < 20e-6 ? 4 : 0);
  }
}

TEST(ConvexConvex, ABoxOnAnotherRestsOnThePolygonTheyShare) {
  const Solid a = box({1e-3, 1e-3, 1e-3}), b = box({4e-3, 4e-3, 1e-3});
  std::vector<uint64_t> names;
  for (int k = 0; k < 20; ++k) {
    // sliding, its names stay
    const Pose X(Vec3(30e-6 * k, 10e-6 * k, 1e-3 - 1e-6), toolkit::exp_rotation({0, 0, 0.3}));
    const Manifold m = touch(a, X, b, Pose());
    ASSERT_EQ(m.count, 4);
    double weight = 0;
    for (size_t i = 0; i < 4; ++i) {
      const Candidate& c = m.candidate[i];
      EXPECT_NEAR(c.touch.gap, -1e-6, 1e-15);
      EXPECT_LT((c.touch.n_W - Vec3::UnitZ()).norm(), 1e-12);
      weight += c.weight;
      if (k == 0) names.push_back(c.feature);
      EXPECT_EQ(c.feature, names[i]);
      for (size_t j = 0; j < i; ++j) EXPECT_NE(c.feature, m.candidate[j].feature);
    }
    EXPECT_DOUBLE_EQ(weight, 1);
  }
}

TEST(ConvexConvex, HangingOverAnEdgeItRestsOnWhatIsLeft) {
  const Solid a = box({2e-3, 1e-3, 1e-3}), b = box({2e-3, 4e-3, 1e-3});
  const Manifold m = touch(a, Pose(Vec3(1.5e-3, 0, 1e-3), Quat::Identity()), b, Pose());
  ASSERT_EQ(m.count, 4);
  for (size_t i = 0; i < 4; ++i) {
    EXPECT_LE(m.candidate[i].touch.p_W.x(), 1e-3 + 1e-12);
    EXPECT_GE(m.candidate[i].touch.p_W.x(), 0.5e-3 - 1e-12);
  }
}

TEST(ConvexConvex, CrossedEdgesTouchInOnePoint) {
  const Solid a = box({1e-3, 1e-3, 1e-3});
  const double half = std::sqrt(0.5) * 1e-3;
  const Pose lower(Vec3::Zero(), toolkit::exp_rotation({M_PI / 4, 0, 0}));
  const Pose upper(Vec3(0, 0, 2 * half - 2e-6), toolkit::exp_rotation({0, M_PI / 4, 0}));
  const Manifold m = touch(a, upper, a, lower);
  ASSERT_EQ(m.count, 1);
  EXPECT_NEAR(m.candidate[0].touch.gap, -2e-6, 1e-12);
  EXPECT_LT((m.candidate[0].touch.n_W - Vec3::UnitZ()).norm(), 1e-12);
  EXPECT_LT(m.candidate[0].touch.p_W.head<2>().norm(), 1e-12);
}

TEST(ConvexConvex, CornerToCornerTheDistanceIsExact) {
  const Solid a = box({1e-3, 1e-3, 1e-3});
  const Vec3 off(3e-6, 4e-6, 12e-6);
  const Manifold m = touch(a, Pose(Vec3::Constant(1e-3) + off, Quat::Identity()), a, Pose());
  EXPECT_NEAR(least(m), 13e-6, 1e-12);
}

TEST(ConvexConvex, SweptTheyNeverPassThroughEachOther) {
  const Solid plate = box({4e-3, 4e-3, 0.2e-3}), a = bench::contact_solid(bench::jaw(1));
  base::Xoshiro256 random(3);
  Manifold work;
  int through = 0;
  for (int k = 0; k < 200; ++k) {
    const auto draw = [&](double size) {
      return Vec3(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
    };
    Motion moving{Pose(Vec3(-7e-3, 0, 2e-3) + draw(0.5e-3), toolkit::exp_rotation(draw(0.1))),
                  Vec3(0, 0, -4e-3), draw(0.1)};
    const Motion still{Pose()};
    Separation memory;
    const FirstTouch first = first_touch(a, moving, plate, still, 1e-6, memory, work);
    double deepest = 1;
    for (int i = 0; i <= 100; ++i) {
      const double t = first.t * i / 100;
      deepest = std::min(deepest, depth(transformed(a.convex, moving.at(t)), plate.convex));
    }
    ASSERT_GT(deepest, -1e-9);
    through += first.hit;
  }
  EXPECT_GT(through, 150);
}

TEST(Cylinder, IsAPrismOfTheSameVolume) {
  scene::Shape s;
  s.kind = SWAGE_SHAPE_CYLINDER;
  s.X_BS = Pose().abi();
  s.radius = 1e-3, s.half_length = 2e-3;
  const Solid c = make_solid(s, {});
  // along the axis exact, across it within 0.15 %
  EXPECT_NEAR(support(c, Vec3::UnitZ()), 2e-3, 1e-15);
  double volume = 0;
  for (int k = 0; k < 100; ++k)
    EXPECT_NEAR(support(c, {std::cos(0.1 * k), std::sin(0.1 * k), 0}), 1e-3, 1.5e-6);
  for (const auto& f : c.convex.face)
    for (size_t i = 1; i + 1 < f.vertex.size(); ++i)
      volume += c.convex.vertex[f.vertex[0]].dot(
                    c.convex.vertex[f.vertex[i]].cross(c.convex.vertex[f.vertex[i + 1]])) /
                6;
  EXPECT_NEAR(volume, M_PI * 1e-6 * 4e-3, 1e-12 * M_PI);
}

TEST(Cylinder, StandsOnItsEndAndLiesOnItsSide) {
  scene::Shape s;
  s.kind = SWAGE_SHAPE_CYLINDER;
  s.X_BS = Pose().abi();
  s.radius = 0.5e-3, s.half_length = 1e-3;
  const Solid c = make_solid(s, {}), floor = box({10e-3, 10e-3, 1e-3});
  EXPECT_GE(touch(c, Pose(Vec3(0, 0, 1.5e-3 - 1e-6), Quat::Identity()), floor, Pose()).count, 4);
  const Pose lying(Vec3(0, 0, 1e-3), toolkit::exp_rotation({M_PI / 2, 0, 0}));
  EXPECT_NEAR(least(touch(c, lying, floor, Pose())), 0, 1e-6);
  // and a wire touches it
  const Solid wire = bench::contact_solid(bench::Needle());
  const Pose X_WN(
      Vec3(0.5e-3 + 50e-6 + 1e-6, 0, 0) - toolkit::exp_rotation({0, -M_PI / 2, 0}) * bench::Needle().point(0),
      toolkit::exp_rotation({0, -M_PI / 2, 0}));
  EXPECT_NEAR(least(touch(wire, X_WN, c, Pose())), 1e-6, 1e-6);
}

}  // namespace convex_test
}  // namespace swage::contact
