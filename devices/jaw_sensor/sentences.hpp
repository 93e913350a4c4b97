// SPDX-License-Identifier: Apache-2.0
//
// Messages of this bundle about its sensor; those about ports and calibrations are in sensor/sentences.hpp. Tests refer to names only.
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::jaw_sensor::say {

using toolkit::operator""_sentence;

// detection
inline constexpr auto kNoAdapter = "There is no serial adapter below /dev/serial/by-id. Plug the sensor in, or name its port."_sentence;
inline constexpr auto kManyAdapters = "There are several serial adapters; name the port of the sensor, one of:{}"_sentence;
inline constexpr auto kOtherDialect = "{} sends what is no message of this dialect at {} bit/s. Is its dialect right, and its bits_per_s?"_sentence;
inline constexpr auto kSilent = "{} is there and says nothing at {} bit/s. Is the sensor powered, and is bits_per_s right?"_sentence;
inline constexpr auto kOtherSensor = "The sensor {} is plugged in in place of {}, with which the lesson began. It is not used."_sentence;

// its calibration
inline constexpr auto kPoseOrder = "open, just closed and squeezed lie in this order, up or down"_sentence;
inline constexpr auto kNoPoses = "The calibration has no poses of this needleholder; it is not used. Make them: swage calibrate poses."_sentence;
inline constexpr auto kNotCalibrated = "Sensor {}: not calibrated. Its volts are taken as they are."_sentence;
inline constexpr auto kNoSerial = "without a serial number"_sentence;
inline constexpr auto kCalibrated =
    "Sensor {}: calibrated on {} by {}, residuals up to {} um; poses of {}; {}{}.{}"_sentence;  // then the known forces, and kMeasureAnew
inline constexpr auto kNoForces = "no table of forces"_sentence;
inline constexpr auto kByTravel = "force by travel"_sentence;
inline constexpr auto kByTips = ", force at the tips by that at the handle"_sentence;
inline constexpr auto kMeasureAnew = " The poses change with the hand and its warmth; measure them in each session: swage calibrate poses."_sentence;

}  // namespace swage::jaw_sensor::say
