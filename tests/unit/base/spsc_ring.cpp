// SPDX-License-Identifier: Apache-2.0
#include "base/spsc_ring.hpp"

#include <gtest/gtest.h>

#include <thread>

namespace swage::base {
namespace {

TEST(SpscRing, KeepsOrderAndRefusesWhenFull) {
  SpscRing<int> ring(3);  // rounded up to 4
  EXPECT_EQ(ring.capacity(), 4u);
  int out = -1;
  EXPECT_FALSE(ring.try_pop(out));
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(ring.try_push(i));
  EXPECT_FALSE(ring.try_push(4));
  EXPECT_EQ(ring.size(), 4u);
  for (int i = 0; i < 4; ++i) {
    ASSERT_TRUE(ring.try_pop(out));
    EXPECT_EQ(out, i);
  }
  EXPECT_FALSE(ring.try_pop(out));
}

TEST(SpscRing, WrapsAroundManyTimes) {
  SpscRing<uint64_t> ring(8);
  uint64_t in = 0, expected = 0, out = 0;
  for (int round = 0; round < 1000; ++round) {
    for (int i = 0; i < round % 9; ++i)
      if (ring.try_push(in)) ++in;
    for (int i = 0; i < round % 5; ++i)
      if (ring.try_pop(out)) {
        ASSERT_EQ(out, expected++);
      }
  }
  EXPECT_GT(expected, 1000u);
}

// two threads, nothing lost, nothing torn: the three copies of each number must agree
TEST(SpscRing, PassesWholeValuesBetweenThreads) {
  struct Triple {
    uint64_t a, b, c;
  };
  constexpr uint64_t kCount = 50000;
  SpscRing<Triple> ring(64);
  std::thread writer([&] {
    for (uint64_t i = 0; i < kCount; ++i)
      while (!ring.try_push({i, ~i, i * 3})) std::this_thread::yield();
  });
  uint64_t expected = 0;
  Triple t{};
  while (expected < kCount) {
    if (!ring.try_pop(t)) {
      std::this_thread::yield();
      continue;
    }
    ASSERT_EQ(t.a, expected);
    ASSERT_EQ(t.b, ~expected);
    ASSERT_EQ(t.c, expected * 3);
    ++expected;
  }
  writer.join();
}

}  // namespace
}  // namespace swage::base
