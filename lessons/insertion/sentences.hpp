// SPDX-License-Identifier: Apache-2.0
//
// Messages of this lesson about missing parts of a scene; those of several lessons: common/sentences.hpp. Tests do not repeat the text.
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::lesson_insertion::say {

using toolkit::operator""_sentence;

inline constexpr auto kCannotPierce = R"("{}" cannot pierce)"_sentence;
inline constexpr auto kNotPierced = R"("{}" cannot be pierced)"_sentence;
inline constexpr auto kNoBodies = "needle and tissue must have bodies"_sentence;
inline constexpr auto kNoPiercing = R"(nothing in the scene tells about piercing; add to "couplings" a "swage.coupling.pierce")"_sentence;
inline constexpr auto kNoTie = R"(nothing in the scene ties the thread to a needle; add to "couplings" a "swage.coupling.swage")"_sentence;
inline constexpr auto kNoPull =
    R"(nothing in the scene draws the thread through tissue; add to "couplings" a "swage.coupling.pull_through")"_sentence;
inline constexpr auto kNoSuture = R"(a tail or loops are asked for, and "suture" names no thread)"_sentence;
inline constexpr auto kTwoEdges = R"(a bite goes through two edges in the task "stitch")"_sentence;

}  // namespace swage::lesson_insertion::say
