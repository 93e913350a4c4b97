// SPDX-License-Identifier: Apache-2.0
//
// Sentences of this room about files. Tests use the constants, and never repeat their words.
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::toolkit::say {

inline constexpr auto kNoFile = "There is no such file."_sentence;
inline constexpr auto kFolder = "It is a folder, not a file."_sentence;
inline constexpr auto kPipe = "It is a pipe or a device, not a file."_sentence;
inline constexpr auto kTooLarge = "It is larger than {}."_sentence;  // 4 MiB, 5 bytes
inline constexpr auto kUnreadable = "It cannot be read: {}."_sentence;

}  // namespace swage::toolkit::say
