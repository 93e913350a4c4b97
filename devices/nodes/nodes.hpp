// SPDX-License-Identifier: Apache-2.0
//
// Hardware that is plugged in and may not be opened: /sys names it for everybody, the node below /dev is closed. [main or io]
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace swage::nodes {

/// A place below /dev or /sys. SWAGE_DEVICE_ROOT, where it is set, stands before it: a test has hardware of its own.
std::string place(std::string_view path);

/// Linux's codes of the button that tells a kind of input device (linux/input-event-codes.h).
enum class Tells : uint16_t { kPen = 0x140, kPad = 0x130, kJoystick = 0x120 };

/// An input device of this kind that may not be read: "Intuos Pro (/dev/input/event7)", "" when there is none.
std::string closed_input(Tells kind);

/// A device of this maker (USB vendor id) that talks by hidraw or as a modem and may not be opened: as above.
std::string closed_of_maker(uint16_t vendor);

}  // namespace swage::nodes
