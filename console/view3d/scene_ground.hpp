// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The levels on which a scene's shadows fall and its grid lies: the top of the stage below the work, and the top of tissue. Free of Qt3D.
#pragma once

#include "console/view3d/scene_parts.hpp"

namespace swage::console {

/// Adds the place of a part at the start of the scene, world, mm.
void add_bounds(const snapshot::SceneCard& card, const ScenePart& part, Bounds& bounds);
/// True for a thread that is tied to a needle: it follows the needle, which is the work.
bool only_follows(const ScenePart& part, const SceneParts& parts);

/// The stage below the work; without one a plane right below the work and any tissue. `parts` has its parts and its work.
Ground find_ground(const snapshot::SceneCard& card, const SceneParts& parts);
/// The largest level top of tissue.
Ground find_shelf(const snapshot::SceneCard& card, const SceneParts& parts);

}  // namespace swage::console
