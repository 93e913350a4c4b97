// SPDX-License-Identifier: Apache-2.0
//
// The parts of swage.coupling.pierce by themselves: reaction laws, wounds.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <vector>

#include "plugins/coupling_pierce/circle.hpp"
#include "plugins/coupling_pierce/reaction.hpp"
#include "plugins/coupling_pierce/wound.hpp"

namespace swage::coupling_pierce {
namespace {

constexpr double kDeg = M_PI / 180, kR = 50e-6;

TEST(Reaction, LawsOfTheThesisAndItsAlternatives) {
  Reaction r{Law::kNullZone, 15 * kDeg, 60e-3, {0, 15 * kDeg, 45 * kDeg, 90 * kDeg}, {0, 0, 24e-3, 60e-3}};
  EXPECT_EQ(r(0), 0);
  EXPECT_EQ(r(15 * kDeg), 0);
  EXPECT_NEAR(r(52.5 * kDeg), 30e-3, 1e-12);
  EXPECT_NEAR(r(90 * kDeg), 60e-3, 1e-12);
  r.law = Law::kThreshold;
  EXPECT_EQ(r(14.9 * kDeg), 0);
  EXPECT_EQ(r(15.1 * kDeg), 60e-3);
  r.law = Law::kQuadratic;
  EXPECT_NEAR(r(52.5 * kDeg), 15e-3, 1e-12);
  r.law = Law::kTable;
  EXPECT_NEAR(r(30 * kDeg), 12e-3, 1e-12);
  EXPECT_NEAR(r(67.5 * kDeg), 42e-3, 1e-12);
  EXPECT_EQ(r(1.6), 60e-3);
}

struct Wounds : testing::Test {
  Outline settled;
};

Wound fresh(Outline& settled) {
  Wound w;
  open_wound(w, settled, Vec3::Zero(), Vec3::UnitZ(), Vec3::UnitX(), kR);
  return w;
}

TEST_F(Wounds, APerfectPassIsOneSection) {
  Wound w = fresh(settled);
  for (int i = 0; i < 1000; ++i) sweep(w, settled, Vec3(0.01 * kR * std::sin(i), 0, 0), 1, Vec3::Zero());
  EXPECT_NEAR(w.area, M_PI * kR * kR, 1e-12 * w.area);
  EXPECT_EQ(w.reach, kR);
  EXPECT_EQ(w.count, 1);
}

// a tear of 7 radii to one side: 8 radii from the first puncture, 4.5 from its own centre (thesis D4)
TEST_F(Wounds, FromItsOwnCentreATearIsHalfAsWide) {
  Wound w = fresh(settled);
  EXPECT_EQ(w.wide, kR);
  for (int i = 0; i <= 500; ++i) sweep(w, settled, Vec3(0, 7 * kR * i / 500, 0), 1, Vec3::Zero());
  EXPECT_NEAR(w.reach, 8 * kR, 0.03 * kR);
  EXPECT_NEAR(w.wide, 4.5 * kR, 0.03 * kR);
}

// by brute force: of all circles through two or three of the points, the smallest that leaves none out
TEST(SmallestCircle, IsTheSmallestOfAll) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Vec2> p(2 + static_cast<size_t>(trial) % 7);
    for (Vec2& q : p) q = Vec2(any(random), trial % 5 == 0 ? 0 : any(random));
    double least = HUGE_VAL;
    const auto look = [&](const Circle& circle) {
      for (const Vec2& q : p)
        if ((q - circle.centre).norm() > circle.radius * (1 + 1e-9)) return;
      least = std::min(least, circle.radius);
    };
    for (const Vec2& a : p)
      for (const Vec2& b : p) {
        look(circle_through(a, b));
        for (const Vec2& c : p) look(circle_through(a, b, c));
      }
    const Circle found = smallest_circle(p.data(), static_cast<uint32_t>(p.size()));
    EXPECT_NEAR(found.radius, least, 1e-9);
    for (const Vec2& q : p) EXPECT_LE((q - found.centre).norm(), found.radius * (1 + 1e-8));
  }
}

TEST_F(Wounds, AStraightTearIsACapsule) {
  Wound w = fresh(settled);
  const double length = 7 * kR;
  for (int i = 0; i <= 500; ++i) sweep(w, settled, Vec3(0, length * i / 500, 0), 1, Vec3::Zero());
  EXPECT_NEAR(w.area, M_PI * kR * kR + 2 * kR * length, 0.006 * w.area);
  EXPECT_NEAR(w.reach, length + kR, 1e-3 * length);
  EXPECT_LE(w.count, 2);
  // the same way back tears nothing
  const double before = w.area;
  for (int i = 500; i >= 0; --i) sweep(w, settled, Vec3(0, length * i / 500, 0), 1, Vec3::Zero());
  EXPECT_NEAR(w.area, before, 1e-3 * before);
}

TEST_F(Wounds, ALeaningWireTearsAnEllipseOfItsSection) {
  Wound w = fresh(settled);
  const double theta = 40 * kDeg;
  sweep(w, settled, Vec3::Zero(), std::cos(theta), Vec3(std::sin(theta), 0, std::cos(theta)));
  // its capsule contains the ellipse of semi-axis r / cos and is no longer
  EXPECT_NEAR(w.reach, kR / std::cos(theta), 1e-9 * kR);
  EXPECT_GT(w.area, M_PI * kR * kR / std::cos(theta));
  EXPECT_LT(w.area, 1.1 * M_PI * kR * kR / std::cos(theta));
}

