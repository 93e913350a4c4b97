// SPDX-License-Identifier: Apache-2.0
#include "base/quantity.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

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
    EXPECT_EQ(meaningful(sign * 7e-22, "m2"), 0) << "what rounding has torn";
    EXPECT_EQ(meaningful(sign * 1e-13, "m2"), sign * 1e-13);
    EXPECT_EQ(meaningful(sign * 1e-30, "m3"), sign * 1e-30) << "nothing is known of this unit";
  }
  EXPECT_TRUE(std::isnan(meaningful(std::nan(""), "m")));
}

TEST(Quantity, SmallValuesAreToldInASmallerUnit) {
  const auto unit = [](double value, const char* si) { return std::string(shown_unit(value, si).unit); };
  for (const double sign : {1.0, -1.0}) {
    EXPECT_EQ(unit(sign * 2e-4, "m"), "mm");
    EXPECT_EQ(unit(sign * 2e-5, "m"), "um");
    EXPECT_EQ(unit(sign * 0.2, "N"), "N");
    EXPECT_EQ(unit(sign * 0.02, "N"), "mN");
    EXPECT_EQ(unit(sign * 2e-8, "m2"), "mm2");
    EXPECT_EQ(unit(sign * 7.9e-9, "m2"), "um2");
  }
  EXPECT_EQ(unit(0, "m"), "mm");
  EXPECT_EQ(unit(0, "m2"), "mm2");
  EXPECT_EQ(unit(1e-9, "s"), "s") << "as it is";
  EXPECT_EQ(unit(1e-9, "1"), "");
  EXPECT_DOUBLE_EQ(7.9e-9 * shown_unit(7.9e-9, "m2").factor, 7900);
  EXPECT_DOUBLE_EQ(usual_unit("m2").factor, 1e6) << "an axis has one unit";
}

}  // namespace
}  // namespace swage::base
