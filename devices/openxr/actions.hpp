// SPDX-License-Identifier: Apache-2.0
//
// What a controller of either hand is asked for, and where each kind of controller has it. [main or io], one thread at a time
#pragma once

#include "xr.hpp"

namespace swage::openxr {

inline constexpr int kSides = 2;    // 0 left, 1 right
inline constexpr int kButtons = 2;  // bits of swage_sample.buttons

struct Actions {
  XrActionSet set = XR_NULL_HANDLE;
  XrAction aim = XR_NULL_HANDLE, trigger = XR_NULL_HANDLE, button[kButtons] = {};
  XrPath side[kSides] = {};
  XrSpace space[kSides] = {};  // of the aim pose
};

/// Makes them and attaches them to the session. The first result that is no success.
XrResult make_actions(const Xr& xr, XrInstance instance, XrSession session, Actions& out);

}  // namespace swage::openxr
