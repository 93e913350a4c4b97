// SPDX-License-Identifier: Apache-2.0
#include "host/nearest.hpp"

#include <gtest/gtest.h>

using namespace swage::host;

TEST(Nearest, CountsEdits) {
  EXPECT_EQ(edit_distance("", ""), 0u);
  EXPECT_EQ(edit_distance("abc", ""), 3u);
  EXPECT_EQ(edit_distance("arc_raduis", "arc_radius"), 1u) << "neighbours swapped";
  EXPECT_EQ(edit_distance("kitten", "sitting"), 3u);
  EXPECT_EQ(edit_distance("ca", "abc"), 3u) << "a swap is not edited again";
}

TEST(Nearest, AsksOnlyWhenCloseEnough) {
  const std::vector<std::string> names = {"arc", "arc_radius", "wire_diameter"};
  EXPECT_EQ(nearest("arc_raduis", names), "arc_radius");
  EXPECT_EQ(nearest("wire_diametre", names), "wire_diameter");
  EXPECT_EQ(nearest("colour", names), "");
  EXPECT_EQ(nearest("xyz", names), "") << "three edits make any three letters";
  EXPECT_EQ(did_you_mean("arcc", names), " Did you mean \"arc\"?");
  EXPECT_EQ(did_you_mean("arcc", {}), "");
  EXPECT_EQ(nearest(std::string(5000, 'a'), names), "");
}
