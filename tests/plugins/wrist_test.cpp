// SPDX-License-Identifier: Apache-2.0
//
// The wrist of a skilled hand: its angles, its ends, and that it gives the attitude of least cost.
#include <gtest/gtest.h>

#include "devices/skilled/wrist.hpp"

namespace swage::skilled {
namespace {

constexpr double kDeg = 0.017453292519943295;

Wrist::Arm arm(bool left = false) {
  return {.left = left,
          .forearm_W = Vec3(0, 1, 0),
          .swing = 60 * kDeg,
          .hold = 90 * kDeg,
          .ease = 0.6,
          .range = {Wrist::Range{-80 * kDeg, 75 * kDeg}, {-70 * kDeg, 80 * kDeg}, {-20 * kDeg, 30 * kDeg}}};
}

Quat tool(const Vec3& axis, const Vec3& closing) {
  Mat3 R;
  R.col(0) = axis;
  R.col(2) = closing;
  R.col(1) = closing.cross(axis);
  return Quat(R);
}

TEST(Wrist, TheRestingHandHasNoAngles) {
  const Wrist wrist(arm());
  const Posture rest = wrist.asked(tool(Vec3::UnitY(), Vec3::UnitX()));
  for (const double angle : rest.angle) EXPECT_NEAR(angle, 0, 1e-15);
  EXPECT_EQ(rest.swing, 0);
  EXPECT_NEAR(wrist.strain(rest), 0, 1e-15);
}

// each anatomical movement, told as what the hand of somebody who sits at -y does: ahead is +y, right +x, up +z
TEST(Wrist, EachMovementHasItsSign) {
  const double a = 0.2;
  const auto angles = [&](const Vec3& turn, bool left) {
    const Quat rest = tool(Vec3::UnitY(), left ? Vec3(-Vec3::UnitX()) : Vec3(Vec3::UnitX()));
    return Wrist(arm(left)).asked(toolkit::exp_rotation(turn) * rest);
  };
  EXPECT_NEAR(angles({0, a, 0}, false).angle[0], a, 1e-12) << "the right hand turns clockwise: supination";
  EXPECT_NEAR(angles({-a, 0, 0}, false).angle[2], a, 1e-12) << "down, away from the thumb: ulnar";
  EXPECT_NEAR(angles({0, 0, 0.3 + 60 * kDeg}, false).angle[1], 0.3, 1e-12) << "to the palm, further than the forearm swings: flexion";
  EXPECT_NEAR(angles({0, 0, 0.3}, false).swing, 0.3, 1e-12) << "before that the forearm goes along";
  // the left arm is the right one in a mirror
  EXPECT_NEAR(angles({0, -a, 0}, true).angle[0], -a, 1e-12);
  EXPECT_NEAR(Wrist(arm(true)).given(angles({0, -2, 0}, true)).angle[0], -Wrist(arm()).given(angles({0, 2, 0}, false)).angle[0], 1e-12);
}

TEST(Wrist, AnAttitudeIsThatOfItsPosture) {
  const Wrist wrist(arm());
  for (const double rotation : {-1.5, 0.4})
    for (const double flexion : {-0.6, 0.0, 0.9})
      for (const double deviation : {-0.3, 0.5}) {
        const Quat q = wrist.attitude({0, {rotation, flexion, deviation}});
        EXPECT_LT(wrist.attitude(wrist.asked(q)).angularDistance(q), 1e-12);
      }
}

TEST(Wrist, WithinEaseItTurnsAsAskedAndBeyondNeverPastItsEnd) {
  const Wrist wrist(arm());
  EXPECT_EQ(wrist.reach(47 * kDeg, 80 * kDeg), 47 * kDeg);
  double before = 0;
  for (double asked = 0.01; asked < 6; asked += 0.01) {
    const double given = wrist.reach(asked, 80 * kDeg);
    EXPECT_GT(given, before);
    EXPECT_LT(given, 80 * kDeg);
    EXPECT_LE(given, asked + 1e-15);
    before = given;
  }
  const double at = 48 * kDeg, step = 1e-6;  // no kink where the cost begins
  EXPECT_NEAR((wrist.reach(at + step, 80 * kDeg) - wrist.reach(at, 80 * kDeg)) / step, 1, 1e-5);
  Wrist::Arm easy = arm();
  easy.ease = 1;
  EXPECT_EQ(Wrist(easy).reach(2, 80 * kDeg), 80 * kDeg) << "all at ease: stopped by the end alone";
}

// what wrist.hpp says: the least of (asked - given)^2/2 + U(given), searched for with U from its integral
TEST(Wrist, ItGivesThePostureOfLeastCost) {
  const double end = 80 * kDeg, free = 0.6 * end, room = end - free;
  const auto slope = [&](double y) { return y <= free ? 0 : free - y - room * std::log(1 - (y - free) / room); };
  const auto cost = [&](double y) {
    double sum = 0;
    constexpr int kParts = 2000;
    for (int i = 0; i < kParts; ++i) sum += slope((i + 0.5) / kParts * y) * y / kParts;
    return sum;
  };
  const Wrist wrist(arm());
  for (const double asked : {0.5, 1.0, 1.5, 2.5}) {
    double best = 0, least = 1e9;
    for (double y = 0.3; y < end - 1e-4; y += 1e-3) {
      const double total = 0.5 * (asked - y) * (asked - y) + cost(y);
      if (total < least) least = total, best = y;
    }
    EXPECT_NEAR(wrist.reach(asked, end), best, 1.1e-3) << asked;
  }
}

}  // namespace
}  // namespace swage::skilled
