// SPDX-License-Identifier: Apache-2.0
#include "base/histogram.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "base/rng.hpp"

namespace swage::base {
namespace {

TEST(Histogram, SmallNumbersAreExact) {
  Histogram h;
  for (int i = 0; i < 8; ++i) h.add(i);
  for (int i = 0; i < 8; ++i) EXPECT_EQ(h.quantile((i + 1) / 8.0), static_cast<uint64_t>(i));
  EXPECT_EQ(h.above(5), 2u);
}

// against sorted values: never below the true quantile, and at most one bin (12.5 % of the octave's start)
// above it
TEST(Histogram, QuantilesAreWithinOneBin) {
  Xoshiro256 random(5);
  Histogram h;
  std::vector<int64_t> values;
  for (int i = 0; i < 20000; ++i) {
    const auto ns = static_cast<int64_t>(std::exp(random.uniform(0, 20)));
    values.push_back(ns);
    h.add(ns);
  }
  std::sort(values.begin(), values.end());
  for (double q : {0.01, 0.5, 0.9, 0.99, 0.999, 1.0}) {
    const auto rank = static_cast<std::size_t>(std::ceil(q * static_cast<double>(values.size()))) - 1;
    const double exact = static_cast<double>(values[rank]);
    const double got = static_cast<double>(h.quantile(q));
    EXPECT_GE(got, exact);
    EXPECT_LE(got, exact * 1.125 + 1);
  }
  EXPECT_EQ(h.max(), static_cast<uint64_t>(values.back()));
  EXPECT_EQ(h.quantile(1.0), h.max());
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  EXPECT_NEAR(h.mean(), sum / static_cast<double>(values.size()), 1e-9 * sum);
}

TEST(Histogram, TakesExtremes) {
  Histogram h;
  h.add(-5);
  h.add(INT64_MAX);
  EXPECT_EQ(h.total(), 2u);
  EXPECT_EQ(h.quantile(0.5), 0u);
  EXPECT_EQ(h.max(), static_cast<uint64_t>(INT64_MAX));
  h.clear();
  EXPECT_EQ(h.total(), 0u);
  EXPECT_EQ(h.quantile(0.99), 0u);
  EXPECT_EQ(h.mean(), 0);
}

}  // namespace
}  // namespace swage::base
