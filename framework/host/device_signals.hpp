// SPDX-License-Identifier: Apache-2.0
//
// Signals that a device reports about itself (abi/device_signals.h): its table, checked once, and read on the thread of its exchange.
#pragma once

#include <swage/abi/device_signals.h>

#include <string>

#include "host/instance.hpp"

namespace swage::host {

class DeviceSignals {
 public:
  DeviceSignals() = default;
  /// The signals of this device; none, and a message in `error`, where its table is faulty. [main]
  DeviceSignals(Instance& instance, std::string& error);

  uint32_t count() const { return table_ != nullptr ? table_->count : 0; }
  const swage_device_signal& signal(uint32_t i) const { return table_->signal[i]; }
  /// out[count()]; NaN where unknown. False: a value was infinite, and is set to unknown. [io, or rt when LOCKSTEP] after exchange()
  bool read(uint64_t step, double* out) const noexcept;

 private:
  Instance* instance_ = nullptr;
  const swage_device_signals* table_ = nullptr;
};

}  // namespace swage::host
