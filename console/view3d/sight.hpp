// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Whether something that stands in the scene hides a place from a viewer. Free of Qt3D.
#pragma once

#include <QVector3D>
#include <span>

#include "console/view3d/scene_parts.hpp"

namespace swage::console {

/// Whether the box of a part that stands still or is soft lies between a place and a viewer far away. `at`: mm, world; `to_viewer`: unit,
/// world. Boxes are those of the parts' own frames; tools, needles, threads and marks hide nothing here.
bool hidden(const SceneParts& parts, std::span<const swage_pose> X_WB, const QVector3D& at, const QVector3D& to_viewer);

}  // namespace swage::console
