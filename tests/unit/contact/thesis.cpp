// SPDX-License-Identifier: Apache-2.0
//
// Thesis 4.2.1 to 4.2.10, formula by formula, each against something that shares no code with it.
#include "thesis_contact.hpp"

#include <gtest/gtest.h>

#include <set>

#include "base/rng.hpp"
#include "contact/sphere_tree.hpp"
#include "reference.hpp"
#include "solids.hpp"

namespace swage::contact::thesis {
namespace thesis_test {

struct Draw {
  base::Xoshiro256 random{4};
  double operator()(double size) { return random.uniform(-size, size); }
  Vec3 vec(double size = 1) { return {(*this)(size), (*this)(size), (*this)(size)}; }
};

TEST(Thesis, Eq17SpheresCollideFromTheSumOfTheirRadii) {
  EXPECT_DOUBLE_EQ(sphere_sphere({0, 0, 0}, 2, {0, 3, 4}, 4), 1);
  EXPECT_DOUBLE_EQ(sphere_sphere({0, 0, 0}, 2, {0, 3, 4}, 3), 0);
  EXPECT_LT(sphere_sphere({0, 0, 0}, 2, {0, 3, 4}, 2.9), 0);
}

TEST(Thesis, Eq18And19TheClosestPlaceOfAnEdge) {
  Draw draw;
  for (int k = 0; k < 2000; ++k) {
    const Vec3 p0 = draw.vec(2), p1 = draw.vec(), p2 = draw.vec();
    const Nearest near = sphere_edge(p0, p1, p2);
    double least = 1e300;
    for (int i = 0; i <= 2000; ++i) least = std::min(least, (p0 - (p1 + i / 2000.0 * (p2 - p1))).norm());
    ASSERT_NEAR(near.distance, least, 1e-3 * (p1 - p2).norm());
    ASSERT_LE(near.distance, least + 1e-15);
    ASSERT_NEAR((p0 - near.p_c).norm(), near.distance, 1e-15);
  }
}

TEST(Thesis, ThePrintedTestOfAnEdgeIsWrongWhereItIsNotOneUnitLong) {
  // 0 < v20 . v21 < |v21| with v21 whole, as printed: a place in the middle of a long edge would count as beyond its end
  const Vec3 p1(4, 0, 0), p2(0, 0, 0), p0(2, 1, 0), v21 = p1 - p2;
  EXPECT_FALSE((p0 - p2).dot(v21) < v21.norm());
  EXPECT_DOUBLE_EQ(sphere_edge(p0, p1, p2).distance, 1);
}

TEST(Thesis, Eq20And21DistanceToAPlane) {
  const Vec3 n(0, 0.6, 0.8);
  EXPECT_DOUBLE_EQ(sphere_plane(Vec3(7, 3, 4), n, 2), 3);
  EXPECT_LT(sphere_plane(Vec3(7, 0, 0), n, 2), 0);
}

/// A hexagon in a plane anyhow in space.
struct Hexagon {
  toolkit::Pose X;
  std::vector<Vec3> vertex;
  Polygon polygon;
  explicit Hexagon(Draw& draw) : X(draw.vec(), toolkit::exp_rotation(draw.vec(2))) {
    for (int i = 0; i < 6; ++i) vertex.push_back(X * Vec3(std::cos(i * M_PI / 3), std::sin(i * M_PI / 3), 0));
    polygon.vertex = vertex;
    polygon.n = X.q * Vec3::UnitZ();
    polygon.c = polygon.n.dot(X.p);
  }
  /// In its own plane, by the six half planes of its sides.
  bool inside(const Vec3& p_F) const {
    for (int i = 0; i < 6; ++i) {
      const double a = (i + 0.5) * M_PI / 3;
      if (p_F.x() * std::cos(a) + p_F.y() * std::sin(a) > std::sqrt(0.75)) return false;
    }
    return true;
  }
};

TEST(Thesis, Eq22APointIsInAPolygonWhereAllItsSidesAgree) {
  Draw draw;
  int in = 0, out = 0;
  for (int k = 0; k < 2000; ++k) {
    const Hexagon hexagon(draw);
    const Vec3 p_F = draw.vec(1.2);
    const bool expected = hexagon.inside(p_F);
    ASSERT_EQ(point_in_polygon(hexagon.X * p_F, hexagon.polygon), expected);
    (expected ? in : out) += 1;
  }
  EXPECT_GT(in, 500);
  EXPECT_GT(out, 200);
}

TEST(Thesis, Section425SpheresTouchPolygonsOverTheFaceAndBesideIt) {
  Draw draw;
  int hits = 0, misses = 0;
  for (int k = 0; k < 3000; ++k) {
    const Hexagon hexagon(draw);
    const Vec3 p_F = draw.vec(1.4);
    double least = hexagon.inside(p_F) ? std::abs(p_F.z()) : 1e300;
    for (size_t i = 0; i < 6; ++i)
      for (int j = 0; j <= 500; ++j)
        least = std::min(least,
                         (hexagon.X * p_F -
                          (hexagon.vertex[i] + j / 500.0 * (hexagon.vertex[(i + 1) % 6] - hexagon.vertex[i])))
                             .norm());
    constexpr double r = 0.3;
    if (std::abs(least - r) < 2e-3) continue;
    const auto found = sphere_polygon(hexagon.X * p_F, r, hexagon.polygon);
    ASSERT_EQ(found.has_value(), least < r) << k;
    if (found) {
      ASSERT_NEAR(std::abs(found->distance), least, 2e-3);
    }
    (found ? hits : misses) += 1;
  }
  EXPECT_GT(hits, 300);
  EXPECT_GT(misses, 300);
}

TEST(Thesis, Eq23APassedPolygonWasMetInProportionToTheHeights) {
  Draw draw;
  const Hexagon hexagon(draw);
  const auto at = [&](double x, double z) { return Vec3(hexagon.X * Vec3(x, 0, z)); };
  const auto t = dynamic_sphere_polygon(at(0, 0.3), hexagon.polygon, at(0.2, -0.1), hexagon.polygon, 5, 0.4);
  ASSERT_TRUE(t);
  EXPECT_NEAR(*t, 5 + 0.75 * 0.4, 1e-12);
  EXPECT_FALSE(dynamic_sphere_polygon(at(0, 0.3), hexagon.polygon, at(0.2, 0.1), hexagon.polygon, 5, 0.4))
      << "stays above";
  EXPECT_FALSE(dynamic_sphere_polygon(at(3, 0.3), hexagon.polygon, at(3, -0.1), hexagon.polygon, 5, 0.4))
      << "beside";
  EXPECT_FALSE(dynamic_sphere_polygon(at(0, -0.3), hexagon.polygon, at(0, 0.1), hexagon.polygon, 5, 0.4))
      << "from below";
}

TEST(Thesis, Eq25To33TwoLinesAreClosestAtTheirCommonNormal) {
  Draw draw;
  for (int k = 0; k < 1000; ++k) {
    const Vec3 p0 = draw.vec(), u = draw.vec(), q0 = draw.vec(), v = draw.vec();
    const ClosestPair pair = line_line(p0, u, q0, v);
    ASSERT_NEAR(u.dot(pair.w), 0, 1e-9);  // (4.28)
    ASSERT_NEAR(v.dot(pair.w), 0, 1e-9);  // (4.29)
    ASSERT_LT((p0 + pair.s * u - q0 - pair.t * v - pair.w).norm(), 1e-12);
    const Vec3 n = u.cross(v).normalized();
    ASSERT_NEAR(pair.w.norm(), std::abs(n.dot(p0 - q0)), 1e-9);
  }
  const ClosestPair parallel = line_line({0, 0, 0}, {1, 0, 0}, {5, 2, 0}, {3, 0, 0});
  EXPECT_EQ(parallel.s, 0);
  EXPECT_DOUBLE_EQ(parallel.w.norm(), 2);
}

TEST(Thesis, Eq34To36TwoEdgesAreClosestInTheUnitSquare) {
  Draw draw;
  for (int k = 0; k < 3000; ++k) {
    const Vec3 p0 = draw.vec(), u = draw.vec(), q0 = draw.vec();
    const Vec3 v = k % 4 == 0 ? Vec3(draw(2) * u) : draw.vec();
    const ClosestPair pair = edge_edge(p0, u, q0, v);
    const toolkit::Segment p{p0, p0 + u}, q{q0, q0 + v};
    const auto at = closest(p, q);
    ASSERT_NEAR(pair.w.norm(), (p.point(at.s) - q.point(at.t)).norm(), 1e-8);
    ASSERT_TRUE(pair.s >= 0 && pair.s <= 1 && pair.t >= 0 && pair.t <= 1);
  }
}

// --- 4.2.9, 4.2.10

TEST(Thesis, EveryNodeOfTheTreeEnclosesItsSpheresAndEverySphereIsInOneLeaf) {
  const Solid needle = bench::contact_solid(bench::Needle());
  for (const int levels : {1, 3, 4, 5, 12})
    for (const uint32_t few : {1u, 4u}) {
      const SphereTree tree = build_sphere_tree(sphere_chain(needle.arc, 100), needle.radius, {levels, few});
      std::set<uint32_t> in_leaves;
      for (const auto& n : tree.node) {
        for (uint32_t i = n.first; i < n.first + n.count; ++i) {
          EXPECT_LE((tree.centre[i] - n.centre).norm() + tree.radius, n.radius * (1 + 1e-12));
          const bool fresh = !n.leaf || in_leaves.insert(tree.number[i]).second;
          EXPECT_TRUE(fresh);
        }
        EXPECT_GT(n.skip, static_cast<uint32_t>(&n - tree.node.data()));
      }
      EXPECT_EQ(in_leaves.size(), 100u);
      EXPECT_EQ(tree.node.size() == 1, levels == 1);
    }
}

/// A needle's chain of 100 spheres anywhere about a jaw, seen from the jaw.
class ChainAtAJaw : public testing::Test {
 protected:
  using Hits = std::set<std::pair<uint32_t, uint32_t>>;  // sphere, faces that it touches as bits

