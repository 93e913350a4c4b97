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

std::array<QRectF, 3> grown(double by) {
  std::array<QRectF, 3> out = kCorners;
  for (QRectF& at : out) at.adjust(-by, -by, by, by);
  return out;
}

CornerPlace placed(CornerPlace now, const std::vector<QPointF>& must) {
  return least_covered(kCorners, grown(-50), grown(20), now, false, must, {});
}

TEST(Corner, IsSmallWhereTheFullSizeCoversSomethingInEveryCorner) {
  const QPointF edge(740, 310), edge_2(190, 310), edge_3(190, 190);  // in each corner at the full size, in none at the small one
  EXPECT_EQ(placed({0, false}, {edge, edge_2, edge_3}), (CornerPlace{0, true}));
  EXPECT_EQ(placed({0, false}, {kFirst, edge, kThird}), (CornerPlace{1, true}));
  EXPECT_EQ(placed({1, false}, {kFirst, kThird}), (CornerPlace{1, false})) << "a corner is clear";
  EXPECT_EQ(placed({0, false}, {kFirst, kSecond, kThird}).small, false) << "smaller would be no better";
}

TEST(Corner, GrowsAgainOnlyWithRoomAboutIt) {
  const QPointF beside(590, 310);  // not in the second corner, but near it
  EXPECT_EQ(placed({1, true}, {kFirst, kThird, beside}), (CornerPlace{1, true}));
  EXPECT_EQ(placed({1, true}, {kFirst, kThird}), (CornerPlace{1, false}));
}

}  // namespace
}  // namespace swage::console
