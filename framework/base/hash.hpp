// SPDX-License-Identifier: Apache-2.0
//
// 64-bit hash of plain data, the same on every build: identifies the state of a scene after each step. Not
// cryptographic.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string_view>

namespace swage::base {

/// Adds words one after another; the order matters.
class Hash {
 public:
  explicit constexpr Hash(uint64_t seed = 0) : h_(seed ^ 0x9E3779B97F4A7C15ull) {}

  constexpr Hash& add(uint64_t word) {
    // one round of a multiply-rotate hash: odd multipliers with well distributed bits, so that each step is a
    // bijection of h_
    h_ = std::rotl(h_ ^ (word * 0xC2B2AE3D27D4EB4Full), 31) * 0x9E3779B185EBCA87ull;
    return *this;
  }
  constexpr Hash& add(double value) { return add(std::bit_cast<uint64_t>(value)); }

  Hash& add(const void* data, std::size_t bytes) {
    const char* from = static_cast<const char*>(data);
    for (; bytes >= 8; from += 8, bytes -= 8) {
      uint64_t word;
      std::memcpy(&word, from, 8);
      add(word);
    }
    if (bytes > 0) {
      uint64_t word = 0;
      std::memcpy(&word, from, bytes);
      add(word ^ (uint64_t{bytes} << 56));
    }
    return *this;
  }

  /// The hash so far, after a final mixing of its bits.
  constexpr uint64_t value() const {
    uint64_t h = h_;
    h = (h ^ (h >> 33)) * 0xFF51AFD7ED558CCDull;
    h = (h ^ (h >> 33)) * 0xC4CEB9FE1A85EC53ull;
    return h ^ (h >> 33);
  }

 private:
  uint64_t h_;
};

inline uint64_t hash(std::string_view text, uint64_t seed = 0) {
  return Hash(seed).add(text.data(), text.size()).add(uint64_t{text.size()}).value();
}

}  // namespace swage::base
