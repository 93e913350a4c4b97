// SPDX-License-Identifier: Apache-2.0
//
// A pointer over a view from the front.
#pragma once

#include <numbers>

#include "mouse/mouse_hand.hpp"

namespace swage::mouse {

// the viewer looks along +Y with Z up: right is +X, up is +Z, towards the viewer is -Y
inline const Quat kFrontView = toolkit::exp_rotation({0.5 * std::numbers::pi, 0, 0});

inline swage_pointer still() {
  swage_pointer p{};
  p.camera = toolkit::raw(kFrontView);
  return p;
}

}  // namespace swage::mouse
