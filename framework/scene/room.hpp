// SPDX-License-Identifier: Apache-2.0
//
// The border of a scene. A free body that leaves it stands still until it is put back: nothing falls for ever.
#pragma once

#include "scene/world.hpp"
#include "toolkit/math.hpp"

namespace swage::scene {

// Scene lengths from the world's origin. Normal: up to 100 (a tray). Smaller cuts scenes off; larger lets dropped bodies fall
// for seconds, out of sight
inline constexpr double kRoomLengths = 1000;

inline double room(const World& world) { return kRoomLengths * world.length; }  // m

}  // namespace swage::scene
