// SPDX-License-Identifier: Apache-2.0
#include "toolkit/convex.hpp"

#include <gtest/gtest.h>

namespace swage::toolkit {
namespace {

struct Cube {
  std::vector<Vec3> vertex;
  std::vector<uint32_t> start{0, 4, 8, 12, 16, 20, 24};
  std::vector<uint32_t> index{0, 4, 6, 2, 1, 3, 7, 5, 0, 1, 5, 4, 2, 6, 7, 3, 0, 2, 3, 1, 4, 5, 7, 6};
  Cube() {
    for (int i = 0; i < 8; ++i) vertex.emplace_back(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1);
  }
  std::string build(Convex& out) const { return build_convex(vertex, start, index, out); }
};

TEST(Convex, ACubeHasItsPlanesEdgesAndSides) {
  Convex c;
  ASSERT_EQ(Cube().build(c), "");
  EXPECT_EQ(c.face.size(), 6u);
  EXPECT_EQ(c.edge.size(), 12u);
  for (const auto& f : c.face) {
    EXPECT_DOUBLE_EQ(f.d, 1);
    EXPECT_DOUBLE_EQ(f.n.norm(), 1);
    for (size_t i = 0; i < 4; ++i) {
      EXPECT_DOUBLE_EQ(f.side[i].dot(f.n), 0);
      EXPECT_DOUBLE_EQ(f.side_d[i], 1) << "outward";
    }
  }
  for (const auto& e : c.edge) {
    EXPECT_DOUBLE_EQ(e.length, 2);
    // each side looks from its own face across the edge, which is along the other face's normal
    EXPECT_LT((e.side_left - c.face[e.face_right].n).norm(), 1e-15);
    EXPECT_LT((e.side_right - c.face[e.face_left].n).norm(), 1e-15);
  }
  for (const auto& edges : c.edges_at) EXPECT_EQ(edges.size(), 3u);
  EXPECT_DOUBLE_EQ(c.height({0, 0, 0.25}), -0.75);
  EXPECT_DOUBLE_EQ(c.height({3, 0, 0}), 2);
  EXPECT_DOUBLE_EQ(c.support({1, 2, 3}), 6);
}

TEST(Convex, MovedItIsTheSameBodySeenFromElsewhere) {
  Convex c;
  ASSERT_EQ(Cube().build(c), "");
  const Pose X({3, -2, 1}, exp_rotation({0.4, 0.5, -0.6}));
  const Convex moved = transformed(c, X);
  for (size_t f = 0; f < c.face.size(); ++f) {
    EXPECT_LT((moved.face[f].n - X.q * c.face[f].n).norm(), 1e-15);
    for (const uint32_t v : moved.face[f].vertex)
      EXPECT_NEAR(moved.face[f].n.dot(moved.vertex[v]), moved.face[f].d, 1e-14);
    for (size_t i = 0; i < moved.face[f].side.size(); ++i)
      EXPECT_NEAR(moved.face[f].side[i].dot(moved.vertex[moved.face[f].vertex[i]]), moved.face[f].side_d[i],
                  1e-14);
  }
  const Vec3 p(0.3, 0.2, 2);
  EXPECT_NEAR(moved.height(X * p), c.height(p), 1e-14);
}

TEST(Convex, AFaceCoversWhatIsBesideNoneOfItsEdges) {
  Convex c;
  ASSERT_EQ(Cube().build(c), "");
  for (const Convex::Face& f : c.face) {
    const Vec3 along = f.side[0];
    EXPECT_TRUE(f.covers(1.5 * f.n + 0.99 * along));
    EXPECT_TRUE(f.covers(0.5 * f.n - 0.99 * along));
    EXPECT_FALSE(f.covers(1.5 * f.n + 1.01 * along));
    EXPECT_FALSE(f.covers(0.5 * f.n - 1.01 * along));
  }
}

TEST(Convex, RefusesWhatIsNoClosedConvexBody) {
  Convex c;
  const auto with = [&](auto&& change) {
    Cube cube;
    change(cube);
    return cube.build(c);
  };
  EXPECT_NE(with([](Cube& k) { k.vertex[7] *= 0.5; }), "") << "a face is bent";
  EXPECT_NE(with([](Cube& k) { std::swap(k.index[1], k.index[3]); }), "") << "a face runs backwards";
  EXPECT_NE(with([](Cube& k) { k.start.pop_back(), k.index.resize(20); }), "") << "a face is missing";
  EXPECT_NE(with([](Cube& k) { k.index[0] = 8; }), "") << "no such vertex";
  EXPECT_NE(with([](Cube& k) { k.vertex.emplace_back(5, 5, 5); }), "") << "an unused vertex outside";
  EXPECT_NE(with([](Cube& k) { k.vertex[0].x() = NAN; }), "");
  EXPECT_NE(with([](Cube& k) { k.vertex[1] = k.vertex[0]; }), "") << "an edge without length";
  EXPECT_EQ(with([](Cube&) {}), "");
}

}  // namespace
}  // namespace swage::toolkit
