// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact_law.hpp"

#include <gtest/gtest.h>

namespace swage::dynamics {
namespace {

constexpr Surface kSteel{1e6, 0.82e6, 0.3};

TEST(ContactLaw, PushesOnlyWhenOverlapping) {
  EXPECT_EQ(coulomb(kSteel, {1e-9, 1e-6, 0}).fn, 0);
  EXPECT_EQ(coulomb(kSteel, {1e-9, 1e-6, 0}).f1, 0);
  EXPECT_DOUBLE_EQ(coulomb(kSteel, {-1e-6, 0, 0}).fn, 1.0);
}

TEST(ContactLaw, SticksElasticallyInsideTheCone) {
  const Force f = coulomb(kSteel, {-1e-6, 0.2e-6, -0.1e-6});
  EXPECT_FALSE(f.slips);
  EXPECT_DOUBLE_EQ(f.f1, -0.82e6 * 0.2e-6);
  EXPECT_DOUBLE_EQ(f.f2, 0.82e6 * 0.1e-6);
}

TEST(ContactLaw, ReturnsRadiallyToTheCone) {
  const Force f = coulomb(kSteel, {-1e-6, 3e-6, 4e-6});
  EXPECT_TRUE(f.slips);
  EXPECT_NEAR(f.f1, -0.3 * 0.6, 1e-15);
  EXPECT_NEAR(f.f2, -0.3 * 0.8, 1e-15);
}

// the tangent is the derivative of the force, in stick and slip, with growing and with held limits
TEST(ContactLaw, TangentIsTheDerivative) {
  for (const Displacement& u : {Displacement{-1e-6, 0.1e-6, 0.2e-6}, Displacement{-1e-6, 2e-6, -1e-6}}) {
    for (const bool grows : {true, false}) {
      const double limit = kSteel.mu * normal_force(kSteel, u.g);
      auto force = [&](const Displacement& at) {
        const double fn = normal_force(kSteel, at.g);
        return force_with_limit(kSteel, at, fn, grows ? kSteel.mu * fn : limit);
      };
      const Tangent t = tangent(kSteel, u, force(u), limit, grows);
      const double d = 1e-12;
      const Force g = force({u.g + d, u.s1, u.s2}), s1 = force({u.g, u.s1 + d, u.s2}),
                  s2 = force({u.g, u.s1, u.s2 + d});
      const Force at = force(u);
      const double near = 2.0;  // N/m, of 1e6: what the difference quotient is good for
      EXPECT_NEAR(t.nn, -(g.fn - at.fn) / d, near);
      EXPECT_NEAR(t.n1, -(g.f1 - at.f1) / d, near);
      EXPECT_NEAR(t.n2, -(g.f2 - at.f2) / d, near);
      EXPECT_NEAR(t.t11, -(s1.f1 - at.f1) / d, near);
      EXPECT_NEAR(t.t12, -(s1.f2 - at.f2) / d, near);
      EXPECT_NEAR(t.t12, -(s2.f1 - at.f1) / d, near);
      EXPECT_NEAR(t.t22, -(s2.f2 - at.f2) / d, near);
    }
  }
}

TEST(ContactLaw, NoFrictionHasNoTangentialStiffness) {
  const Surface smooth{1e6, 0.82e6, 0};
  const Displacement u{-1e-6, 0, 0};
  const Tangent t = tangent(smooth, u, coulomb(smooth, u), 0, true);
  EXPECT_EQ(t.nn, 1e6);
  EXPECT_EQ(t.t11, 0);
}

}  // namespace
}  // namespace swage::dynamics
