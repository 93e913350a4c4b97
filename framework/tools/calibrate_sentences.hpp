// SPDX-License-Identifier: Apache-2.0
//
// Sentences that swage calibrate and its tables tell; those of sensors and fits are in sensor/sentences.hpp. Tests name them, and never repeat their words.
#pragma once

#include "base/sentence.hpp"

namespace swage::tools::say {

using base::operator""_sentence;

// what it is told
inline constexpr auto kSayWho = "Say who calibrates, with --by."_sentence;
inline constexpr auto kWhoseTable = "Say whose table this is: the sensor's serial number with --serial."_sentence;
inline constexpr auto kCannotName = "\"{}\" cannot name a file. Give a serial number of letters, digits, - _ and . with --serial."_sentence;
inline constexpr auto kTypedNoNumber = "That is no number."_sentence;
inline constexpr auto kNobodyAnswers = "Nobody answers."_sentence;
inline constexpr auto kNobodyKeeps = "Nobody answers; nothing is kept."_sentence;
inline constexpr auto kNothingKept = " Nothing is kept."_sentence;  // after why
inline constexpr auto kRowOf = "{}, line {}: a row has {} numbers."_sentence;
inline constexpr auto kNoRow = "{}: It has no row of numbers."_sentence;
inline constexpr auto kOfTable = "{}: {}"_sentence;

// the sensor
inline constexpr auto kSaysNotWho = "{} does not say who it is. Is it a sensor that speaks JAW1, and powered?"_sentence;
inline constexpr auto kVoltsFirst = "Its volts have no meaning yet. First: swage calibrate displacement."_sentence;
inline constexpr auto kTravelFirst = "Its travel has no force yet. First: swage calibrate force."_sentence;
inline constexpr auto kNoneKept = "No calibration is kept in {}"_sentence;

}  // namespace swage::tools::say
