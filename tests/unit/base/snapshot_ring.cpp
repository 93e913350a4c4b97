// SPDX-License-Identifier: Apache-2.0
#include "base/snapshot_ring.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

namespace swage::base {
namespace {

struct Value {
  uint64_t number;
  uint64_t copy[300];
  uint32_t tail;
};

Value make(uint64_t n) {
  Value v{};
  v.number = n;
  for (uint64_t& c : v.copy) c = n * 7;
  v.tail = static_cast<uint32_t>(n);
  return v;
}

TEST(SnapshotRing, NothingBeforeTheFirst) {
  SnapshotRing<Value> ring;
  Value v{};
  EXPECT_EQ(ring.latest(v), 0u);
}

TEST(SnapshotRing, GivesTheNewest) {
  SnapshotRing<Value> ring;
  Value v{};
  for (uint64_t n = 1; n <= 20; ++n) {
    ring.publish(make(n));
    ASSERT_EQ(ring.latest(v), n);
    ASSERT_EQ(v.number, n);
    ASSERT_EQ(v.tail, n);
  }
}

TEST(SnapshotRing, PublishesOnlyTheFirstBytesWhenAsked) {
  SnapshotRing<Value, 2> ring;
  for (int i = 0; i < 2; ++i) ring.publish(make(1));
  ring.publish(make(5), 8 * 11);
  Value v{};
  ASSERT_EQ(ring.latest(v), 3u);
  EXPECT_EQ(v.number, 5u);
  EXPECT_EQ(v.copy[9], 35u);
  EXPECT_EQ(v.copy[10], 7u);
}

TEST(SnapshotRing, CarriesOddSizes) {
  struct Odd {
    char text[13];
  };
  SnapshotRing<Odd> ring;
  ring.publish({"twelve chars"});
  Odd out{};
  ring.latest(out);
  EXPECT_STREQ(out.text, "twelve chars");
}

TEST(SnapshotRing, ReadersNeverSeeATornValueOrGoBack) {
  SnapshotRing<Value> ring;
  std::atomic<bool> done{false};
  std::atomic<uint64_t> torn{0}, back{0}, reads{0};
  auto reader = [&] {
    Value v{};
    uint64_t last = 0;
    while (!done.load()) {
      if (ring.latest(v) == 0) continue;
      for (uint64_t c : v.copy) torn += c != v.number * 7;
      torn += v.tail != static_cast<uint32_t>(v.number);
      back += v.number < last;
      last = v.number;
      ++reads;
      std::this_thread::yield();
    }
  };
  std::vector<std::thread> readers;
  for (int i = 0; i < 3; ++i) readers.emplace_back(reader);
  for (uint64_t n = 1; n <= 20000 || reads.load() < 100; ++n) {
    ring.publish(make(n));
    if (n % 64 == 0) std::this_thread::yield();
  }
  done = true;
  for (std::thread& t : readers) t.join();
  EXPECT_EQ(torn.load(), 0u);
  EXPECT_EQ(back.load(), 0u);
}

}  // namespace
}  // namespace swage::base
