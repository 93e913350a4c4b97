// SPDX-License-Identifier: Apache-2.0
#include "console/view3d/soft_surface.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>

#include "console/view3d/visual_marks.hpp"
#include "mesh_measures.hpp"

namespace swage::console {
namespace {

// a square of 4 mm in the plane z = 0, seen from above
Mesh square() {
  Mesh m;
  for (const auto& [x, y] : {std::pair{-2.F, -2.F}, {2.F, -2.F}, {2.F, 2.F}, {-2.F, 2.F}})
    m.vertex.push_back({{x, y, 0}, {0, 0, 1}});
  m.index = {0, 1, 2, 0, 2, 3};
  return m;
}

double area(const Mesh& m) {
  return area(m, [](const QVector3D& n) { return n.length(); });
}

TEST(SoftSurface, RefiningKeepsTheSurfaceWholeAndIsFineWhereItIsDented) {
  QMatrix4x4 X;
  X.translate(0.3F, 0, 1);
  const std::vector<Dent> dents = {{{0.3F, 0.2F, 1}, {0, 0, -0.05F}, 0.05F}};
  const Mesh fine = refined(square(), X, dents);
  EXPECT_NEAR(area(fine), 16, 1e-4);
  EXPECT_LT(fine.index.size(), 3U * 4000);
  std::map<std::pair<uint32_t, uint32_t>, int> sides;
  for (size_t i = 0; i < fine.index.size(); i += 3)
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t a = fine.index[i + k], b = fine.index[i + (k + 1) % 3];
      const QVector3D middle = 0.5F * (at(fine, a) + at(fine, b));
      const float from = (X.map(middle) - dents[0].p).length();
      EXPECT_LE((at(fine, a) - at(fine, b)).length(), 0.4F * std::max(from, 0.05F) * 1.001F);
      sides[std::minmax(a, b)] += a < b ? 1 : -1;
    }
  // every inner edge has a triangle on either side; other edges are the rim of the square
  for (const auto& [edge, balance] : sides) {
    if (balance == 0) continue;
    const QVector3D middle = 0.5F * (at(fine, edge.first) + at(fine, edge.second));
    EXPECT_FLOAT_EQ(std::max(std::abs(middle.x()), std::abs(middle.y())), 2);
  }
  // without dents nothing is refined
  EXPECT_EQ(refined(square(), X, {}).index, square().index);
}

TEST(SoftSurface, ADentIsAsDeepAsItSaysAndHasTheNormalsOfItsSurface) {
  const std::vector<Dent> dents = {{{0.3F, 0, 0}, {0, 0, -0.2F}, 0.5F}};
  Mesh dented;
  QMatrix4x4 X;
  X.translate(0.1F, 0, 0);
  X.rotate(90, 0, 0, 1);
  const Mesh rest = refined(square(), X, dents, 0.1F);
  displace(rest, X, dents, dented);
  float deepest = 0;
  for (size_t i = 0; i < dented.vertex.size(); ++i) {
    const QVector3D p = X.map(at(rest, static_cast<uint32_t>(i)));
    const float r2 = (p - dents[0].p).lengthSquared();
    EXPECT_NEAR(dented.vertex[i].p[2], -0.2F / std::sqrt(1 + 4 * r2), 1e-5F);
    deepest = std::min(deepest, dented.vertex[i].p[2]);
    // compared with the normal by finite differences
    const auto depth = [&](float dx, float dy) { return displacement(dents, p + QVector3D(dx, dy, 0)).z(); };
    const float h = 0.01F;
    const QVector3D n_W(-(depth(h, 0) - depth(-h, 0)) / (2 * h), -(depth(0, h) - depth(0, -h)) / (2 * h), 1);
    const QVector3D n = X.mapVector({dented.vertex[i].n[0], dented.vertex[i].n[1], dented.vertex[i].n[2]});
    EXPECT_GT(QVector3D::dotProduct(n, n_W.normalized()), 0.9995F);
  }
  EXPECT_NEAR(deepest, -0.2F, 0.003F);
}

/// Bounds of a mesh and how many triangles it has.
struct Extent {
  explicit Extent(const Mesh& m) : triangles(m.index.size() / 3) {
    for (const Vertex& v : m.vertex)
      for (int k = 0; k < 3; ++k) low[k] = std::min(low[k], v.p[k]), high[k] = std::max(high[k], v.p[k]);
  }
  size_t triangles;
  float low[3] = {1e9F, 1e9F, 1e9F}, high[3] = {-1e9F, -1e9F, -1e9F};
};

// what a plugin draws that the console has never heard of: to scale, of its tone, and a line never thinner than can be seen
TEST(VisualMarks, LinesDiscsAndTubesBecomeTriangles) {
  const auto s = std::make_unique<snapshot::Snapshot>();
  Mesh ink, flesh, deep;
  Mesh* const by_tone[SWAGE_TONES] = {&ink, &flesh, &deep};
  const auto draw = [&](const swage_visual& v, double mm_per_pixel = 0.01) {
    ink = flesh = deep = {};
    s->n_visual = 1;
    s->visual[0].visual = v;
    return append_marks(*s, mm_per_pixel, by_tone);
  };
  swage_visual v{SWAGE_VISUAL_TUBE, SWAGE_NONE, 0, SWAGE_TONE_FLESH, {0, 0, 0}, {2e-3, 0, 0}, {0, 0, 0}, 0.1e-3, 1};
  ASSERT_TRUE(draw(v));
  const Extent tube(flesh);
  EXPECT_EQ(ink.index.size() + deep.index.size(), 0u);
  EXPECT_GT(tube.triangles, 10u);
  EXPECT_NEAR(tube.high[2], 0.1F, 0.01F);
  EXPECT_NEAR(tube.high[0], 2.1F, 0.02F);
  v.strength = 0.5;
  draw(v);
  EXPECT_NEAR(Extent(flesh).high[2], 0.05F, 0.005F) << "the share of the radius that is drawn";
  v.strength = 0;
  EXPECT_FALSE(draw(v));

  v = {SWAGE_VISUAL_LINE, SWAGE_NONE, 0, SWAGE_TONE_INK, {0, 0, 0}, {0, 1e-3, 0}, {0, 0, 0}, 0, 1};
  draw(v, 0.01);
  EXPECT_NEAR(Extent(ink).high[2], 0.0075F, 1e-3F) << "half of one and a half pixels";
  draw(v, 0.1);
  EXPECT_NEAR(Extent(ink).high[2], 0.075F, 1e-2F);

  v = {SWAGE_VISUAL_DISC, SWAGE_NONE, 0, SWAGE_TONE_DEEP, {1e-3, 0, 0}, {1e-3, 0, 0}, {1, 0, 0}, 0.5e-3, 1};
  draw(v);
  const Extent disc(deep);
  EXPECT_NEAR(disc.high[0] - disc.low[0], 0.02F, 1e-3F) << "flat along its normal";
  EXPECT_NEAR(disc.high[1], 0.5F, 0.02F);
  EXPECT_NEAR(disc.high[2], 0.5F, 0.02F);

  v.kind = SWAGE_VISUAL_DENT;
  EXPECT_FALSE(draw(v)) << "the surface's own";
}

}  // namespace
}  // namespace swage::console
