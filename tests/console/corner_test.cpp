// SPDX-License-Identifier: Apache-2.0
#include "console/view3d/corner.hpp"

#include <gtest/gtest.h>

namespace swage::console {
namespace {

const std::array<QRectF, 3> kCorners = {QRectF(0, 300, 200, 200), QRectF(600, 300, 200, 200), QRectF(0, 0, 200, 200)};
const QPointF kFirst(100, 400), kSecond(700, 400), kThird(100, 100), kNowhere(400, 250);

TEST(Corner, StaysWhereItCoversNothing) {
  for (int now = 0; now < 3; ++now) EXPECT_EQ(least_covered(kCorners, now, {kNowhere}, {kNowhere}), now);
}

TEST(Corner, LeavesWhatTheTipsGoFor) {
  EXPECT_EQ(least_covered(kCorners, 0, {kNowhere, kFirst}, {}), 1);
  EXPECT_EQ(least_covered(kCorners, 0, {kSecond, kFirst}, {}), 2);
}

TEST(Corner, BeginsWhereItCoversNothingThatCanBeTaken) { EXPECT_EQ(least_covered(kCorners, -1, {}, {kFirst}), 1); }

TEST(Corner, DoesNotJumpWhileTheTipsAreClearOfIt) { EXPECT_EQ(least_covered(kCorners, 0, {kNowhere}, {kFirst, kFirst}), 0); }

TEST(Corner, CoversOtherThingsRatherThanTheTips) {
  EXPECT_EQ(least_covered(kCorners, 0, {kFirst}, {kSecond, kSecond, kThird}), 2);
  EXPECT_EQ(least_covered(kCorners, 1, {kFirst, kThird}, {kSecond, kSecond}), 1);
}

TEST(Corner, StaysWhereAnotherIsNoBetter) { EXPECT_EQ(least_covered(kCorners, 1, {}, {kFirst, kSecond, kThird}), 1); }

}  // namespace
}  // namespace swage::console
