// SPDX-License-Identifier: Apache-2.0
//
// S03: overlaps from 0.01 to 40 um on each face, edge and vertex of a jaw, square on and parallel to rounding; and contacts
// found again after small moves.
#include <gtest/gtest.h>

#include "base/rng.hpp"
#include "contact/narrow_phase.hpp"
#include "least.hpp"
#include "solids.hpp"
#include "trajectory.hpp"

namespace swage::contact {
namespace degenerate_test {

using bench::Needle;
using toolkit::Quat;

constexpr double kOverlaps[] = {0.01e-6, 0.1e-6, 1e-6, 5e-6, 20e-6, 40e-6};  // m

Solid wire(double half_length) {
  scene::Shape s;
  s.kind = half_length > 0 ? SWAGE_SHAPE_CAPSULE : SWAGE_SHAPE_SPHERE;
  s.X_BS = Pose().abi();
  s.radius = 50e-6, s.half_length = half_length;
  return make_solid(s, {});
}

/// Least gap of a wire whose middle is `overlap` too near to p along n, lying along `along`.
double gap_at(const Solid& jaw, double half_length, const Vec3& p, const Vec3& n, const Vec3& along,
              double overlap) {
  Manifold m;
  Separation none;
  const Solid a = wire(half_length);
  const Pose X(p + (a.radius - overlap) * n, Quat::FromTwoVectors(Vec3::UnitZ(), along));
  collide(a, Frame(X), jaw, Frame(), Query(), none, m);
  EXPECT_GT(m.count, 0);
  for (int i = 0; i < m.count; ++i) EXPECT_TRUE(m.candidate[static_cast<size_t>(i)].touch.n_W.allFinite());
  return least(m);
}

TEST(Degenerate, BallsOnEachFaceEdgeAndVertex) {
  const Solid jaw = bench::contact_solid(bench::jaw(1));
  const toolkit::Convex& c = jaw.convex;
  for (const double overlap : kOverlaps) {
    for (const auto& f : c.face) {
      Vec3 middle = Vec3::Zero();
      for (const uint32_t v : f.vertex) middle += c.vertex[v] / static_cast<double>(f.vertex.size());
      EXPECT_NEAR(gap_at(jaw, 0, middle, f.n, f.n, overlap), -overlap, 1e-12);
    }
    for (const auto& e : c.edge) {
      const Vec3 n = (c.face[e.face_left].n + c.face[e.face_right].n).normalized();
      EXPECT_NEAR(gap_at(jaw, 0, 0.5 * (c.vertex[e.v0] + c.vertex[e.v1]), n, n, overlap), -overlap, 1e-12);
    }
    for (uint32_t v = 0; v < c.vertex.size(); ++v) {
      const Vec3 n = (c.vertex[v] - jaw.centre).normalized();
      EXPECT_NEAR(gap_at(jaw, 0, c.vertex[v], n, n, overlap), -overlap, 1e-12);
    }
  }
}

TEST(Degenerate, WiresAlongAndAcrossEachEdge) {
  const Solid jaw = bench::contact_solid(bench::jaw(1));
  const toolkit::Convex& c = jaw.convex;
  for (const auto& e : c.edge) {
    const Vec3 n = (c.face[e.face_left].n + c.face[e.face_right].n).normalized();
    const Vec3 middle = 0.5 * (c.vertex[e.v0] + c.vertex[e.v1]);
    double last = 1;
    for (const double overlap : kOverlaps) {
      // parallel to rounding, and turned by less than any tolerance
      EXPECT_NEAR(gap_at(jaw, 0.05e-3, middle, n, e.u, overlap), -overlap, 1e-12);
      EXPECT_NEAR(gap_at(jaw, 0.05e-3, middle, n, (e.u + 1e-12 * n).normalized(), overlap), -overlap, 1e-11);
      const double across = gap_at(jaw, 0.05e-3, middle, n, e.u.cross(n), overlap);
      EXPECT_NEAR(across, -overlap, 1e-12);
      EXPECT_LT(across, last) << "depth grows with the overlap";
      last = across;
    }
  }
}

TEST(Degenerate, WiresLaidOnAFaceAlongItsEdge) {
  // exactly over the edge of the gripping face: neither lost nor counted twice as deep
  const Solid jaw = bench::contact_solid(bench::jaw(1));
  const toolkit::Convex& c = jaw.convex;
  for (const auto& e : c.edge) {
    const Vec3 n = c.face[e.face_left].n, middle = 0.5 * (c.vertex[e.v0] + c.vertex[e.v1]);
    for (const double overlap : kOverlaps)
      EXPECT_NEAR(gap_at(jaw, 0.04e-3, middle, n, e.u, overlap), -overlap, 1e-12);
  }
}

TEST(Degenerate, AContactFoundAgainAfterASmallMoveIsTheContactOfAFreshLook) {
  const Needle n;
  const bench::Jaw upper = bench::jaw(1), lower = bench::jaw(-1);
  const Solid a = bench::contact_solid(n),
              jaw[2] = {bench::contact_solid(upper), bench::contact_solid(lower)};
  base::Xoshiro256 random(8);
  const auto draw = [&](double size) {
    return Vec3(random.uniform(-size, size), random.uniform(-size, size), random.uniform(-size, size));
  };
  Query query;
  query.margin = 10e-6, query.flatness = 0;  // minima only: points of a line are fixed to the wire
  int compared = 0;
  double worst = 0, unmoved = 0;
  for (const auto& pose : bench::trajectory(n, upper, lower, 1000)) {
    const Pose moved(pose.X_WN.p + draw(1e-6), toolkit::exp_rotation(draw(2e-4)) * pose.X_WN.q);
    for (size_t k = 0; k < 2; ++k) {
      Manifold before, after;
      Separation none;
      const Frame X_WJ(pose.X_WJ[k]);
      collide(a, Frame(pose.X_WN), jaw[k], X_WJ, query, none, before);
      collide(a, Frame(moved), jaw[k], X_WJ, query, none, after);
      for (int i = 0; i < before.count; ++i)
        for (int j = 0; j < after.count; ++j) {
          const Candidate& c = before.candidate[static_cast<size_t>(i)];
          const Candidate& fresh = after.candidate[static_cast<size_t>(j)];
          if (c.feature != fresh.feature) continue;
          const Touch again = reevaluate(c, Frame(moved), X_WJ);
          worst = std::max(worst, std::abs(again.gap - fresh.touch.gap));
          unmoved = std::max(unmoved, std::abs(c.touch.gap - fresh.touch.gap));
          ++compared;
        }
    }
  }
  EXPECT_GT(compared, 500);
  EXPECT_LT(worst, 1e-11);
  EXPECT_GT(unmoved, 1e-7) << "nothing moved: the comparison would see nothing";
}

/// A wire of 0.5 mm over the middle of a jaw's gripping face, its lower end overlapping by 1 um, its other higher by `rise`.
Manifold tilted(double rise, double flatness) {
  const Solid jaw = bench::contact_solid(bench::jaw(-1)), a = wire(0.2e-3);
  const double angle = std::asin(rise / 0.4e-3);
  const Quat q = toolkit::exp_rotation({0, M_PI / 2 - angle, 0});
  Manifold m;
  Separation none;
  Query query;
  query.margin = 20e-6, query.flatness = flatness;
  collide(a, Frame(Pose(Vec3(7e-3, 0, a.radius - 1e-6 + 0.5 * rise), q)), jaw, Frame(), query, none, m);
  return m;
}

// S29: the higher end may come down within the step, so it is a contact while it is within reach
TEST(Degenerate, ATiltedStraightWireTouchesAtBothEndsWithinReach) {
  const Manifold both = tilted(18e-6, 0.2e-3);  // steep for what counts as flat there
  ASSERT_EQ(both.count, 2);
  double low = 1, high = -1;
  for (int i = 0; i < both.count; ++i) {
    const Candidate& c = both.candidate[static_cast<size_t>(i)];
    EXPECT_EQ(c.a.kind, Feature::kPoint);
    EXPECT_NEAR(c.weight, 1, 1e-12);
    low = std::min(low, c.touch.gap), high = std::max(high, c.touch.gap);
  }
  EXPECT_NEAR(low, -1e-6, 1e-12);
  EXPECT_NEAR(high, 17e-6, 1e-12);
  // out of reach, or asked for points alone: the lower end, wherever that will be
  for (const Manifold& one : {tilted(40e-6, 0.2e-3), tilted(18e-6, 0)}) {
    ASSERT_EQ(one.count, 1);
    EXPECT_EQ(one.candidate[0].a.kind, Feature::kSegment);
    EXPECT_NEAR(one.candidate[0].touch.gap, -1e-6, 1e-12);
  }
}

}  // namespace degenerate_test
}  // namespace swage::contact
