// SPDX-License-Identifier: Apache-2.0
//
// When a sensor measured, on the host's clock. A message can only come late, by what buses and schedulers make of it: the line that
// runs below all arrivals of the last ten seconds is the sensor's clock. Pure arithmetic. [any]
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace swage::sensor {

class ClockMap {
 public:
  /// Time of the measurement [s, host] of a message with this clock, which arrived at `arrival_s`. Never after its arrival and never
  /// before the last one's. `bits`: at which the sensor's clock wraps, 16 or 32.
  double stamp(uint32_t clock_us, int bits, double arrival_s);
  /// The sensor has restarted, or is another one.
  void reset();

  double drift() const { return slope_; }  // s of the host gained per second of the sensor
  uint32_t restarts() const { return restarts_; }

 private:
  struct Point {
    double t = 0, delay = 0;  // s of the sensor; arrival minus t
  };
  // a span of ten seconds in buckets of half a second: shorter spans see the drift less well, longer ones follow a warming crystal late
  static constexpr std::size_t kBuckets = 20;
  static constexpr double kBucket = 0.5;  // s
  // ceramic resonators are off by up to 0.5 %; what is above twice that is no clock
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
