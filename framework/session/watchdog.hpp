// SPDX-License-Identifier: Apache-2.0
//
// Detects that the step no longer returns. It counts its own checks, not wall time: when the whole machine
// was suspended the watchdog was too, and no plugin is blamed.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <thread>

namespace swage::session {

class Watchdog {
 public:
  struct Settings {
    int64_t look_ms = 5;      // ms between two checks
    int64_t stalled_ms = 20;  // ms without a beat: forces must go to zero
    int64_t hung_ms = 500;    // ms without a beat: the program cannot continue
  };

  /// `beats`: a number that changes while the step runs; silence counts from the first value that is not 0. `hung` runs once per silence,
  /// on the watchdog's thread. `starved`: true when the watched thread only waits for a processor; such a check does not count towards a
  /// hang, but towards a stall. [main]
  Watchdog(std::function<uint64_t()> beats, std::function<void()> hung);
  Watchdog(std::function<uint64_t()> beats, std::function<void()> hung, const Settings& settings,
           std::function<bool()> starved = {});
  ~Watchdog();

  void start();  // [main]
  void stop();   // [main] joins

  /// True while the step has not returned for 20 ms: device threads give zero force. [any]
  bool stalled() const noexcept { return stalled_.load(std::memory_order_relaxed); }
  const std::atomic<bool>* stalled_flag() const noexcept { return &stalled_; }
  uint64_t stalls() const noexcept {
    return stalls_.load(std::memory_order_relaxed);
  }  // [any] number so far

 private:
  void run();

  const std::function<uint64_t()> beats_;
  const std::function<void()> hung_;
  const std::function<bool()> starved_;
  const Settings settings_;
  std::atomic<bool> stop_{false}, stalled_{false};
  std::atomic<uint64_t> stalls_{0};
  std::thread thread_;
};

}  // namespace swage::session
