// SPDX-License-Identifier: Apache-2.0
//
// Time of a sensor's measurement on the host's clock. A message arrives only late, never early, by the delay of buses and schedulers: the
// lower bound of all arrival times in the last ten seconds is the sensor's clock. Pure arithmetic. [any]
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace swage::sensor {

class ClockMap {
 public:
  /// Time of the measurement [s, host clock] of a message with this sensor clock that arrived at `arrival_s`. Not after arrival, nor
  /// before the last measurement. `bits`: width of the sensor's clock, 16 or 32.
  double stamp(uint32_t clock_us, int bits, double arrival_s);
  /// Starts anew: the sensor has restarted, or is another one.
  void reset();

  double drift() const { return slope_; }  // relative rate difference: s of the host's clock gained per second of the sensor's
  uint32_t restarts() const { return restarts_; }

 private:
  struct Point {
    double t = 0, delay = 0;  // s, sensor clock; s, arrival minus t
  };
  // ten seconds in buckets of half a second: a shorter span resolves the drift less well, a longer one follows a warming crystal late
  static constexpr std::size_t kBuckets = 20;
  static constexpr double kBucket = 0.5;  // s
  // ceramic resonators are off by up to 0.5 %; more than twice that is a fault
  static constexpr double kMostDrift = 0.01;

  double unwrapped(uint32_t clock_us, int bits, double arrival_s);
  void fit();

  std::array<Point, kBuckets> lowest_{};
  std::size_t used_ = 0;
  bool begun_ = false;
  uint32_t last_us_ = 0, restarts_ = 0;
  double t_ = 0, arrival_ = 0, stamp_ = -1e300;  // s
  double slope_ = 0;
};

}  // namespace swage::sensor
