// SPDX-License-Identifier: Apache-2.0
//
// Messages of this bundle about spacenavd. Tests refer to their names and never repeat their words.
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::spacemouse::say {

using toolkit::operator""_sentence;

inline constexpr auto kNoDaemon =
    "spacenavd does not answer at {}. Install and start it (sudo apt install spacenavd; sudo systemctl enable --now spacenavd), and plug the 3D mouse in."_sentence;
inline constexpr auto kMayNotOpen = "{} may not be opened. Ask who runs spacenavd on this machine to let you."_sentence;
inline constexpr auto kLongName = "{} is too long for the name of a socket."_sentence;
inline constexpr auto kNoSocket = "There is no socket to be had: {}."_sentence;

}  // namespace swage::spacemouse::say
