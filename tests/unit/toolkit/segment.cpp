// SPDX-License-Identifier: Apache-2.0
#include "toolkit/segment.hpp"

#include <gtest/gtest.h>

#include "base/rng.hpp"

namespace swage::toolkit {
namespace {

Vec3 draw(base::Xoshiro256& random) {
  return {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
}

TEST(Segment, ClosestPointIsTheFootOrAnEnd) {
  const Segment s{{0, 0, 0}, {2, 0, 0}};
  EXPECT_DOUBLE_EQ(closest(s, {0.5, 3, 0}), 0.25);
  EXPECT_DOUBLE_EQ(closest(s, {-1, 1, 1}), 0);
  EXPECT_DOUBLE_EQ(closest(s, {7, 1, 1}), 1);
  // of no length: its start
  EXPECT_EQ(closest(Segment{{1, 1, 1}, {1, 1, 1}}, {5, 5, 5}), 0);
}

/// The least distance, over all 9 ways in which the pair may be inside or at an end.
double reference(const Segment& p, const Segment& q) {
  double d = 1e300;
  for (const double t : {0.0, 1.0}) {
    d = std::min(d, (p.point(t) - q.point(closest(q, p.point(t)))).norm());
    d = std::min(d, (q.point(t) - p.point(closest(p, q.point(t)))).norm());
  }
  const Vec3 u = p.b - p.a, v = q.b - q.a, n = u.cross(v), w = q.a - p.a;
  if (n.squaredNorm() > 0) {
    const double s = w.cross(v).dot(n) / n.squaredNorm(), t = w.cross(u).dot(n) / n.squaredNorm();
    if (s >= 0 && s <= 1 && t >= 0 && t <= 1) d = std::min(d, (p.point(s) - q.point(t)).norm());
  }
  return d;
}

TEST(Segment, ClosestPairsAgreeWithAllCases) {
  base::Xoshiro256 random(3);
  for (int k = 0; k < 20000; ++k) {
    Segment p{draw(random), draw(random)}, q{draw(random), draw(random)};
    // every third pair nearly or exactly parallel
    if (k % 3 == 0) q.b = q.a + random.uniform(-2, 2) * (p.b - p.a) + (k % 2) * 1e-9 * draw(random);
    const SegmentPair at = closest(p, q);
    ASSERT_TRUE(at.s >= 0 && at.s <= 1 && at.t >= 0 && at.t <= 1);
    ASSERT_NEAR((p.point(at.s) - q.point(at.t)).norm(), reference(p, q), 1e-8) << k;
  }
}

TEST(Segment, SaysWhenTheyAreParallel) {
  const Segment p{{0, 0, 0}, {1, 0, 0}};
  EXPECT_TRUE(closest(p, Segment{{0, 1, 0}, {5, 1, 0}}).parallel);
  EXPECT_FALSE(closest(p, Segment{{0, 1, 0}, {5, 1, 1e-6}}).parallel);
}

}  // namespace
}  // namespace swage::toolkit
