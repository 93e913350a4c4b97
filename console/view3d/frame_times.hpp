// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace swage::console {

/// Intervals between pictures during motion. The last few hundred are kept: some seconds.
class FrameTimes {
 public:
  /// Records a picture at this time.
  void add(int64_t now_ns) {
    const double gap_s = 1e-9 * static_cast<double>(now_ns - last_ns_);
    if (last_ns_ >= 0 && gap_s < kRest_s) {
      s_[next_ % s_.size()] = gap_s;
      ++next_;
    }
    last_ns_ = now_ns;
  }
  /// Adds a known interval, s.
  void add_time(double s) {
    s_[next_ % s_.size()] = s;
    ++next_;
  }
  /// Number of intervals ever recorded.
  size_t total() const { return next_; }
  /// Motion has ended: the time to the next picture is not an interval.
  void rest() { last_ns_ = -1; }
  size_t count() const { return std::min(next_, s_.size()); }
  /// The quantile `p` of the intervals, s; 0 when there are none.
  double share(double p) const {
    std::array<double, kKept> sorted = s_;
    const size_t n = count();
    if (n == 0) return 0;
    const auto k = static_cast<std::ptrdiff_t>(std::ceil(p * static_cast<double>(n))) - 1;
    const auto at = sorted.begin() + std::clamp<std::ptrdiff_t>(k, 0, static_cast<std::ptrdiff_t>(n) - 1);
    std::nth_element(sorted.begin(), at, sorted.begin() + static_cast<std::ptrdiff_t>(n));
    return *at;
  }

  /// The median of the last `n` intervals (at most 9), s; 0 while there are fewer.
  double recent(size_t n) const {
    if (count() < n || n == 0) return 0;
    std::array<double, 9> last{};
    for (size_t i = 0; i < n; ++i) last[i] = s_[(next_ - 1 - i) % s_.size()];
    std::sort(last.begin(), last.begin() + static_cast<std::ptrdiff_t>(n));
    return last[n / 2];
  }

 private:
  static constexpr size_t kKept = 300;
  static constexpr double kRest_s = 1;  // a longer gap is not counted as an interval
  std::array<double, kKept> s_{};
  size_t next_ = 0;
  int64_t last_ns_ = -1;
};

}  // namespace swage::console
