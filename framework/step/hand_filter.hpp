// SPDX-License-Identifier: Apache-2.0
//
// Filters of a device's poses: rate to place, low pass, dead band. In the device's frame, before the motion scale.
#pragma once

#include <swage/abi/base.h>

#include <cstdint>

#include "host/hand_shaping.hpp"

namespace swage::step {

/// What a filter remembers: plain words, saved with the state.
struct FilterMemory {
  uint64_t started = 0;
  swage_pose low{{0, 0, 0}, {1, 0, 0, 0}};  // behind the low pass
  swage_pose out{{0, 0, 0}, {1, 0, 0, 0}};
};

/// One step of `dt` seconds. `returns`: the hand was lost, and what was before tells nothing of it. [rt]
swage_pose filtered(const host::HandFilters& filters, FilterMemory& memory, const swage_pose& in, bool returns, double dt) noexcept;

}  // namespace swage::step
