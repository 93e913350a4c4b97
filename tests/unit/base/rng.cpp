// SPDX-License-Identifier: Apache-2.0
#include "base/rng.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace swage::base {
namespace {

// published first outputs of SplitMix64 for seed 1234567
TEST(Rng, SplitMixMatchesItsReference) {
  uint64_t state = 1234567;
  EXPECT_EQ(splitmix64(state), 6457827717110365317ull);
  EXPECT_EQ(splitmix64(state), 3203168211198807973ull);
  EXPECT_EQ(splitmix64(state), 9817491932198370423ull);
}

TEST(Rng, StreamsDifferBySeedAndName) {
  EXPECT_NE(stream_seed(7, "needle"), stream_seed(8, "needle"));
  EXPECT_NE(stream_seed(7, "needle"), stream_seed(7, "jaws"));
  EXPECT_EQ(stream_seed(7, "needle"), stream_seed(7, "needle"));
}

// mean of n uniforms: 1/2 with standard deviation 1/sqrt(12 n); the bound is five of them
TEST(Rng, UniformHasTheRightMeanAndVariance) {
  Xoshiro256 random(11);
  constexpr int kCount = 200000;
  double sum = 0, squares = 0;
  for (int i = 0; i < kCount; ++i) {
    const double u = random.uniform();
    ASSERT_GE(u, 0.0);
    ASSERT_LT(u, 1.0);
    sum += u;
    squares += u * u;
  }
  const double mean = sum / kCount;
  EXPECT_NEAR(mean, 0.5, 5 / std::sqrt(12.0 * kCount));
  EXPECT_NEAR(squares / kCount - mean * mean, 1.0 / 12, 2e-3);
}

TEST(Rng, SameSeedSameNumbers) {
  Xoshiro256 a(3), b(3), c(4);
  int equal = 0;
  for (int i = 0; i < 100; ++i) {
    const uint64_t x = a();
    EXPECT_EQ(x, b());
    equal += x == c();
  }
  EXPECT_EQ(equal, 0);
}

}  // namespace
}  // namespace swage::base
