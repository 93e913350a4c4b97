// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Of instruments only the tips: what else there is of them stands in the way of the eye (the thesis, 1.3).
#pragma once

#include <QVector3D>

#include "console/view3d/mesh.hpp"
#include "console/view3d/scene_parts.hpp"

namespace swage::console {

/// mm of an instrument that are left, from its tips on: more than a needle is long.
inline constexpr float kTips_mm = 8;

/// What lies on the side of the plane through p to which n does not point, closed where it was cut.
Mesh cut(const Mesh& mesh, const QVector3D& p, const QVector3D& n);

/// Cuts every instrument kTips_mm behind its tips, square to the way from its tips to its middle.
void keep_tips(const snapshot::SceneCard& card, SceneParts& parts);

}  // namespace swage::console
