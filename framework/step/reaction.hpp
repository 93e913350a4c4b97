// SPDX-License-Identifier: Apache-2.0
//
// The law that maps forces in the scene to forces at a hand.
#pragma once

#include "host/hand_shaping.hpp"

namespace swage::step {

/// Force at the hand [N] for a force of `f` >= 0 N in the scene, before the force scale. Monotone, 0 at 0. [rt]
double felt_force(const host::Reaction& reaction, double f) noexcept;

}  // namespace swage::step
