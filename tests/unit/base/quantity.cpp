// SPDX-License-Identifier: Apache-2.0
#include "base/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace swage::base {
namespace {

TEST(Quantity, NumbersBelowTheMeaningOfTheirUnitAreZero) {
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(meaningful(sign * 5e-12, "m"), 0);
    EXPECT_FALSE(std::signbit(meaningful(sign * 5e-12, "m")));
    EXPECT_EQ(meaningful(sign * 2e-9, "m"), sign * 2e-9);
    EXPECT_EQ(meaningful(sign * 1e-7, "N"), 0);
    EXPECT_EQ(meaningful(sign * 1e-4, "N"), sign * 1e-4) << "0.1 mN of a thread";
    EXPECT_EQ(meaningful(sign * 1e-12, "1"), 0);
    EXPECT_EQ(meaningful(sign * 1e-9, "m2"), sign * 1e-9) << "nothing is known of this unit";
  }
  EXPECT_TRUE(std::isnan(meaningful(std::nan(""), "m")));
}

}  // namespace
}  // namespace swage::base
