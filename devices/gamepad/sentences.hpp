// SPDX-License-Identifier: Apache-2.0
//
// Messages of this bundle about SDL and pads. Tests refer to their names and never repeat their words.
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::gamepad::say {

using toolkit::operator""_sentence;

inline constexpr auto kNoLibrary = "{} is not installed. Install the package libsdl2-2.0-0 (sudo apt install libsdl2-2.0-0)."_sentence;
inline constexpr auto kLacks = "{} has no {}. Install the package libsdl2-2.0-0 of Debian 12 or newer."_sentence;
inline constexpr auto kNotStarted = "SDL does not start: {}."_sentence;
inline constexpr auto kNoPad = "There is no game pad. Plug one in, or pair it by Bluetooth."_sentence;
inline constexpr auto kNoSuchPad = "There is no game pad \"{}\". There is: {}."_sentence;
inline constexpr auto kMayNotRead =
    "{} is there and may not be read. Install the udev rule 70-swage.device.gamepad.rules, or add yourself to the group input (sudo adduser $USER input) and log in again."_sentence;
inline constexpr auto kPad = "Pad: {}"_sentence;
inline constexpr auto kLowBattery = "The battery of the pad {} is low. Charge it, or put it on its wire."_sentence;

}  // namespace swage::gamepad::say
