// SPDX-License-Identifier: Apache-2.0
//
// A ball on a face: three points on the ring of Hertz's moment, in one plane with the gap of the middle.
#include "contact/cap.hpp"

#include <gtest/gtest.h>

#include "solids.hpp"
#include "toolkit/convex.hpp"

namespace swage::contact {
namespace cap_test {

Solid ball(double radius) { return make_ball(radius); }

Solid block() {
  scene::Shape shape;
  shape.kind = SWAGE_SHAPE_CONVEX;
  shape.convex = 0;
  shape.X_BS = Pose().abi();
  return make_solid(shape, {bench::convex(bench::jaw(1))});
}

/// The moment about the normal of a pressure 3 N / (2 pi a^2) sqrt(1 - r^2 / a^2) that slips everywhere, over mu N.
double hertz_arm(double a) {
  double moment = 0;
  const int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double r = (i + 0.5) * a / n, p = 1.5 / (std::numbers::pi * a * a) * std::sqrt(1 - r * r / (a * a));
    moment += p * r * 2 * std::numbers::pi * r * a / n;
  }
  return moment;
}

TEST(Cap, RingHasTheMomentOfHertzsPressure) {
  const double radius = 0.4e-3, depth = 0.3e-6;
  EXPECT_NEAR(cap_ring(radius, depth), hertz_arm(std::sqrt(radius * depth)),
              1e-5 * std::sqrt(radius * depth));
  EXPECT_EQ(cap_ring(radius, 0), 0);
  EXPECT_EQ(cap_ring(radius, -1e-6), 0);
}

struct OnBlock {
  /// The ball over the gripping face, `gap` above it, both turned anyhow.
  explicit OnBlock(double gap, double flatness = 2e-3) : a(ball(radius)), b(block()) {
    const Pose block_W(Vec3(1e-3, 2e-3, 3e-3), toolkit::exp_rotation({0.3, -0.8, 1.1}));
    // the face of a left jaw looks to -z of its frame; its middle is two thirds of the way from hinge to tip
    Vec3 middle = Vec3::Zero();
    for (const uint32_t v : b.convex.face[0].vertex) middle += b.convex.vertex[v];
    middle /= static_cast<double>(b.convex.face[0].vertex.size());
    normal_W = block_W.q * b.convex.face[0].n;
    const Pose ball_W(block_W * middle + (radius + gap) * normal_W, toolkit::exp_rotation({-0.5, 0.2, 0.9}));
    Query query;
    query.margin = 20e-6;
    query.flatness = flatness;
    Separation memory;
    X_WA = Frame(ball_W), X_WB = Frame(block_W);
    collide(a, X_WA, b, X_WB, query, memory, out);
    centre_W = ball_W.p;
  }
  double radius = 0.4e-3;
  Solid a, b;
  Frame X_WA, X_WB;
  Manifold out;
  Vec3 centre_W, normal_W;
};

TEST(Cap, ABallOnAFaceTouchesInThreePointsOfOneThird) {
  const double depth = 0.3e-6;
  const OnBlock on(-depth);
  ASSERT_EQ(on.out.count, 3);
  Vec3 middle = Vec3::Zero();
  for (size_t i = 0; i < 3; ++i) {
    const Candidate& c = on.out.candidate[i];
    EXPECT_DOUBLE_EQ(c.weight, 1.0 / 3);
    EXPECT_NEAR(c.touch.gap, -depth, 1e-15);
    EXPECT_LT((c.touch.n_W - on.normal_W).norm(), 1e-12);
    // on the ring, and where a fresh look at the same poses finds it
    const Vec3 arm = c.touch.p_W - on.centre_W;
    EXPECT_NEAR((arm - arm.dot(on.normal_W) * on.normal_W).norm(), cap_ring(on.radius, depth), 1e-12);
    const Touch again = reevaluate(c, on.X_WA, on.X_WB);
    EXPECT_LT((again.p_W - c.touch.p_W).norm(), 1e-15);
    EXPECT_NEAR(again.gap, c.touch.gap, 1e-15);
    EXPECT_NE(c.feature, on.out.candidate[(i + 1) % 3].feature);
    middle += c.touch.p_W / 3;
  }
  EXPECT_LT((middle - (on.centre_W - (on.radius - 0.5 * depth) * on.normal_W)).norm(), 1e-12);
}

TEST(Cap, NotYetTouchingItIsOnePointThreeTimes) {
  const OnBlock on(5e-6);
  ASSERT_EQ(on.out.count, 3);
  for (size_t i = 1; i < 3; ++i)
    EXPECT_LT((on.out.candidate[i].touch.p_W - on.out.candidate[0].touch.p_W).norm(), 1e-15);
}

TEST(Cap, WithoutFlatnessEveryContactIsAPoint) { EXPECT_EQ(OnBlock(-0.3e-6, 0).out.count, 1); }

}  // namespace cap_test
}  // namespace swage::contact
