// SPDX-License-Identifier: Apache-2.0
//
// Where a scene ends. What moves freely and leaves stands still from there on, until it is put back: nothing falls for ever.
#pragma once

#include "scene/world.hpp"
#include "toolkit/math.hpp"

namespace swage::scene {

// Scene lengths from the world's origin. Normal: up to 100 (a tray). Smaller cuts scenes off; larger lets what was dropped fall
// for seconds, which nobody sees
inline constexpr double kRoomLengths = 1000;

inline double room(const World& world) { return kRoomLengths * world.length; }  // m

}  // namespace swage::scene
