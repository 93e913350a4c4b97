// SPDX-License-Identifier: Apache-2.0
#include "sensor/clock_map.hpp"

#include <algorithm>
#include <cmath>

namespace swage::sensor {

void ClockMap::reset() {
  used_ = 0;
  begun_ = false;
  slope_ = 0;
  t_ = 0;
}

// The sensor clock without wraps. A clock of 16 bits wraps every 65 ms: the host's clock tells how often it did.
double ClockMap::unwrapped(uint32_t clock_us, int bits, double arrival_s) {
  const double range = std::ldexp(1e-6, bits);  // s
  const uint32_t mask = bits >= 32 ? 0xFFFFFFFFu : (uint32_t{1} << bits) - 1;
  double ahead = 1e-6 * static_cast<double>((clock_us - last_us_) & mask);
  const double waited = arrival_s - arrival_;
  ahead += range * std::max(0.0, std::round((waited - ahead) / range));
  // a 32-bit clock that jumps back, or far ahead of the host, belongs to a restarted sensor
  constexpr double kJump = 1;  // s, more than the delay of any bus
  const bool jumped = ahead > waited + kJump + kMostDrift * waited && bits >= 32;
  return jumped ? -1 : t_ + ahead;
}

double ClockMap::stamp(uint32_t clock_us, int bits, double arrival_s) {
  double t = begun_ ? unwrapped(clock_us, bits, arrival_s) : 0;
  if (t < 0) {
    reset();
    ++restarts_;
    t = 0;
  }
  begun_ = true;
  last_us_ = clock_us;
  t_ = t;
  arrival_ = arrival_s;

  const Point now{t, arrival_s - t};
  if (used_ == 0 || std::floor(t / kBucket) > std::floor(lowest_[used_ - 1].t / kBucket)) {
    if (used_ == kBuckets) std::move(lowest_.begin() + 1, lowest_.end(), lowest_.begin()), --used_;
    lowest_[used_++] = now;
    fit();
  } else if (now.delay - slope_ * t < lowest_[used_ - 1].delay - slope_ * lowest_[used_ - 1].t) {
    lowest_[used_ - 1] = now;
  }
  // the lowest line with this slope; no message may arrive before its measurement
  double offset = now.delay - slope_ * t;
  for (std::size_t i = 0; i < used_; ++i) offset = std::min(offset, lowest_[i].delay - slope_ * lowest_[i].t);
  return stamp_ = std::min(arrival_s, std::max(stamp_, t + offset + slope_ * t));
}

// Slope of the edge of the lower convex hull over the middle of the span: of the lines below all points, the one nearest to them in sum.
void ClockMap::fit() {
  if (used_ < 5) return;  // less than two seconds: there the scatter of a bus looks like drift
  double middle = 0;
  for (std::size_t i = 0; i < used_; ++i) middle += lowest_[i].t / static_cast<double>(used_);
  double best = 0, height = -1e300;
  for (std::size_t i = 0; i < used_; ++i) {
    for (std::size_t k = i + 1; k < used_; ++k) {
      const double slope = (lowest_[k].delay - lowest_[i].delay) / (lowest_[k].t - lowest_[i].t);
      double offset = 1e300;
      for (std::size_t m = 0; m < used_; ++m) offset = std::min(offset, lowest_[m].delay - slope * lowest_[m].t);
      if (std::abs(slope) > kMostDrift || offset + slope * middle <= height) continue;
      height = offset + slope * middle;
      best = slope;
    }
  }
  slope_ = best;
}

}  // namespace swage::sensor
