// SPDX-License-Identifier: Apache-2.0
#include "host/version.hpp"

#include <gtest/gtest.h>

using namespace swage::host;

namespace {
bool fits(const char* version, const char* range) {
  bool valid = false;
  const bool in = in_range(version, range, valid);
  EXPECT_TRUE(valid) << range;
  return in;
}
}  // namespace

TEST(Version, CaretKeepsTheMajor) {
  EXPECT_TRUE(fits("1.2.0", "^1"));
  EXPECT_TRUE(fits("1.2.0", "^1.2"));
  EXPECT_TRUE(fits("1.10.0", "^1.9"));
  EXPECT_FALSE(fits("1.2.0", "^1.3"));
  EXPECT_FALSE(fits("2.0.0", "^1.2"));
  EXPECT_TRUE(fits("0.3.5", "^0.3"));
  EXPECT_FALSE(fits("0.4.0", "^0.3")) << "below 1.0 the minor breaks";
}

TEST(Version, AtLeastAndExactly) {
  EXPECT_TRUE(fits("2.0.0", ">=1.2"));
  EXPECT_TRUE(fits("1.2.0", ">= 1.2"));
  EXPECT_FALSE(fits("1.1.9", ">=1.2"));
  EXPECT_TRUE(fits("1.2.0", "1.2"));
  EXPECT_TRUE(fits("1.2.3", "1.2.3"));
  EXPECT_FALSE(fits("1.2.4", "1.2.3"));
}

TEST(Version, RefusesWhatIsNoVersion) {
  Version v;
  for (const char* text : {"", "a", "1.", ".1", "1.2.3.4", "1.2-rc1", "-1", "v1", "99999999999"})
    EXPECT_FALSE(parse_version(text, v)) << text;
  bool valid = true;
  in_range("1.0.0", "~1", valid);
  EXPECT_FALSE(valid);
}
