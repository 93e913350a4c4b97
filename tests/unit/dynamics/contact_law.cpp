// SPDX-License-Identifier: Apache-2.0
#include "dynamics/contact_law.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "base/rng.hpp"

namespace swage::dynamics {
namespace contact_law_test {

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
TEST(ContactLaw, NoFrictionHasNoTangentialStiffness) {
  const Surface smooth{1e6, 0.82e6, 0};
  const Displacement u{-1e-6, 0, 0};
  const Tangent t = tangent(smooth, u, coulomb(smooth, u), 0, true);
  EXPECT_EQ(t.nn, 1e6);
  EXPECT_EQ(t.t11, 0);
}

// each piece equals Coulomb's law on its own range
TEST(ContactLaw, PiecesAreTheLaw) {
  for (const Displacement& u :
       {Displacement{1e-7, 1e-6, 0}, Displacement{-1e-6, 0.1e-6, 0.2e-6}, Displacement{-1e-6, 2e-6, -1e-6}}) {
    const Force whole = coulomb(kSteel, u), part = force_on(piece(kSteel, u), kSteel, u);
    EXPECT_DOUBLE_EQ(whole.fn, part.fn);
    EXPECT_DOUBLE_EQ(whole.f1, part.f1);
    EXPECT_DOUBLE_EQ(whole.f2, part.f2);
  }
}

// just before a kink the old piece is active, just behind it the new one
TEST(ContactLaw, KinksAreWhereThePieceEnds) {
  base::Xoshiro256 rng(5);
  int seen[3][3] = {};
  for (int i = 0; i < 3000; ++i) {
    const auto draw = [&] { return rng.uniform(-1e-6, 1e-6); };
    const Displacement u{draw(), draw(), draw()}, way{draw(), draw(), draw()};
    const auto at = [&](double t) {
      return Displacement{u.g + t * way.g, u.s1 + t * way.s1, u.s2 + t * way.s2};
    };
    const Piece from = piece(kSteel, u);
    const Kink k = kink(from, kSteel, u, way);
    const double end = std::isfinite(k.t) ? k.t : 1e3;
    for (const double relaxation : {0.1, 0.5, 0.999999})
      ASSERT_EQ(piece(kSteel, at(relaxation * end)), from) << i;
    if (!std::isfinite(k.t)) continue;
    EXPECT_EQ(piece(kSteel, at(k.t * 1.000001)), k.next) << i;
    ++seen[static_cast<int>(from)][static_cast<int>(k.next)];
  }
  EXPECT_GT(seen[0][2], 100);  // a new contact with a stretched bristle slips
  EXPECT_GT(seen[1][2], 20);
  EXPECT_GT(seen[2][1], 20);
  EXPECT_GT(seen[2][0], 100);
}

// the linear law about a force goes through it, and is the law nearby on the piece that it was on
TEST(ContactLaw, AForceOfBeforeTellsThePieceAndTheLawNearIt) {
  for (const Displacement& u : {Displacement{-1e-6, 0.1e-6, 0.2e-6}, Displacement{-1e-6, 2e-6, -1e-6}}) {
    const Force whole = coulomb(kSteel, u), then = force_before(kSteel, whole.fn, whole.f1, whole.f2);
    EXPECT_EQ(then.slips, whole.slips);
    // where its bristle hangs: nearer, if it slipped
    const Displacement kept{u.g, -then.f1 / kSteel.kt, -then.f2 / kSteel.kt};
    const LinearLaw there = law_before(kSteel, then, kept);
    EXPECT_NEAR(there.f.fn, then.fn, 1e-12);
    EXPECT_NEAR(there.f.f1, then.f1, 1e-12);
    const Displacement near{kept.g * 1.001, kept.s1 * 1.003, kept.s2 * 1.002};
    const Force f = law_before(kSteel, then, near).f, law = force_on(then.slips ? Piece::kSlip : Piece::kStick, kSteel, near);
    EXPECT_NEAR(f.fn, law.fn, 1e-5 * whole.fn);
    EXPECT_NEAR(f.f1, law.f1, 1e-5 * whole.fn);
    EXPECT_NEAR(f.f2, law.f2, 1e-5 * whole.fn);
  }
  EXPECT_FALSE(force_before(kSteel, 1, 0.99 * kSteel.mu, 0).slips);
}

// about the law's own force the projection is the law and its tangent, for any r
TEST(ContactLaw, TheProjectionHasTheSolutionsOfTheLaw) {
  for (const double r : {1.0, 1e3, kSteel.kt})
    for (const Displacement& u :
         {Displacement{1e-7, 1e-6, 0}, Displacement{-1e-6, 0.1e-6, 0.2e-6}, Displacement{-1e-6, 2e-6, -1e-6}}) {
      const Force law = coulomb(kSteel, u);
      const Tangent D = tangent(kSteel, u, law, kSteel.mu * law.fn, true);
      const LinearLaw here = law_projected(kSteel, law, u, r);
      EXPECT_NEAR(here.f.fn, law.fn, 1e-12);
      EXPECT_NEAR(here.f.f1, law.f1, 1e-9);
      EXPECT_NEAR(here.f.f2, law.f2, 1e-9);
      EXPECT_EQ(here.D.nn, D.nn);
      for (const auto& [a, b] : {std::pair{here.D.n1, D.n1}, {here.D.n2, D.n2}, {here.D.t11, D.t11}, {here.D.t12, D.t12}, {here.D.t22, D.t22}})
        EXPECT_NEAR(a, b, 1e-8 * kSteel.k) << r;
    }
}

// slipped to one side and now found on the other: the law slips there; the projection sticks, as long as r times the way is little
TEST(ContactLaw, TheProjectionSticksWhereWhatSlippedTurnedBack) {
  const Displacement u{-1e-6, -2e-6, 0};
  const Force slipped{1, -0.3, 0, true};
  EXPECT_TRUE(coulomb(kSteel, u).slips);
  EXPECT_FALSE(law_projected(kSteel, slipped, u, 1e3).f.slips);
  EXPECT_TRUE(law_projected(kSteel, slipped, u, 0.82e6).f.slips);
}

// nearest to the bristle's end on the way, and only where that is nearer by half
TEST(ContactLaw, WhatTurnsBackDoesSoNearestToItsBristle) {
  EXPECT_DOUBLE_EQ(turns_back({-1e-6, 2e-6, 0}, {0, -4e-6, 0.1e-6}), 8 / 16.01);
  EXPECT_EQ(turns_back({-1e-6, 2e-6, 0}, {0, 4e-6, 0}), HUGE_VAL) << "goes on";
  EXPECT_EQ(turns_back({-1e-6, 2e-6, 0}, {0, -1e-6, 4e-6}), HUGE_VAL) << "passes at a distance";
}

// a mass that lands with T = 2 sqrt(m / k) or more leaves with less than a fiftieth; with e = 1 nothing is taken
TEST(ContactLaw, WhatDoesNotReboundComesBackLate) {
  const double k = 1e6, h = 1e-5;
  const auto rebound = [&](double mass, double restitution) {
    const double T = retardation(restitution, 1e-3);
    double x = 0, v = -0.02;
    for (int i = 0; i < 100000 && (x < 0 || v < 0); ++i) {
      const Surface s = surface(k, 0, T, h);
      const double ref = relaxed_gap(T, h, x);
      // m (v1 - v) / h = -s.k (x + h v1 - ref), while that pushes
      double v1 = (mass * v - h * s.k * (x - ref)) / (mass + h * h * s.k);
      if (x + h * v1 - ref > 0) v1 = v;
      v = v1, x += h * v;
    }
    return v / 0.02;
  };
  EXPECT_LT(rebound(0.1, 0), 0.1);
  EXPECT_LT(rebound(5e-3, 0), 0.02);
  EXPECT_GT(rebound(0.1, 1), 0.9);
}

}  // namespace contact_law_test
}  // namespace swage::dynamics
