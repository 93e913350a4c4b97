// SPDX-License-Identifier: Apache-2.0
#include "record/codec.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <vector>

#include "base/rng.hpp"

namespace swage::record {
namespace {

TEST(Codec, ChecksumIsTheOneOfTheStandard) {
  // check value of CRC-32C, RFC 3720 appendix B.4 gives the same family
  EXPECT_EQ(crc32c("123456789", 9), 0xE3069283u);
  const std::vector<uint8_t> zeros(32, 0);
  EXPECT_EQ(crc32c(zeros.data(), zeros.size()), 0x8A9136AAu);
}

TEST(Codec, GivesBackEveryBit) {
  base::Xoshiro256 random(3);
  for (const std::size_t rows : {std::size_t{1}, std::size_t{2}, std::size_t{249}, std::size_t{250}}) {
    std::vector<uint64_t> table(rows * 18);
    for (std::size_t i = 0; i < table.size(); ++i)
      table[i] = i % 3 == 0 ? random() : std::bit_cast<uint64_t>(1.0 + 1e-6 * static_cast<double>(i));
    const Packed packed = pack(table.data(), rows, 18);
    std::vector<uint64_t> back(table.size());
    ASSERT_TRUE(unpack(static_cast<int64_t>(packed.codec), packed.crc, packed.data, back.data(), rows, 18));
    EXPECT_EQ(table, back);
  }
}

TEST(Codec, ShrinksASlowHandAndLeavesNoiseRaw) {
  std::vector<float> hand(250 * 8);
  for (std::size_t i = 0; i < hand.size(); ++i)
    hand[i] = static_cast<float>(std::round(1e4 * std::sin(1e-3 * static_cast<double>(i / 8))) / 1e4);
  const Packed slow = pack(hand.data(), 250, 8);
  EXPECT_EQ(slow.codec, Codec::kZstdShuffleXor);
  EXPECT_LT(slow.data.size(), hand.size() * sizeof(float) / 4);

  base::Xoshiro256 random(4);
  std::vector<uint64_t> noise(250);
  for (uint64_t& word : noise) word = random();
  EXPECT_EQ(pack(noise.data(), 250, 1).codec, Codec::kRaw);
}

TEST(Codec, RefusesWhatWasTouched) {
  std::vector<uint64_t> table(250, 42), back(250);
  const Packed packed = pack(table.data(), 250, 1);
  const auto codec = static_cast<int64_t>(packed.codec);
  base::Xoshiro256 random(5);
  for (int trial = 0; trial < 200; ++trial) {
    Blob data = packed.data;
    data[random() % data.size()] ^= static_cast<uint8_t>(1 + random() % 255);
    EXPECT_FALSE(unpack(codec, packed.crc, data, back.data(), 250, 1));
    // even with a checksum made to fit, a wrong size or a broken frame must not get through or crash
    (void)unpack(codec, crc32c(data.data(), data.size()), data, back.data(), 250, 1);
  }
  EXPECT_FALSE(unpack(codec, packed.crc, packed.data, back.data(), 249, 1));
  EXPECT_FALSE(unpack(9, packed.crc, packed.data, back.data(), 250, 1));
}

}  // namespace
}  // namespace swage::record
