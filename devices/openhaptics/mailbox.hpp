// SPDX-License-Identifier: Apache-2.0
//
// Lock-free mailbox: passes the newest value from one thread to another; neither ever waits.
#pragma once

#include <atomic>
#include <cstdint>

namespace swage::openhaptics {

template <class T>
class Mailbox {
 public:
  /// [one writer]
  void write(const T& value) noexcept {
    slot_[back_] = value;
    back_ = middle_.exchange(back_ | kFresh, std::memory_order_acq_rel) & ~kFresh;
  }
  /// The newest value; false when none has come since the last call. [one reader]
  bool read(T& out) noexcept {
    const bool fresh = (middle_.load(std::memory_order_relaxed) & kFresh) != 0;
    if (fresh) front_ = middle_.exchange(front_, std::memory_order_acq_rel) & ~kFresh;
    out = slot_[front_];
    return fresh;
  }

 private:
  static constexpr uint32_t kFresh = 4;
  T slot_[3] = {};
  uint32_t back_ = 0, front_ = 2;
  std::atomic<uint32_t> middle_{1};
};

}  // namespace swage::openhaptics
