// SPDX-License-Identifier: Apache-2.0
#include "toolkit/arc.hpp"

#include <gtest/gtest.h>

#include "base/rng.hpp"

namespace swage::toolkit {
namespace {

/// An arc anyhow in space, and points about it.
struct Anyhow {
  base::Xoshiro256 random{17};
  double draw(double size) { return random.uniform(-size, size); }
  Vec3 vec(double size) { return {draw(size), draw(size), draw(size)}; }
  Arc arc() {
    return Arc(Pose(vec(1), exp_rotation(vec(2))), random.uniform(0.5, 2), random.uniform(0.3, 6));
  }
};

/// Least of f over the arc, by samples and golden section.
template <class F>
double least(const Arc& arc, const F& f) {
  constexpr int n = 720;
  double best = 1e300, at = 0;
  for (int i = 0; i <= n; ++i)
    if (const double d = f(arc.at(i / double{n})); d < best) best = d, at = i / double{n};
  double a = std::max(0.0, at - 1.0 / n), b = std::min(1.0, at + 1.0 / n);
  for (int k = 0; k < 60; ++k) {
    const double c = b - 0.6180339887498949 * (b - a), e = a + 0.6180339887498949 * (b - a);
    (f(arc.at(c)) < f(arc.at(e)) ? b : a) = f(arc.at(c)) < f(arc.at(e)) ? e : c;
  }
  return std::min(best, f(arc.at(0.5 * (a + b))));
}

TEST(Turn, OrderGrowsWithTheAngle) {
  double last = -1;
  for (int i = 0; i < 360; ++i) {
    const double angle = i * M_PI / 180;
    const Turn e{std::cos(angle), std::sin(angle)};
    EXPECT_GT(e.order(), last) << i;
    EXPECT_NEAR(e.angle(), angle, 1e-14);
    last = e.order();
  }
  EXPECT_EQ((Turn{1, 0}).order(), 0);
  EXPECT_EQ((Turn{0, 1}).order(), 1);
  EXPECT_EQ((Turn{-1, 0}).order(), 2);
  EXPECT_EQ((Turn{0, -1}).order(), 3);
}

TEST(Turn, StepsTurnByTheirArctangentAndKeepTheirLength) {
  Turn e{std::cos(1.0), std::sin(1.0)};
  for (const double step : {1e-9, 1e-4, 3.1e-3, 3.2e-3, 0.1, -0.5, 3.0}) {
    const Turn next = e.stepped(step);
    EXPECT_NEAR(next.c * next.c + next.s * next.s, 1, 4e-16);
    EXPECT_NEAR(std::atan2(next.s * e.c - next.c * e.s, next.c * e.c + next.s * e.s), std::atan(step), 1e-15)
        << step;
  }
  // nothing has no direction
  const Turn kept = Turn::along(0, 0, e);
  EXPECT_EQ(kept.c, e.c);
}

TEST(Arc, PointsTangentsAndCoordinatesBelongTogether) {
  Anyhow any;
  for (int k = 0; k < 50; ++k) {
    const Arc arc = any.arc();
    EXPECT_NEAR(arc.length(), arc.radius * arc.sweep, 1e-15);
    for (const double s : {0.0, 0.2, 0.7, 1.0}) {
      const Turn e = arc.at(s);
      EXPECT_NEAR((arc.point(e) - arc.centre).norm(), arc.radius, 1e-14);
      EXPECT_NEAR(arc.tangent(e).dot(arc.point(e) - arc.centre), 0, 1e-14);
      EXPECT_NEAR(arc.coordinate(e), s, 1e-13);
      const double h = 1e-6;
      const Vec3 difference = (arc.point(arc.at(s + h)) - arc.point(arc.at(s - h))) / (2 * h * arc.length());
      EXPECT_LT((arc.tangent(e) - difference).norm(), 1e-8);
    }
    EXPECT_TRUE(arc.contains(arc.at(0.5)));
    const double beyond = 0.5 * (arc.sweep + 2 * M_PI);
    EXPECT_FALSE(arc.contains({std::cos(beyond), std::sin(beyond)}));
  }
}

TEST(Arc, ClosestAndLowestAgreeWithASearch) {
  Anyhow any;
  for (int k = 0; k < 200; ++k) {
    const Arc arc = any.arc();
    const Vec3 p = any.vec(3), n = any.vec(1).normalized();
    const auto to_p = [&](Turn e) { return (arc.point(e) - p).norm(); };
    const auto height = [&](Turn e) { return n.dot(arc.point(e)); };
    EXPECT_NEAR(to_p(closest(arc, p)), least(arc, to_p), 1e-12);
    EXPECT_NEAR(height(lowest(arc, n)), least(arc, height), 1e-12);
  }
}

TEST(Arc, SlopeAndCurvatureOfTheDistanceToALineAreItsDerivatives) {
  Anyhow any;
  for (int k = 0; k < 100; ++k) {
    const Arc arc = any.arc();
    const Vec3 q = any.vec(2), u = any.vec(1).normalized();
    const ArcLine g(arc, q, u);
    const auto half_square = [&](double angle) {
      const Vec3 w = arc.point({std::cos(angle), std::sin(angle)}) - q;
      return (w.squaredNorm() - w.dot(u) * w.dot(u)) / (2 * arc.radius);
    };
    const double angle = any.draw(3), h = 1e-4;
    const Turn e{std::cos(angle), std::sin(angle)};
    EXPECT_NEAR(g.slope(e), (half_square(angle + h) - half_square(angle - h)) / (2 * h), 1e-6);
    EXPECT_NEAR(g.curvature(e),
                (half_square(angle + h) - 2 * half_square(angle) + half_square(angle - h)) / (h * h), 1e-5);
    EXPECT_NEAR(g.along(e), (arc.point(e) - q).dot(u), 1e-13);
  }
}

TEST(Arc, MinimumBetweenIsWhereTheSlopeVanishes) {
  Anyhow any;
  int found = 0;
  for (int k = 0; k < 500; ++k) {
    const Arc arc = any.arc();
    const ArcLine g(arc, any.vec(2), any.vec(1).normalized());
    const double a = any.draw(3), b = a + any.random.uniform(0.1, 1.2);
    const Turn lo{std::cos(a), std::sin(a)}, hi{std::cos(b), std::sin(b)};
    if (!(g.slope(lo) < 0 && g.slope(hi) > 0)) continue;
    ++found;
    const Turn e = minimum_between(g, lo, hi, Turn::along(lo.c + hi.c, lo.s + hi.s, lo));
    EXPECT_NEAR(g.slope(e), 0, 1e-12);
    EXPECT_GE(lo.c * e.s - lo.s * e.c, 0);
    EXPECT_GE(e.c * hi.s - e.s * hi.c, 0);
    const Turn near = minimum_near(g, e.stepped(0.01));
    EXPECT_TRUE(g.curvature(e) < 0.1 || std::abs(g.slope(near)) < 1e-8);
  }
  EXPECT_GT(found, 30);
}

TEST(Arc, TwoCirclesMeetWhereBothSlopesVanish) {
  Anyhow any;
  int crossed = 0;
  for (int k = 0; k < 300; ++k) {
    const Arc p = any.arc(), q = any.arc();
    // from the nearest of a few places
    ArcPair guess;
    double least_d = 1e300;
    for (int i = 0; i < 24; ++i)
      for (int j = 0; j < 24; ++j) {
        const double a = i * M_PI / 12, b = j * M_PI / 12;
        const ArcPair e{{std::cos(a), std::sin(a)}, {std::cos(b), std::sin(b)}};
        const double d = (p.point(e.a) - q.point(e.b)).norm();
        if (d < least_d) least_d = d, guess = e;
      }
    const ArcPair at = minimum_near(p, q, guess);
    const Vec3 w = p.point(at.a) - q.point(at.b);
    EXPECT_NEAR(p.tangent(at.a).dot(w), 0, 1e-8);
    EXPECT_NEAR(q.tangent(at.b).dot(w), 0, 1e-8);
    // no neighbour is nearer
    for (const double s : {-1e-3, 0.0, 1e-3})
      for (const double t : {-1e-3, 0.0, 1e-3}) {
        const Vec3 other = p.point(at.a.stepped(s)) - q.point(at.b.stepped(t));
        crossed += other.norm() < w.norm() - 1e-9;
      }
  }
  EXPECT_EQ(crossed, 0);
}

}  // namespace
}  // namespace swage::toolkit
