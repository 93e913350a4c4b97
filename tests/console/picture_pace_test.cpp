// SPDX-License-Identifier: Apache-2.0
#include "console/view3d/picture_pace.hpp"

#include <gtest/gtest.h>

namespace swage::console {
namespace {

constexpr int64_t kMs = 1'000'000;

TEST(PicturePace, DrawsUntilPicturesAreAlikeAndThenRests) {
  PicturePace pace;
  pace.want(2);
  int64_t now = 0;
  int drawn = 0;
  const auto draw = [&](bool same) {
    ASSERT_TRUE(pace.due(false));
    pace.arrived(now += 16 * kMs, same);
    ++drawn;
  };
  draw(false), draw(false);
  EXPECT_FALSE(pace.resting()) << "as many as were wanted, but each was another";
  draw(true), draw(true);
  EXPECT_FALSE(pace.resting());
  draw(true);
  EXPECT_TRUE(pace.resting());
  EXPECT_FALSE(pace.due(false));
  EXPECT_EQ(pace.count(), 5U);
  EXPECT_EQ(pace.frames().count(), 4U);
  pace.want(1);
  EXPECT_TRUE(pace.due(false));
}

TEST(PicturePace, AProcessorDrawsEveryOtherTick) {
  PicturePace pace;
  pace.want(100);
  int due = 0;
  for (int tick = 0; tick < 20; ++tick) due += pace.due(true);
  EXPECT_EQ(due, 10);
}

// Latency: from the oldest movement not yet shown, over the first snapshot after it and the first picture of that snapshot, to the paint.
TEST(PicturePace, LatencyRunsFromAMovementToThePaintThatShowsIt) {
  PicturePace pace;
  pace.want(100);
  pace.moved(100 * kMs);
  pace.moved(104 * kMs);  // of the same drag
  ASSERT_TRUE(pace.due(false));
  pace.arrived(110 * kMs, false);
  pace.painted(111 * kMs);
  EXPECT_EQ(pace.latency().count(), 0U) << "no snapshot has seen the movement yet";
  pace.sampled();
  ASSERT_TRUE(pace.due(false));
  pace.arrived(126 * kMs, false);
  EXPECT_EQ(pace.latency().count(), 0U) << "not painted yet";
  pace.painted(131 * kMs);
  ASSERT_EQ(pace.latency().count(), 1U);
  EXPECT_NEAR(pace.latency().share(0.5), 0.031, 1e-9);
  pace.painted(150 * kMs);
  EXPECT_EQ(pace.latency().count(), 1U) << "once";
  // a snapshot older than the movement does not show it
  pace.sampled();
  pace.moved(200 * kMs);
  ASSERT_TRUE(pace.due(false));
  pace.arrived(210 * kMs, false);
  pace.painted(211 * kMs);
  EXPECT_EQ(pace.latency().count(), 1U);
}

}  // namespace
}  // namespace swage::console