  ChainAtAJaw() {
    for (const auto& f : solid.convex.face) {
      loops.emplace_back();
      for (const uint32_t v : f.vertex) loops.back().push_back(solid.convex.vertex[v]);
      polygons.push_back({{}, f.n, f.d});
    }
    for (size_t i = 0; i < loops.size(); ++i) polygons[i].vertex = loops[i];
  }

  toolkit::Pose any_pose() {
    return {Vec3(7e-3, 0, 0) + draw.vec(1.5e-3), toolkit::exp_rotation(draw.vec(3))};
  }
  uint32_t faces_touched(const Vec3& p) const {
    uint32_t faces = 0;
    for (uint32_t f = 0; f < polygons.size(); ++f)
      if (sphere_polygon(p, needle.radius, polygons[f])) faces |= 1u << f;
    return faces;
  }
  Hits brute_force(const toolkit::Pose& X) const {
    Hits hits;
    for (uint32_t i = 0; i < 100; ++i)
      if (const uint32_t faces = faces_touched(X * chain[i])) hits.insert({i, faces});
    return hits;
  }
  Hits by_tree(const SphereTree& tree, const toolkit::Pose& X) const {
    Hits hits;
    const auto near = [&](const Vec3& centre, double radius) {
      const Vec3 p = X * centre;
      for (const Polygon& f : polygons)
        if (sphere_polygon(p, radius, f)) return true;
      // a ball that holds the whole jaw touches none of its surfaces
      return (p - solid.centre).norm() < radius + solid.bound && jaw.distance(p) < radius;
    };
    tree.visit(near, [&](uint32_t i) {
      const uint32_t number = tree.number[i];
      if (const uint32_t faces = faces_touched(X * chain[number])) hits.insert({number, faces});
    });
    return hits;
  }

