// SPDX-License-Identifier: Apache-2.0
//
// What may change a scene from outside, at the start of a step. Commands are recorded, so that a replay repeats them.
#pragma once

#include <swage/abi/builder.h>

#include <cstdint>

namespace swage::step {

/// Numbers are stored in recordings: never reuse one.
enum class CommandKind : uint32_t {
  kResetObject = 1,  // object: index; back to its start, couplings on it too
  kMark = 2,         // object: ordinal of the mark
  kLiveParameter =
      3,           // object: ordinal of the instance (objects, couplings, devices, lesson); parameter, number
  kHostEvent = 4,  // object: judge::HostEvent that the session noticed; number[0]: its value
};

struct Command {
  CommandKind kind = CommandKind::kMark;
  uint32_t object = SWAGE_NONE;
  uint32_t parameter = SWAGE_NONE;
  uint32_t reserved = 0;
  double number[4] = {0, 0, 0, 0};  // SI
};

}  // namespace swage::step
