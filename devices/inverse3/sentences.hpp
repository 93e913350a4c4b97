// SPDX-License-Identifier: Apache-2.0
//
// Messages of this bundle about the Inverse Service and its arm. Tests refer to their names and never repeat their words.
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::inverse3::say {

using toolkit::operator""_sentence;

// failed and closed connections
inline constexpr auto kNoWebSocket = "It answers \"{}\" in place of opening a WebSocket."_sentence;
inline constexpr auto kOtherAnswer = "Its answer is not that of a WebSocket."_sentence;
inline constexpr auto kExtension = "It uses an extension that nobody asked for."_sentence;
inline constexpr auto kHostUnknown = "The host {} is not known ({})."_sentence;
inline constexpr auto kHostSilent = "{}:{} does not answer ({})."_sentence;
inline constexpr auto kSilent = "It does not answer ({})."_sentence;
inline constexpr auto kTakesNothing = "It takes nothing any more ({})."_sentence;
inline constexpr auto kHangs = "It takes nothing any more."_sentence;
inline constexpr auto kEnded = "It ended the connection."_sentence;
inline constexpr auto kBroke = "The connection broke ({})."_sentence;
inline constexpr auto kEndless = "Its answer has no end."_sentence;
inline constexpr auto kNoServerFrame = "It sends frames that no server may send."_sentence;
inline constexpr auto kNoControl = "It sends a control frame that is none."_sentence;
inline constexpr auto kHuge = "It sends a message of more than 1 MiB."_sentence;
inline constexpr auto kFrameOrder = "Its frames are out of order."_sentence;

// the service and the arm
inline constexpr auto kNoService =
    "The Inverse Service does not answer at {}: {} Install it from docs.haply.co and start it (sudo systemctl enable --now haply-inverse-service)."_sentence;
inline constexpr auto kOtherService = "{} says nothing that is of the Inverse Service. Is its port right?"_sentence;
inline constexpr auto kNoSuchArm = "There is no arm \"{}\". There is: {}."_sentence;
inline constexpr auto kNoArm = "The Inverse Service knows no arm. Switch the Inverse3 on, plug it in, and calibrate it as its maker says."_sentence;
inline constexpr auto kArm = "Inverse3 {}{}{}"_sentence;  // id, hand, stylus
inline constexpr auto kHanded = " ({}-handed)"_sentence;
inline constexpr auto kWithGrip = ", with a VerseGrip{}"_sentence;
inline constexpr auto kBattery = ", battery {} %"_sentence;
inline constexpr auto kWithoutGrip = ", without a VerseGrip: the instrument does not turn"_sentence;
inline constexpr auto kLowBattery = "The battery of the stylus is low. Charge the VerseGrip after this attempt."_sentence;

}  // namespace swage::inverse3::say
