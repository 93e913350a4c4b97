// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Reduces instruments to their tips: the rest would hide the work from the eye (the thesis, 1.3).
#pragma once

#include <QVector3D>

#include "console/view3d/mesh.hpp"
#include "console/view3d/scene_parts.hpp"

namespace swage::console {

/// Length of an instrument that is kept, from its tips on, mm: more than the length of a needle.
inline constexpr float kTips_mm = 8;

/// The part of a mesh on the negative side of the plane through p with normal n, closed at the cut.
Mesh cut(const Mesh& mesh, const QVector3D& p, const QVector3D& n);

/// Cuts every instrument kTips_mm behind its tips, perpendicular to the line from its tips to its middle.
void keep_tips(const snapshot::SceneCard& card, SceneParts& parts);

}  // namespace swage::console
