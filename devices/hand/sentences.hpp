// SPDX-License-Identifier: Apache-2.0
//
// Messages about files of hands and plans. Tests refer to their names and never repeat their words.
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::hand::say {

using toolkit::operator""_sentence;

// numbers and units
inline constexpr auto kNumberNeeded = R"(a number or a text like "2.6 mm" is needed here)"_sentence;
inline constexpr auto kOtherMeasure = "\"{}\" is not {}"_sentence;  // {}: the required quantity, as below
inline constexpr auto kLength = "a length (m, mm, um)"_sentence;
inline constexpr auto kTime = "a time (s, ms)"_sentence;
inline constexpr auto kAngle = "an angle (rad, deg)"_sentence;
inline constexpr auto kForce = "a force (N, mN)"_sentence;
inline constexpr auto kPure = "a pure number"_sentence;
inline constexpr auto kNotFinite = "the number is not finite"_sentence;
inline constexpr auto kTextNeeded = "a text is needed here"_sentence;
inline constexpr auto kThreeNeeded = "three numbers are needed here"_sentence;

// the file
inline constexpr auto kNoJson = "not JSON: {}"_sentence;
inline constexpr auto kFormat = "\"{}\" is needed here"_sentence;
inline constexpr auto kUnknownKey = "unknown; {}"_sentence;
inline constexpr auto kHandHas = "a hand has format, title, doc, and keys or samples"_sentence;
inline constexpr auto kKeysOrSamples = R"(give either "keys" or "samples")"_sentence;
inline constexpr auto kEmpty = "at least one is needed"_sentence;

// keys and samples
inline constexpr auto kKey = R"(a key is an object like {"t": 1.5, "closure": 0.6})"_sentence;
inline constexpr auto kKeyHas = "unknown; a key has t, p, q or rpy or axis and closing, turn, closure, grip, doc"_sentence;
inline constexpr auto kNoTime = R"("t", the time, is missing)"_sentence;
inline constexpr auto kNoPlace = R"(the first key needs "p", the place)"_sentence;
inline constexpr auto kFirstTurns = "the first key stands; it cannot turn from anywhere"_sentence;
inline constexpr auto kTurnOr = R"(give "turn" or "{}", not both)"_sentence;
inline constexpr auto kTurn = R"(a turn is {"about": [x, y, z], "axis": [x, y, z], "angle": "90 deg"})"_sentence;
inline constexpr auto kNoAxis = "the axis has no direction"_sentence;
inline constexpr auto kSample = "a sample is [t, px, py, pz, qw, qx, qy, qz, closure] and optionally grip"_sentence;
inline constexpr auto kTimesRise = "times must rise from one to the next"_sentence;
inline constexpr auto kClosure = "closure goes from 0 (open) to 1 (closed)"_sentence;
inline constexpr auto kQuaternion = "four numbers [w, x, y, z] are needed here"_sentence;
inline constexpr auto kNoUnit = "the quaternion [w, x, y, z] is not a unit one"_sentence;
inline constexpr auto kOneAttitude = R"(give one of "q", "rpy", or "axis" with "closing")"_sentence;
inline constexpr auto kTogether = R"("axis" and "closing" are given together)"_sentence;
inline constexpr auto kTremorBand = "the lowest frequency must be below the highest"_sentence;
inline constexpr auto kSameDirection = "the axis and the closing direction must be two different directions"_sentence;

}  // namespace swage::hand::say
