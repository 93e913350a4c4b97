// SPDX-License-Identifier: Apache-2.0
#include "base/hash.hpp"

#include <gtest/gtest.h>

#include <set>

namespace swage::base {
namespace {

TEST(Hash, OrderAndLengthCount) {
  EXPECT_NE(Hash().add(uint64_t{1}).add(uint64_t{2}).value(),
            Hash().add(uint64_t{2}).add(uint64_t{1}).value());
  EXPECT_NE(hash("ab"), hash(std::string_view("ab\0", 3)));
  EXPECT_NE(hash(""), hash(std::string_view("\0", 1)));
  EXPECT_NE(hash("needle"), hash("needle", 1));
}

TEST(Hash, EveryBitOfAStateCounts) {
  double state[16] = {};
  for (int i = 0; i < 16; ++i) state[i] = 0.1 * i;
  std::set<uint64_t> seen{Hash().add(state, sizeof state).value()};
  for (std::size_t bit = 0; bit < 8 * sizeof state; ++bit) {
    auto* bytes = reinterpret_cast<unsigned char*>(state);
    bytes[bit / 8] = static_cast<unsigned char>(bytes[bit / 8] ^ (1u << (bit % 8)));
    EXPECT_TRUE(seen.insert(Hash().add(state, sizeof state).value()).second) << "bit " << bit;
    bytes[bit / 8] = static_cast<unsigned char>(bytes[bit / 8] ^ (1u << (bit % 8)));
  }
}

// recordings outlive builds: these numbers may never change
TEST(Hash, IsFrozen) {
  EXPECT_EQ(hash("swage"), 5215343587648801393ull);
  EXPECT_EQ(Hash(7).add(1.5).add(uint64_t{42}).value(), 7172638991804695233ull);
}

}  // namespace
}  // namespace swage::base
