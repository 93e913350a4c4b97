// SPDX-License-Identifier: Apache-2.0
//
// Filters of a device's poses: rate control, low pass, dead band. In the device's frame, before the motion scale.
#pragma once

#include <swage/abi/base.h>

#include <cstdint>

#include "host/hand_shaping.hpp"

namespace swage::step {

/// Memory of a filter: plain words, saved with the state.
struct FilterMemory {
  uint64_t started = 0;
  swage_pose low{{0, 0, 0}, {1, 0, 0, 0}};  // output of the low pass
  swage_pose out{{0, 0, 0}, {1, 0, 0, 0}};
};

/// One step of `dt` seconds. `returns`: the hand was lost before, and the memory no longer applies to it. [rt]
swage_pose filtered(const host::HandFilters& filters, FilterMemory& memory, const swage_pose& in, bool returns, double dt) noexcept;

}  // namespace swage::step
