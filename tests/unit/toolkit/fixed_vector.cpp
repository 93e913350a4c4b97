// SPDX-License-Identifier: Apache-2.0
#include "toolkit/fixed_vector.hpp"

#include <gtest/gtest.h>

namespace swage::toolkit {
namespace {

TEST(FixedVector, RefusesWhatDoesNotFit) {
  FixedVector<int, 3> v;
  EXPECT_TRUE(v.empty());
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(v.add(i));
  EXPECT_TRUE(v.full());
  EXPECT_FALSE(v.add(3));
  EXPECT_FALSE(v.insert(0, 3));
  EXPECT_EQ(v.size(), 3);
  EXPECT_EQ(v.back(), 2);
}

TEST(FixedVector, InsertsBeforeAnElementEvenItself) {
  FixedVector<int, 5> v;
  for (int i = 0; i < 4; ++i) v.add(10 * i);
  EXPECT_TRUE(v.insert(1, v[2]));
  const int expected[] = {0, 20, 10, 20, 30};
  for (int i = 0; i < 5; ++i) EXPECT_EQ(v[i], expected[i]);
}

TEST(FixedVector, CopiesAreTheirOwn) {
  FixedVector<int, 4> a;
  a.add(1), a.add(2);
  FixedVector<int, 4> b = a;
  b[0] = 7;
  EXPECT_EQ(a[0], 1);
  a = b;
  EXPECT_EQ(a[0], 7);
  const auto& self = a;
  a = self;
  EXPECT_EQ(a.size(), 2);
  a.shrink(1);
  EXPECT_EQ(a.end() - a.begin(), 1);
  a.clear();
  EXPECT_TRUE(a.empty());
}

}  // namespace
}  // namespace swage::toolkit
