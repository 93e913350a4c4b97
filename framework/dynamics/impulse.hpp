// SPDX-License-Identifier: Apache-2.0
//
// The impulse response of thesis 4.3, equations 4.37 to 4.43: one contact after the other, along the normal, without
// friction and without a memory. Kept for comparison.
#pragma once

#include "contact/contact_set.hpp"
#include "dynamics/motion.hpp"
#include "scene/world.hpp"

namespace swage::dynamics {

/// Changes the twists of dynamic bodies, hinges and particles that overlap and approach; poses stay as predicted. [rt]
void respond_by_impulses(scene::World& world, Motion& motion, contact::ContactSet& contacts) noexcept;

}  // namespace swage::dynamics
