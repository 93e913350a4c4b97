// SPDX-License-Identifier: Apache-2.0
//
// Sentences about a scene at its first step. Tests use the constants, and never repeat their words.
#pragma once

#include "base/sentence.hpp"

namespace swage::step::say {

using base::operator""_sentence;

inline constexpr auto kStartsInside =
    "\"{}\" starts {} mm inside \"{}\": they will be pushed apart, and what is light is thrown. Move one of them in the lesson file "
    "(pose)."_sentence;

}  // namespace swage::step::say
