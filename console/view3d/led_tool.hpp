// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Selects the active tool among several that share the mouse. Free of Qt3D.
#pragma once

#include "snapshot/scene_card.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::console {

/// Number of instruments driven by mouse and keys; Tab switches between them.
int mouse_hands(const snapshot::SceneCard& card);

/// The gripper that mouse and keys drive now: of several mouse devices only the active one sends buttons.
/// SWAGE_NONE where there are fewer than two.
uint32_t led_tool(const snapshot::SceneCard& card, const snapshot::Snapshot& now);

}  // namespace swage::console
