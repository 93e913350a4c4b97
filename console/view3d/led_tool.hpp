// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Which of several tools that share the mouse is led now. Free of Qt3D.
#pragma once

#include "snapshot/scene_card.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::console {

/// How many instruments of the scene are led by mouse and keys; Tab hands over between them.
int mouse_hands(const snapshot::SceneCard& card);

/// The gripper that mouse and keys lead now: of hands that share a mouse only the led one has buttons, and its tool is where it is.
/// SWAGE_NONE where there is one hand, or none.
uint32_t led_tool(const snapshot::SceneCard& card, const snapshot::Snapshot& now);

}  // namespace swage::console
