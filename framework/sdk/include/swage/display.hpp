// SPDX-License-Identifier: Apache-2.0
//
// Mono or stereo view of the scene, for a lesson that judges depth or angles.
#pragma once

#include <swage/abi/display.h>

namespace swage {

/// SWAGE_EYES_* as the attempt began; known from activate on. SWAGE_EYES_NONE from a host without the extension. [any]
inline int32_t eyes(const swage_host& host) {
  const auto* display = static_cast<const swage_host_display*>(host.get_extension(&host, SWAGE_HOST_DISPLAY));
  return display != nullptr ? display->eyes(&host) : SWAGE_EYES_NONE;
}

}  // namespace swage
