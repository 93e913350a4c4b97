// SPDX-License-Identifier: Apache-2.0
//
// Messages of this lesson about its objects. Tests refer to the constants and do not repeat the text.
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::lesson_free_practice::say {

using toolkit::operator""_sentence;

inline constexpr auto kThingsNamed = "one to eight names are needed"_sentence;
inline constexpr auto kFewThings = "there are not so many things"_sentence;
inline constexpr auto kGraspEach = R"("things" names {} objects, but {} "swage.coupling.grasp" tell about grasps; one for each is needed)"_sentence;

}  // namespace swage::lesson_free_practice::say
