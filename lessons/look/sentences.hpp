// SPDX-License-Identifier: Apache-2.0
//
// Messages of this lesson about its parameter `measures`. Tests refer to the constants and do not repeat the text.
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::lesson_look::say {

using toolkit::operator""_sentence;

inline constexpr auto kThreeWords = "owner, signal and unit are needed between two commas, not more and not less: \"grasp grasp.force N, needle needle.bend rad\""_sentence;
inline constexpr auto kNamed = "which \"measures\" names"_sentence;
inline constexpr auto kOtherUnit = "\"{}\" is told in {}, not in {} as \"measures\" says"_sentence;

}  // namespace swage::lesson_look::say
