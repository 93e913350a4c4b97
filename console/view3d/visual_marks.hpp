// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Lines, discs and tubes that plugins draw on objects (swage.visual/1), as triangles. Free of Qt3D.
#pragma once

#include <span>

#include "console/view3d/mesh.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::console {

/// Adds them to the meshes of their tones (SWAGE_TONE_*), world, mm. False where there are none.
bool append_marks(const snapshot::Snapshot& s, double mm_per_pixel, std::span<Mesh* const, SWAGE_TONES> by_tone);

}  // namespace swage::console
