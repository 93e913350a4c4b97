// SPDX-License-Identifier: Apache-2.0
//
// The law by which the scene's forces come back to a hand.
#pragma once

#include "host/hand_shaping.hpp"

namespace swage::step {

/// Size at the hand, N, for a force of `f` >= 0 N in the scene, before the force scale. Monotone, 0 at 0. [rt]
double felt_force(const host::Reaction& reaction, double f) noexcept;

}  // namespace swage::step