/// Area of a region by counting points of a fine grid.
double counted(const std::function<bool(const Vec2&)>& has, double far, double step = kR / 25) {
  long inside = 0;
  for (double x = -far; x < far; x += step)
    for (double y = -far; y < far; y += step) inside += has({x, y});
  return static_cast<double>(inside) * step * step;
}
double counted(const Wound& w) {
  const auto has = [&](const Vec2& p) {
    return std::any_of(w.capsule, w.capsule + static_cast<uint32_t>(w.count),
                       [&](const Capsule& c) { return Line(c).distance2(p) <= kR * kR; });
  };
  return counted(has, w.reach + kR);
}

TEST_F(Wounds, AreaOfAnyWalkIsThatOfTheUnion) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int walk = 0; walk < 6; ++walk) {
    Wound w = fresh(settled);
    Vec3 p = Vec3::Zero();
    double last = 0;
    for (int turn = 0; turn < 6; ++turn) {
      const Vec3 v(any(random), any(random), 0);
      for (int i = 0; i < 40; ++i) {
        p += 0.08 * kR * v;
        sweep(w, settled, p, 1, Vec3::Zero());
        EXPECT_GE(w.area, last) << "a wound never heals";
        last = w.area;
      }
    }
    EXPECT_NEAR(w.area, counted(w), 0.012 * w.area) << walk;
    EXPECT_NEAR(w.area, union_area(w.capsule, static_cast<uint32_t>(w.count), kR), 0.012 * w.area)
        << walk;  // corners that longer capsules cut
  }
}

// The sum over capsules of what each adds is the area of the union (nothing but rounding between two ways to reckon it), and an
// outline made in one go has the bits of one that grew.
TEST_F(Wounds, WhatEachCapsuleAddsSumsToTheUnion) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> any(-2, 2);
  for (int trial = 0; trial < 40; ++trial) {
    Capsule all[Outline::kMost];
    double sum = 0;
    for (uint32_t n = 0; n < Outline::kMost; ++n) {
      const Capsule before = n > 0 ? all[n - 1] : Capsule{};
      // apart, chained, doubled, or one on from the same place
      const bool chained = trial % 4 > 0 && n > 0;
      all[n] = {{chained ? before.b[0] : kR * any(random), chained ? before.b[1] : kR * any(random)},
                {kR * any(random), kR * any(random)}};
      if (trial % 4 == 2 && n % 3 == 2) all[n] = before;
      if (trial % 4 == 3) std::copy_n(all[0].a, 2, all[n].a);
      settled.follow(all, n, kR);
      Outline anew;
      anew.follow(all, n, kR);
      const double more = settled.added(all[n], kR);
      ASSERT_EQ(more, anew.added(all[n], kR));
      ASSERT_NEAR(sum, settled.area(), 1e-9 * sum);
      sum += more;
      ASSERT_NEAR(sum, union_area(all, n + 1, kR), 1e-9 * sum) << trial << " " << n;
    }
  }
}

// A tremor of some tenths of the radius while the hand drifts by five of them: hundreds of turns, and room for sixteen. Against the
// way itself, every section of it counted.
TEST_F(Wounds, OfManyTurnsWhatIsTornStaysTorn) {
  Wound w = fresh(settled);
  std::mt19937 random(9);
  std::uniform_real_distribution<double> any(-1, 1);
  std::vector<Vec2> way;
  Vec2 shaken = Vec2::Zero();
  double drawn = 0;
  for (int i = 0; i < 4000; ++i) {
    shaken = 0.97 * shaken + 0.1 * Vec2(any(random), any(random));
    way.push_back(kR * (shaken + Vec2(1.25e-3 * i, 0)));
    sweep(w, settled, {way.back().x(), way.back().y(), 0}, 1, Vec3::Zero());
    if (i % 400 != 399) continue;
    const double now = counted(w);
    EXPECT_GT(now, 0.99 * drawn) << i << ": what is drawn does not heal";
    EXPECT_NEAR(w.area, now, 0.03 * now) << i;
    drawn = now;
  }
  const auto swept = [&](const Vec2& p) {
    return std::any_of(way.begin(), way.end(),
                       [&](const Vec2& c) { return (p - c).squaredNorm() < kR * kR; });
  };
  const double exact = counted(swept, w.reach + kR, kR / 12);
  EXPECT_NEAR(w.area, exact, 0.03 * exact);
}

TEST_F(Wounds, WhenFullItStillGrowsAndNeverShrinks) {
  Wound w = fresh(settled);
  Vec3 p = Vec3::Zero();
  double last = 0;
  for (int i = 0; i < 1500; ++i) {
    p = 0.01 * kR * i * Vec3(std::cos(0.02 * i), std::sin(0.02 * i), 0);
    sweep(w, settled, p, 1, Vec3::Zero());
    ASSERT_GE(w.area, last);
    last = w.area;
  }
  EXPECT_EQ(w.count, Wound::kCapsules);
  EXPECT_NEAR(w.reach, p.norm() + kR, 0.03 * w.reach);
}

}  // namespace
}  // namespace swage::coupling_pierce