  const Solid needle = bench::contact_solid(bench::Needle());
  const bench::Solid jaw{bench::jaw(1)};
  const Solid solid = bench::contact_solid(bench::jaw(1));
  const std::vector<Vec3> chain = sphere_chain(needle.arc, 100);
  std::vector<std::vector<Vec3>> loops;
  std::vector<Polygon> polygons;
  Draw draw;
};

TEST_F(ChainAtAJaw, TheTreeFindsWhatBruteForceFindsAtTenThousandPoses) {
  const SphereTree trees[] = {build_sphere_tree(chain, needle.radius, {3, 4}),
                              build_sphere_tree(chain, needle.radius, {4, 4}),
                              build_sphere_tree(chain, needle.radius, {5, 4})};
  int touching = 0;
  for (int k = 0; k < 10000; ++k) {
    const toolkit::Pose X = any_pose();
    const Hits brute = brute_force(X);
    touching += !brute.empty();
    for (const SphereTree& tree : trees) ASSERT_EQ(by_tree(tree, X), brute) << "pose " << k;
  }
  EXPECT_GT(touching, 2000);
}

// so that the comparison can fail
TEST_F(ChainAtAJaw, ATreeWhoseNodesAreTooSmallMissesSome) {
  SphereTree shrunk = build_sphere_tree(chain, needle.radius, {5, 4});
  for (auto& node : shrunk.node) node.radius *= 0.3;
  int missed = 0;
  for (int k = 0; k < 1000; ++k) {
    const toolkit::Pose X = any_pose();
    missed += by_tree(shrunk, X).size() < brute_force(X).size();
  }
  EXPECT_GT(missed, 0);
}

}  // namespace thesis_test
}  // namespace swage::contact::thesis
