// SPDX-License-Identifier: Apache-2.0
#include "toolkit/rod_passage.hpp"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace swage::toolkit {
namespace {

TwoPieces between(const TwoPieces& a, const TwoPieces& b, double t) {
  return {a.u + t * (b.u - a.u), a.w + t * (b.w - a.w), a.d + t * (b.d - a.d)};
}

/// On which side one is of the other; whether they cross as seen along their common normal.
struct Look {
  double side = 0;
  bool cross = false;
};
Look look(const TwoPieces& p) {
  const Vec3 n = p.u.cross(p.w);
  const double s = p.d.cross(p.w).dot(n), r = p.d.cross(p.u).dot(n), all = n.squaredNorm();
  return {n.dot(p.d), s >= 0 && s < all && r >= 0 && r < all};
}

/// Against twenty thousand small parts of the way.
TEST(RodPassage, TellsWhatSmallPartsOfTheWayTell) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  const auto vector = [&] { return Vec3(any(random), any(random), any(random)); };
  int passed = 0, twice = 0, unclear = 0;
  for (int k = 0; k < 3000; ++k) {
    const TwoPieces a{2 * vector(), 2 * vector(), vector()}, b{2 * vector(), 2 * vector(), vector()};
    int changes = 0;
    bool edge = false;
    Look before = look(a);
    constexpr int kParts = 2000;
    for (int i = 1; i <= kParts; ++i) {
      const Look now = look(between(a, b, static_cast<double>(i) / kParts));
      if ((now.side >= 0) != (before.side >= 0)) {
        changes += now.cross && before.cross;
        edge = edge || now.cross != before.cross;  // it changes just where one leaves the other
      }
      before = now;
    }
    unclear += edge;
    if (edge) continue;
    EXPECT_EQ(pieces_pass(a, b), changes % 2 == 1) << k;
    passed += changes % 2, twice += changes == 2;
  }
  EXPECT_GT(passed, 300);
  EXPECT_GT(twice, 2);
  EXPECT_LT(unclear, 60);
}

/// A loop whose one leg goes through the other, goes beside it, or stays; and a thread that goes as a whole.
TEST(RodPassage, CountsThoseOfAChain) {
  constexpr int n = 41;
  std::vector<double> loop(3 * n), boxes(room_for_passages(n));
  // a trefoil's projection would do as well: a circle of 3/4 with two legs that cross, 20 um apart
  const auto at = [](double s) {
    constexpr double kLeg = 6, kRadius = 2, kArc = 1.5 * M_PI * kRadius;
    const double turn = (s - kLeg) / kRadius;
    if (s < kLeg) return Vec3(s - kLeg + kRadius, 0, 0);
    if (s < kLeg + kArc) return Vec3(kRadius + kRadius * std::sin(turn), kRadius - kRadius * std::cos(turn), 0.02 * (s - kLeg) / kArc);
    return Vec3(0, kRadius - (s - kLeg - kArc), 0.02);
  };
  for (int i = 0; i < n; ++i)
    for (int r = 0; r < 3; ++r) loop[3 * static_cast<size_t>(i) + static_cast<size_t>(r)] = at(0.52 * i)[r];
  const auto there = [](int) { return true; };
  const auto moved = [&](auto&& by) {
    std::vector<double> to = loop;
    for (int i = 0; i < n; ++i) {
      const Vec3 d = by(i);
      for (int r = 0; r < 3; ++r) to[3 * static_cast<size_t>(i) + static_cast<size_t>(r)] += d[r];
    }
    return to;
  };
  const auto count = [&](const std::vector<double>& to) { return passages(n, loop.data(), to.data(), there, boxes); };
  EXPECT_EQ(count(loop), 0);
  EXPECT_EQ(count(moved([](int) { return Vec3(0.3, -2, 1); })), 0) << "as a whole";
  const auto down = moved([](int i) { return Vec3(0, 0, i > 28 ? -0.3 : 0); });
  EXPECT_EQ(count(down), 1);
  EXPECT_EQ(count(moved([](int i) { return Vec3(0, 0, i > 28 ? 0.3 : 0); })), 0) << "up";
  EXPECT_EQ(passages(n, down.data(), loop.data(), there, boxes), 1) << "and back";
  EXPECT_EQ(passages(n, loop.data(), down.data(), [](int j) { return j != 30 && j != 29 && j != 31 && j != 32 && j != 33; }, boxes), 0)
      << "where it has parted";
  EXPECT_TRUE(may_have_passed(n, loop.data(), down.data(), 0.1));
  EXPECT_FALSE(may_have_passed(n, loop.data(), down.data(), 10)) << "less than a quarter of its radius";
}

/// An arc of 160 degrees may swing as it likes; one of 200 degrees turns back.
TEST(RodPassage, IsNotLookedForWhereAllPiecesPointOneWay) {
  constexpr int n = 41;
  const auto arc = [](double degrees, double swung) {
    std::vector<double> x;
    for (int i = 0; i < n; ++i) {
      const double turn = degrees / 180 * M_PI * (i / (n - 1.0) - 0.5);
      for (const double c : {std::sin(turn), -std::cos(turn) * std::cos(swung), -std::cos(turn) * std::sin(swung)}) x.push_back(c);
    }
    return x;
  };
  const auto looked_for = [&](double degrees) {
    return may_have_passed(n, arc(degrees, 0).data(), arc(degrees, 0.3).data(), 1e-3);
  };
  EXPECT_FALSE(looked_for(160));
  EXPECT_TRUE(looked_for(200));
}

}  // namespace
}  // namespace swage::toolkit
