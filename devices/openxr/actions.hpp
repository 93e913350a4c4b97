// SPDX-License-Identifier: Apache-2.0
//
// Actions of the controllers of both hands, and their bindings for each kind of controller. [main or io], one thread at a time
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

/// Creates the actions and attaches them to the session. Returns the first result that is not a success.
XrResult make_actions(const Xr& xr, XrInstance instance, XrSession session, Actions& out);

}  // namespace swage::openxr
