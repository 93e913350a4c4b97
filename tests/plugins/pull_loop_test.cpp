// SPDX-License-Identifier: Apache-2.0
//
// The loop of a knot about a pin (lessons/pull/loop.hpp): a thread that goes round a pin and crosses itself, whose loop is known.
#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "lessons/pull/loop.hpp"

namespace swage::lesson_pull {
namespace {

constexpr double kApart = 0.2e-3, kRadius = 0.25e-3, kDiameter = 45e-6;  // m

/// A curve of straight pieces, by arc length [m].
class Curve {
 public:
  explicit Curve(std::vector<Vec3> corner) : corner_(std::move(corner)) {
    for (size_t i = 0; i + 1 < corner_.size(); ++i) length_ += (corner_[i + 1] - corner_[i]).norm();
  }
  double length() const { return length_; }
  Vec3 at(double s) const {
    for (size_t i = 0; i + 1 < corner_.size(); ++i) {
      const double here = (corner_[i + 1] - corner_[i]).norm();
      if (s <= here) return corner_[i] + s / here * (corner_[i + 1] - corner_[i]);
      s -= here;
    }
    return corner_.back();
  }

 private:
  std::vector<Vec3> corner_;
  double length_ = 0;
};

/// A tail of `tail` [m], a loop from the crossing at (0, 0) round a pin at x = `reach` with both strands `wide` from its middle, and a tail again.
Curve loop_with_tails(double tail, double reach, double wide) {
  std::vector<Vec3> corner = {{0, -tail, -0.5 * kDiameter}, {0, 0, -0.5 * kDiameter}, {wide, wide, -0.5 * kDiameter}};
  for (int i = 0; i <= 24; ++i) {
    const double angle = std::numbers::pi * (0.5 - i / 24.0);
    corner.emplace_back(reach + wide * std::cos(angle), wide * std::sin(angle), kDiameter * (i / 24.0 - 0.5));
  }
  corner.insert(corner.end(), {Vec3(wide, -wide, 0.5 * kDiameter), Vec3(0, 0, 0.5 * kDiameter), Vec3(0, tail, 0.5 * kDiameter)});
  return Curve(corner);
}

std::vector<double> sampled(const Curve& curve, int n) {
  std::vector<double> p;
  for (int i = 0; i < n; ++i) {
    const Vec3 at = curve.at(curve.length() * i / (n - 1));
    p.insert(p.end(), {at.x(), at.y(), at.z()});
  }
  return p;
}

// the loop is the thread between the two passages through the crossing, wherever the pin is along it and however fine the thread is
TEST(PullLoop, IsTheThreadBetweenBothPassagesThroughTheKnot) {
  for (const double reach : {1e-3, 2e-3, 4e-3})
    for (const double tail : {3e-3, 7.3e-3})
      for (const int n : {100, 139, 400}) {
        const Curve curve = loop_with_tails(tail, reach, kRadius);
        const std::vector<double> p = sampled(curve, n);
        const Places thread{p, curve.length() / (n - 1)};
        const int turn = turn_about(thread, Vec3(reach, 0, 3e-3), Vec3::UnitZ(), 1, n - 2);
        EXPECT_NEAR(turn * thread.apart, 0.5 * curve.length(), 4 * kRadius) << "the turn is in the middle";
        // strands meet within the throat of the crossing, at 45 degrees to the tails
        EXPECT_NEAR(loop_length(thread, turn, 1.3 * kDiameter), curve.length() - 2 * tail, 3 * kDiameter + 0.3 * thread.apart) << reach << " " << tail << " " << n;
      }
}

// thread that goes into the loop from one side or from both is its slip, also where both strands are parallel: the distance of the material that
// left the knot at first, which was taken for it, does not change there
TEST(PullLoop, GrowsByTheThreadThatGoesIntoIt) {
  const double reach = 2e-3;
  const Curve before = loop_with_tails(5e-3, reach, kRadius), after = loop_with_tails(4.5e-3, reach + 0.5e-3, kRadius);
  ASSERT_NEAR(before.length(), after.length(), 1e-9);
  const std::vector<double> p = sampled(before, 139), q = sampled(after, 139);
  const double apart = before.length() / 138;
  const auto length = [&](const std::vector<double>& of, double pin) {
    const Places thread{of, apart};
    return loop_length(thread, turn_about(thread, Vec3(pin, 0, 0), Vec3::UnitZ(), 1, 137), 1.3 * kDiameter);
  };
  EXPECT_NEAR(length(q, reach + 0.5e-3) - length(p, reach), 1e-3, 0.1e-3);
}

TEST(PullLoop, ThatDoesNotCloseHasNoEnd) {
  std::vector<double> straight;
  for (int i = 0; i < 50; ++i) straight.insert(straight.end(), {i * kApart, 0, 0});
  EXPECT_EQ(loop_length({straight, kApart}, 25, 1.3 * kDiameter), HUGE_VAL);
}

}  // namespace
}  // namespace swage::lesson_pull
