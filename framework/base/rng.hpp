// SPDX-License-Identifier: Apache-2.0
//
// Seeded random numbers, the same on every build. Nothing in Swage uses another source.
#pragma once

#include <bit>
#include <cstdint>
#include <string_view>

#include "base/hash.hpp"

namespace swage::base {

/// SplitMix64 (Steele, Lea, Flood 2014): 64 bits of state, so a stream takes one word of the saved state.
constexpr uint64_t splitmix64(uint64_t& state) {
  uint64_t z = (state += 0x9E3779B97F4A7C15ull);
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
  return z ^ (z >> 31);
}

/// Seed of the stream of one instance of a lesson.
inline uint64_t stream_seed(uint64_t lesson_seed, std::string_view instance_name) {
  return hash(instance_name, lesson_seed);
}

/// Uniform in [0, 1), 53 bits.
constexpr double unit_interval(uint64_t bits) { return static_cast<double>(bits >> 11) * 0x1.0p-53; }

/// xoshiro256++ (Blackman, Vigna 2019), for tests and tools that draw many numbers.
class Xoshiro256 {
 public:
  using result_type = uint64_t;
  explicit constexpr Xoshiro256(uint64_t seed) {
    for (uint64_t& word : s_) word = splitmix64(seed);
  }
  static constexpr uint64_t min() { return 0; }
  static constexpr uint64_t max() { return ~uint64_t{0}; }
  constexpr uint64_t operator()() {
    const uint64_t out = std::rotl(s_[0] + s_[3], 23) + s_[0];
    const uint64_t t = s_[1] << 17;
    s_[2] ^= s_[0];
    s_[3] ^= s_[1];
    s_[1] ^= s_[2];
    s_[0] ^= s_[3];
    s_[2] ^= t;
    s_[3] = std::rotl(s_[3], 45);
    return out;
  }
  constexpr double uniform() { return unit_interval((*this)()); }
  constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }

 private:
  uint64_t s_[4];
};

}  // namespace swage::base
