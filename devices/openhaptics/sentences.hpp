// SPDX-License-Identifier: Apache-2.0
//
// Messages of this bundle about OpenHaptics and its arm. Tests refer to their names and never repeat their words.
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::openhaptics::say {

using toolkit::operator""_sentence;

inline constexpr auto kNoLibrary =
    "The OpenHaptics library cannot be loaded ({}). Install OpenHaptics 3.4 and the driver of the arm from their maker; an old one may need the package libncurses5."_sentence;
inline constexpr auto kLacks = "libHD.so has no {}: it is not the HD library of OpenHaptics 3.0 or later."_sentence;
inline constexpr auto kMayNotOpen =
    "{} is there and may not be opened. Install the udev rule 70-swage.device.openhaptics.rules, or for a serial port add yourself to the group dialout (sudo adduser $USER dialout) and log in again."_sentence;
inline constexpr auto kNoArm =
    "The arm does not answer: {}. Switch it on, see that its maker's setup finds it, and that you may use its port."_sentence;
inline constexpr auto kTaken = "another program has it"_sentence;
inline constexpr auto kNotCalibrated =
    "The arm is not calibrated. Put its stylus into the inkwell, or run its maker's calibration, and start again."_sentence;
inline constexpr auto kNoScheduler = "The scheduler of OpenHaptics does not start: {}."_sentence;
inline constexpr auto kArm = "Arm: {}, serial number {}"_sentence;
inline constexpr auto kUnknown = "unknown"_sentence;

}  // namespace swage::openhaptics::say
