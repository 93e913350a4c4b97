// SPDX-License-Identifier: Apache-2.0
#include "record/identity.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

namespace swage::record {
namespace {

TEST(Identity, IdsAreVersion7AndInOrderOfTime) {
  const char* shape = "[0-9a-f]{8}-[0-9a-f]{4}-7[0-9a-f]{3}-[89ab][0-9a-f]{3}-[0-9a-f]{12}";
  std::set<std::string> ids;
  std::string last;
  for (int i = 0; i < 1000; ++i) {
    const std::string id = make_id();
    EXPECT_THAT(id, testing::MatchesRegex(shape));
    EXPECT_GT(id, last) << "of one process, also within a millisecond";
    last = id;
    ids.insert(id);
  }
  EXPECT_EQ(ids.size(), 1000u);
}

TEST(Identity, TimesAreIsoText) {
  EXPECT_THAT(utc_now(),
              testing::MatchesRegex("20[0-9]{2}-[0-9]{2}-[0-9]{2}T[0-9]{2}:[0-9]{2}:[0-9]{2}[.][0-9]{3}Z"));
  EXPECT_FALSE(station().empty());
}

}  // namespace
}  // namespace swage::record
