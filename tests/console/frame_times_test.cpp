// SPDX-License-Identifier: Apache-2.0
#include "console/view3d/frame_times.hpp"

#include <gtest/gtest.h>

namespace swage::console {
namespace {

TEST(FrameTimes, TellsHalfAndWorstButNoRests) {
  FrameTimes frames;
  EXPECT_EQ(frames.share(0.5), 0);
  int64_t now = 5'000'000'000;
  frames.add(now);
  EXPECT_EQ(frames.count(), 0U) << "one picture is no gap";
  for (int i = 1; i <= 100; ++i) frames.add(now += i * 1'000'000);
  EXPECT_EQ(frames.count(), 100U);
  EXPECT_NEAR(frames.share(0.5), 0.050, 1e-9);
  EXPECT_NEAR(frames.share(0.99), 0.099, 1e-9);
  frames.rest();
  frames.add(now += 900'000'000);
  frames.add(now + 3'000'000'000);
  EXPECT_EQ(frames.count(), 100U) << "neither after a rest, nor after what must have been one";
  for (int i = 0; i < 1000; ++i) frames.add(now += 10'000'000);
  EXPECT_EQ(frames.count(), 300U);
  EXPECT_NEAR(frames.share(0.99), 0.010, 1e-9) << "what was long ago is forgotten";
}

}  // namespace
}  // namespace swage::console
