// SPDX-License-Identifier: Apache-2.0
//
// Durations in logarithmic bins, eight per octave: quantiles to 9 % from 1 ns to 500 years in 4 KiB, without
// allocation.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

namespace swage::base {

class Histogram {
 public:
  void add(int64_t ns) noexcept {
    const uint64_t value = ns < 0 ? 0 : static_cast<uint64_t>(ns);
    ++count_[bin(value)];
    ++total_;
    sum_ += static_cast<double>(value);
    if (value > max_) max_ = value;
  }
  void clear() noexcept { *this = Histogram(); }

  uint64_t total() const noexcept { return total_; }
  uint64_t max() const noexcept { return max_; }
  /// 0 without values.
  double mean() const noexcept { return total_ > 0 ? sum_ / static_cast<double>(total_) : 0; }

  /// Smallest upper edge of a bin such that at least a share q of all values is below it; never above
  /// the maximum.
  uint64_t quantile(double q) const noexcept {
    const double wanted = q * static_cast<double>(total_);
    uint64_t sum = 0;
    for (uint32_t i = 0; i < kBins; ++i) {
      sum += count_[i];
      if (sum > 0 && static_cast<double>(sum) >= wanted) {
        const uint64_t edge = upper_edge(i);
        return edge < max_ ? edge : max_;
      }
    }
    return max_;
  }

  /// Number of values in bins wholly above `ns`.
  uint64_t above(uint64_t ns) const noexcept {
    uint64_t sum = 0;
    for (uint32_t i = bin(ns) + 1; i < kBins; ++i) sum += count_[i];
    return sum;
  }

 private:
  static constexpr uint32_t kBins = 8 * 62;

  // the leading bit chooses the octave, the next three bits the eighth of it; values below 8 have a bin each
  static uint32_t bin(uint64_t value) noexcept {
    if (value < 8) return static_cast<uint32_t>(value);
    const uint32_t shift = static_cast<uint32_t>(std::bit_width(value)) - 4;
    return 8 * shift + static_cast<uint32_t>(value >> shift);
  }
  static uint64_t upper_edge(uint32_t i) noexcept {
    if (i < 8) return i;
    const uint32_t shift = i / 8 - 1;
    return ((uint64_t{8} + i % 8 + 1) << shift) - 1;
  }

  std::array<uint64_t, kBins> count_{};
  uint64_t total_ = 0, max_ = 0;
  double sum_ = 0;
};

}  // namespace swage::base
