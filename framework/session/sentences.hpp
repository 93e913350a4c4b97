// SPDX-License-Identifier: Apache-2.0
//
// Messages of this room about devices, running scenes and ended attempts. Tests refer to their names and never repeat their words.
#pragma once

#include "base/sentence.hpp"

namespace swage::session::say {

using base::operator""_sentence;

// a running scene
inline constexpr auto kNotLive = "\"{}\" of {} cannot change while the scene runs. {}"_sentence;
inline constexpr auto kLiveNothing = "Nothing of it can."_sentence;
inline constexpr auto kLiveAre = "What can: {}."_sentence;

// hands and devices
inline constexpr auto kNoHand = "This lesson has no hand called \"{}\"."_sentence;
inline constexpr auto kOwnClock = "{} is a live device and has a clock of its own."_sentence;
inline constexpr auto kNotOpened = "{} could not be opened."_sentence;
inline constexpr auto kLeftBehind = "The device ({} {}) has not come back from {}() for {} s and is left behind. Restart the program before you use it again."_sentence;
inline constexpr auto kWithoutClock =
    "{} is a live device with a clock of its own: a scene without a clock would run away from it. Run in real time, or choose a scripted hand."_sentence;
inline constexpr auto kNoForces = "{} runs in the step and gets no forces in real time: nobody could release the hand if the step hung."_sentence;
inline constexpr auto kManySignals = "What it tells of itself is not shown: a scene has {} signals at most."_sentence;
inline constexpr auto kNobody = "There is nothing of this name in the scene."_sentence;
inline constexpr auto kFileNotKept =
    "This file is not kept with the attempt: it cannot be read, or the files of this lesson are more than 16 MiB. Replaying it needs the file at its place."_sentence;

inline constexpr auto kRecordedWith = "Recorded with {} {}, replayed with {} {}."_sentence;  // plugin, version; plugin, version

// the pull test of a knot
inline constexpr auto kNoKnot = "There is no knot here that can be read for certain: nothing is pulled."_sentence;
inline constexpr auto kNoRoom = "The loop of the knot has no room for the two pins that draw it apart, 0.3 mm thick and 0.5 mm from each other."_sentence;
inline constexpr auto kNotPulled = "The knot was not pulled: {}"_sentence;  // a sentence
inline constexpr auto kFinerAndCut = "A thread that has been cut and has a part with finer segments cannot be copied."_sentence;

// registration of an arm
inline constexpr auto kFewPoints = "A registration needs three points, and four to be checked; there are {}."_sentence;
inline constexpr auto kPointNoNumber = "A point of the registration is not a number."_sentence;
inline constexpr auto kOneLine = "The points lie in one place or one line, {} wide; {} are needed. Does the arm say where its tip is?"_sentence;
inline constexpr auto kPointOff = "One point is {} off the others; {} are allowed. Was the arm moved meanwhile, or the tip led to another mark?"_sentence;

// the record of an attempt
inline constexpr auto kNotRecorded = "step {} was not recorded"_sentence;
inline constexpr auto kQuarantined = "a plugin was in quarantine from step {} on"_sentence;
inline constexpr auto kPressed =
    "Two surfaces pressed on each other with {}, more than any hand can ({}): the attempt is void. A stiffness, a density or the rate of this lesson does not fit its scene."_sentence;
inline constexpr auto kTooSlow =
    "The attempt ran at {} % of real speed, because the machine could not keep up: {} s were left out. Its times and speeds are not those of the hand."_sentence;
inline constexpr auto kTooSlowBy =
    "The attempt ran at {} % of real speed, because {} held the steps up: {} s were left out. Its times and speeds are not those of the hand."_sentence;
inline constexpr auto kForcesOff =
    "For {} s of this attempt no force was given: the force guard had switched off after a fault. Pause and resume to switch it on again."_sentence;
inline constexpr auto kNotDrawn =
    "{} pictures lack what {} draws on \"{}\": the {} of its primitive {} ({}) makes no sense. The validator says more (\"swage validate\")."_sentence;
inline constexpr auto kHung =
    "step {} has not come back for half a second: {}. The attempt was saved. Start in safe mode to leave out every plugin that did not come with Swage."_sentence;
inline constexpr auto kEndedUntold =
    "The last run ended without a word: somebody ended the program, or a plugin did. Plugins that did not come with Swage took part: {}. What was recorded until then is safe."_sentence;
inline constexpr auto kEndedOutside = "The last run ended badly ({}) outside of any plugin."_sentence;
inline constexpr auto kEndedInPlugin =
    "The last run ended badly ({}) in {}() of \"{}\" ({}) at step {}. What was recorded until then is safe. Start in safe mode to leave out every plugin that did not come with Swage."_sentence;

}  // namespace swage::session::say
