// SPDX-License-Identifier: Apache-2.0
//
// Messages of this bundle about OpenXR and its runtime. Tests refer to their names and never repeat their words.
#pragma once

#include "toolkit/sentence.hpp"

namespace swage::openxr::say {

using toolkit::operator""_sentence;

inline constexpr auto kNoLoader =
    "{} is not installed. Install the package libopenxr-loader1 (sudo apt install libopenxr-loader1) and an OpenXR runtime."_sentence;
inline constexpr auto kNoRuntime =
    "No OpenXR runtime answers. Install and start one (Monado, SteamVR), and see that it is the active one (XR_RUNTIME_JSON, or active_runtime.json in ~/.config/openxr/1)."_sentence;
inline constexpr auto kNeedsPictures =
    "The OpenXR runtime has no {}: it gives no controllers without pictures. Use one that does, Monado for instance."_sentence;
inline constexpr auto kLacks = "The OpenXR runtime has no {}. Use a newer one."_sentence;
inline constexpr auto kNotStarted = "The OpenXR runtime does not start (result {}). Is its service running, and does it see the headset?"_sentence;
inline constexpr auto kNoHeadset =
    "{} sees no headset (result {}). Switch it on and plug it in; controllers are tracked by it. The package xr-hardware has the udev rules of many (sudo apt install xr-hardware)."_sentence;
inline constexpr auto kNoSession = "{} gives no session without pictures (result {}). Does another program hold it?"_sentence;
inline constexpr auto kEnded = "The OpenXR runtime has ended."_sentence;
inline constexpr auto kRuntime = "OpenXR runtime: {}"_sentence;
inline constexpr auto kUnnamed = "without a name"_sentence;

}  // namespace swage::openxr::say
