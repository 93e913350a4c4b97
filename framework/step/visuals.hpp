// SPDX-License-Identifier: Apache-2.0
//
// What is drawn beside shapes: asked of every object and coupling when a snapshot is filled, and never part of the state.
#pragma once

#include "host/rig.hpp"
#include "snapshot/snapshot.hpp"
#include "step/couplings.hpp"
#include "step/objects.hpp"

namespace swage::step {

/// Fills `visual`, objects first, each in the order of the lesson file; places and directions in the world. A list with a faulty
/// primitive is left out as a whole, and of a list that is too long the end; both are added to the counts in `out.health.visuals`. [rt] between steps
void fill_visuals(const host::Rig& rig, const Objects& objects, const Couplings& couplings, snapshot::Snapshot& out) noexcept;

}  // namespace swage::step
