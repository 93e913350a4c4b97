// SPDX-License-Identifier: Apache-2.0
#include "console/view3d/mesh.hpp"

#include <gtest/gtest.h>
#include <swage/abi/builder.h>

#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

namespace swage::console {
namespace {

snapshot::CardShape shape(int kind) {
  snapshot::CardShape s;
  s.kind = kind;
  s.flags = SWAGE_SHAPE_USUAL;
  s.X_BS = {{1e-3, -2e-3, 0.5e-3}, {0.5, 0.5, 0.5, 0.5}};
  s.radius = 0.05e-3;
  s.half_length = 2e-3;
  s.arc_radius = 2.6e-3;
  s.sweep = 0.75 * std::numbers::pi;
  return s;
}

snapshot::CardShape box() {
  snapshot::CardShape s = shape(SWAGE_SHAPE_CONVEX);
  for (int i = 0; i < 8; ++i) s.vertex.push_back({(i & 1) * 1e-3, (i >> 1 & 1) * 2e-3, (i >> 2) * 3e-3});
  s.face = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  return s;
}

// volume by the divergence theorem, mm3: right only when closed and counter-clockwise from outside
double volume(const Mesh& m) {
  double sum = 0;
  for (size_t i = 0; i < m.index.size(); i += 3) {
    const float *a = m.vertex[m.index[i]].p, *b = m.vertex[m.index[i + 1]].p, *c = m.vertex[m.index[i + 2]].p;
    sum += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
            a[2] * (b[0] * c[1] - b[1] * c[0])) /
           6.0;
  }
  return sum;
}

// every edge belongs to two triangles, in opposite directions; vertices at the same place
// count as one
bool closed(const Mesh& m) {
  const auto key = [&](uint32_t i) {
    const float* p = m.vertex[i].p;
    return std::tuple(std::lround(p[0] * 1e4F), std::lround(p[1] * 1e4F), std::lround(p[2] * 1e4F));
  };
  std::map<std::pair<decltype(key(0)), decltype(key(0))>, int> edges;
  for (size_t i = 0; i < m.index.size(); i += 3) {
    for (int k = 0; k < 3; ++k) {
      const auto a = key(m.index[i + static_cast<size_t>(k)]),
                 b = key(m.index[i + static_cast<size_t>((k + 1) % 3)]);
      if (a == b) continue;  // at a pole
      ++edges[{a, b}];
      --edges[{b, a}];
    }
  }
  for (const auto& [edge, balance] : edges) {
    if (balance != 0) return false;
  }
  return !edges.empty();
}

TEST(Mesh, RoundShapesAreClosedAndHaveTheirVolume) {
  const double r = 0.05, h = 2.0, pi = std::numbers::pi;
  const double ball = 4.0 / 3 * pi * r * r * r, disc = pi * r * r;
  const std::map<int, double> expected = {{SWAGE_SHAPE_SPHERE, ball},
                                          {SWAGE_SHAPE_CAPSULE, disc * 2 * h + ball},
                                          {SWAGE_SHAPE_CYLINDER, disc * 2 * h},
                                          {SWAGE_SHAPE_ARC, disc * 2.6 * 0.75 * pi + ball}};
  for (const auto& [kind, v] : expected) {
    Mesh m;
    append_shape(shape(kind), m);
    EXPECT_TRUE(closed(m)) << kind;
    EXPECT_NEAR(volume(m), v, 0.03 * v) << kind;  // 28 facets round: 1 - sin(a)/a = 0.8 %, caps a little more
  }
}

TEST(Mesh, ConvexIsExact) {
  Mesh m;
  append_shape(box(), m);
  EXPECT_TRUE(closed(m));
  EXPECT_NEAR(volume(m), 6.0, 1e-4);
}

TEST(Mesh, AHoleIsFound) {
  Mesh m;
  append_shape(box(), m);
  m.index.resize(m.index.size() - 3);
  EXPECT_FALSE(closed(m));
}

TEST(Mesh, NormalsAreUnitAndPointOutward) {
  for (const int kind :
       {SWAGE_SHAPE_SPHERE, SWAGE_SHAPE_CAPSULE, SWAGE_SHAPE_CYLINDER, SWAGE_SHAPE_ARC, SWAGE_SHAPE_CONVEX}) {
    Mesh m;
    append_shape(kind == SWAGE_SHAPE_CONVEX ? box() : shape(kind), m);
    Mesh grown = m;
    for (Vertex& v : grown.vertex) {
      EXPECT_NEAR(v.n[0] * v.n[0] + v.n[1] * v.n[1] + v.n[2] * v.n[2], 1, 1e-5);
      for (int k = 0; k < 3; ++k) v.p[k] += 0.001F * v.n[k];
    }
    EXPECT_GT(volume(grown), volume(m)) << kind;
  }
}

TEST(Mesh, RegionLiesWhereTheArcSaysAndIsThicker) {
  const snapshot::CardShape arc = shape(SWAGE_SHAPE_ARC);
  Mesh all, part;
  append_shape(arc, all);
  append_range(arc, 0.5, 0.75, 1.1, part);
  const double length = 0.25 * 2.6 * 0.75 * std::numbers::pi;
  EXPECT_NEAR(
      volume(part),
      std::numbers::pi * std::pow(0.055, 2) * length + 4.0 / 3 * std::numbers::pi * std::pow(0.055, 3),
      0.03 * volume(part));
  EXPECT_LT(volume(part), 0.4 * volume(all));
}

TEST(Mesh, StraightWiresHaveRegionsToo) {
  const snapshot::CardShape wire = shape(SWAGE_SHAPE_CYLINDER);
  Mesh part;
  append_range(wire, 0.25, 0.5, 1.0, part);
  EXPECT_NEAR(volume(part), std::numbers::pi * 0.05 * 0.05 * 1.0, 0.01 * volume(part));
}

TEST(Mesh, ThreadIsATubeThroughItsPoints) {
  std::vector<double> p;
  for (int i = 0; i < 30; ++i) p.insert(p.end(), {i * 0.2e-3, 1e-3 * std::sin(0.3 * i), 0});
  Mesh m;
  append_thread(p.data(), 30, 15e-6, m);
  EXPECT_TRUE(closed(m));
  EXPECT_GT(volume(m), 0);
}

}  // namespace
}  // namespace swage::console
