// SPDX-License-Identifier: Apache-2.0
//
// A handle that is let go: what is told of it, and what its zero does to the poses.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sensor/calibration.hpp"
#include "sensor/sentences.hpp"

namespace swage::sensor {
namespace {

using testing::HasSubstr;

TEST(Zero, IsOpenAndTheOtherPosesGoWithIt) {
  for (const double way : {1.0, -1.0}) {  // mounted either way round
    const Poses poses = {way * 5e-3, way * 2e-3, way * 0.5e-3};
    EXPECT_NEAR(closed_share(poses, way * 2e-3), 1, 1e-12);
    EXPECT_NEAR(closed_share(poses, way * 5.3e-3), -0.1, 1e-12);
    Poses moved = poses;
    ASSERT_EQ(set_zero(way * 5.3e-3, moved), "");
    EXPECT_NEAR(moved.open, way * 5.3e-3, 1e-12);
    EXPECT_NEAR(moved.closed, way * 2.3e-3, 1e-12);
    EXPECT_NEAR(moved.squeezed, way * 0.8e-3, 1e-12);
    EXPECT_NEAR(closed_share(moved, way * 2.3e-3), 1, 1e-12);
    EXPECT_THAT(set_zero(way * 4.3e-3, moved), HasSubstr(say::kRestsElsewhere.words(1)));
    EXPECT_NEAR(moved.open, way * 5.3e-3, 1e-12) << "and stays";
  }
  Poses none;
  EXPECT_THAT(set_zero(1e-3, none), HasSubstr(say::kNoPoses()));
}

TEST(Zero, AHandleThatRestsElsewhereIsNoticedAndOneInAHandIsNot) {
  const Poses poses = {5e-3, 2e-3, 0.5e-3};
  EXPECT_EQ(rest_trouble(poses, 5e-3, 0), "");
  EXPECT_EQ(rest_trouble(poses, 4.95e-3, 0.05), "");
  EXPECT_THAT(rest_trouble(poses, 4.7e-3, 0), HasSubstr(say::kReadsLess("0.30", "10") + say::kSetZero()));
  EXPECT_THAT(rest_trouble(poses, 6.5e-3, 0), HasSubstr(say::kReadsMore("1.50", "50")));
  EXPECT_THAT(rest_trouble(poses, 5e-3, -0.4), HasSubstr(say::kGaugeReads("-0.40")));
  EXPECT_EQ(rest_trouble(poses, 2e-3, 3), "") << "closed by a hand";
}

}  // namespace
}  // namespace swage::sensor
