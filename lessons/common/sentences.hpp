// SPDX-License-Identifier: Apache-2.0
//
// Messages of several lessons about missing parts of a scene. Tests refer to the constants and do not repeat the text.
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::lessons::say {

using toolkit::operator""_sentence;

inline constexpr auto kWatched = "which this lesson watches"_sentence;  // `why` of Binder::missing()
inline constexpr auto kNoObject = R"(there is no object "{}" in the scene; it has: {})"_sentence;
inline constexpr auto kNoGripper = R"("{}" cannot grip; the lesson watches the tips of a gripper)"_sentence;
inline constexpr auto kNoGrasp = R"(nothing in the scene tells about a grasp; add to "couplings" a "swage.coupling.grasp")"_sentence;
inline constexpr auto kNotTaken = R"("{}" has no body that could be taken)"_sentence;
inline constexpr auto kNoThread = R"("{}" is no thread)"_sentence;
inline constexpr auto kTwoGrippers = "two grippers are needed, not one"_sentence;
inline constexpr auto kOrdered = "the first number must be below the second"_sentence;

}  // namespace swage::lessons::say
