// SPDX-License-Identifier: Apache-2.0
//
// Messages of this bundle about its plan and its wrist; those about numbers and files are in hand/sentences.hpp. Tests refer to names only.
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::skilled::say {

using toolkit::operator""_sentence;

// a plan
inline constexpr auto kPlanHas = "a plan has format, title, doc, start, acts"_sentence;
inline constexpr auto kPlanNeeds = R"(a plan needs "start", a pose, and "acts", a list of at least one)"_sentence;
inline constexpr auto kStart = "a start has p, axis, closing and closure"_sentence;
inline constexpr auto kAct = R"(an act is an object like {"act": "wait"})"_sentence;
inline constexpr auto kNoAct = R"(there is no act "{}"; there is: {})"_sentence;
inline constexpr auto kUnknownKey = "unknown here; this act has: {}"_sentence;
inline constexpr auto kMissing = R"("{}" is missing)"_sentence;

// an act
inline constexpr auto kNameNeeded = "a name is needed here"_sentence;
inline constexpr auto kFlagNeeded = "true or false is needed here"_sentence;
inline constexpr auto kMarksNeeded = "a list of marks is needed here"_sentence;
inline constexpr auto kNoDirection = "the direction has no length"_sentence;
inline constexpr auto kTakesTime = "an act takes some time"_sentence;
inline constexpr auto kPlaceOnNeedle = "s goes from 0 (point) to 1 (swage)"_sentence;
inline constexpr auto kAwaited = R"(what is awaited is "of", "signal" and "more" or "less", or "mark", "s" and "near")"_sentence;
inline constexpr auto kDrawn = R"(a thread is kept drawn by "of", "signal", "more", "less" and "by" together)"_sentence;
inline constexpr auto kGoesOn = R"(it goes on there while "of", "signal" and "more" or "less" say so together)"_sentence;
inline constexpr auto kWayOrPlace = R"(give "by", a way, or "at", a place)"_sentence;
inline constexpr auto kRollOrTurn = R"(give "roll", or "axis" and "closing")"_sentence;
inline constexpr auto kFromOrKeep = R"(give "from", the side from which it comes, or "keep", its attitude)"_sentence;
inline constexpr auto kEarlierAct = "the number of an act before this one, or of any other where it asks for a signal"_sentence;
inline constexpr auto kWithWhat = R"("needle" or "jaws" is needed here)"_sentence;

// the scene
inline constexpr auto kNoObject = R"(there is no object "{}" (parameter {}))"_sentence;
inline constexpr auto kNotGraspable = R"("{}" is not graspable)"_sentence;
inline constexpr auto kNoForce = R"(there is no signal "grasp.force" of "{}" (parameter grasp))"_sentence;
inline constexpr auto kNoHole = R"(nothing here has a signal "pierce.s" by which to see where the needle goes in (parameter steady))"_sentence;
inline constexpr auto kClosesToForce = R"({} closes to a force, but nothing here has a signal "grasp.force"; add a swage.coupling.grasp)"_sentence;
inline constexpr auto kNoThread = R"({} reaches for a place of a thread, but "{}" is none)"_sentence;
inline constexpr auto kDrawsToNothing = "{} draws up to a signal above 0"_sentence;
inline constexpr auto kNoPoint = R"({} looks for the point "{}", which this lesson does not show)"_sentence;
inline constexpr auto kWindsAbout = " winds about "_sentence;
inline constexpr auto kJudges = " judges "_sentence;
inline constexpr auto kAimsInto = " aims into "_sentence;
inline constexpr auto kNotThere = R"({}{}"{}", which is not there)"_sentence;  // act, relation, object
inline constexpr auto kNoTips = R"({}{}"{}", which has no tips)"_sentence;
inline constexpr auto kNotPierced = R"({}: "{}" cannot be pierced)"_sentence;
inline constexpr auto kNotTold = R"({} waits for "{}" of "{}", which nobody tells here)"_sentence;

// the hand
inline constexpr auto kForearm = "the forearm needs a horizontal direction"_sentence;
inline constexpr auto kRange = "the range must reach to both sides of 0"_sentence;

}  // namespace swage::skilled::say
