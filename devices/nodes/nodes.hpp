// SPDX-License-Identifier: Apache-2.0
//
// Hardware that is plugged in and may not be opened: anyone may read its name in /sys, but not open its node below /dev. [main or io]
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace swage::nodes {

/// A path below /dev or /sys, prefixed with SWAGE_DEVICE_ROOT where that is set: tests provide their own hardware there.
std::string place(std::string_view path);

/// Linux's codes of the buttons that identify a kind of input device (linux/input-event-codes.h).
enum class Tells : uint16_t { kPen = 0x140, kPad = 0x130, kJoystick = 0x120 };

/// Name of an input device of this kind that may not be read: "Intuos Pro (/dev/input/event7)", "" when there is none.
std::string closed_input(Tells kind);

/// The same for a device of this manufacturer (USB vendor id) on a hidraw or modem node that may not be opened.
std::string closed_of_maker(uint16_t vendor);

}  // namespace swage::nodes
