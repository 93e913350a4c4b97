// SPDX-License-Identifier: Apache-2.0
//
// Messages of this bundle about pen tablets. Tests refer to their names and never repeat their words.
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::tablet::say {

using toolkit::operator""_sentence;

inline constexpr auto kNoTablet = "There is no pen tablet{}. Plug one in; the kernel's drivers (wacom, hid-uclogic) need no package."_sentence;
inline constexpr auto kCalled = " \"{}\""_sentence;
inline constexpr auto kNoPen = "{} is no pen tablet. Its node is named below /dev/input/by-id with event-mouse or event-pen."_sentence;
inline constexpr auto kNotOpened = "{} cannot be opened: {}. Is the tablet plugged in?"_sentence;
inline constexpr auto kMayNotRead = "{} may not be read.{}"_sentence;
inline constexpr auto kClosed = "{} is there and may not be read.{}"_sentence;
inline constexpr auto kRights =
    " Install the udev rule 70-swage.device.tablet.rules, or add yourself to the group input (sudo adduser $USER input) and log in again."_sentence;
inline constexpr auto kTablet = "Tablet: {}{}"_sentence;
inline constexpr auto kNoTilt = ", whose pen tells no tilt"_sentence;

}  // namespace swage::tablet::say
