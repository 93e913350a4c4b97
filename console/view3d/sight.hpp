// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Tests whether a fixed object hides a place from a viewer. Free of Qt3D.
#pragma once

#include <QVector3D>
#include <span>

#include "console/view3d/scene_parts.hpp"

namespace swage::console {

/// Whether the box of a fixed or soft part lies between a place and a distant viewer. `at`: mm, world; `to_viewer`: unit,
/// world. Boxes are aligned with the parts' own frames; tools, wires, which leave their boxes nearly empty, threads and marks are ignored.
bool hidden(const SceneParts& parts, std::span<const swage_pose> X_WB, const QVector3D& at, const QVector3D& to_viewer);

/// The point of a tissue's box that is nearest to a place; the place itself for an object that is no tissue. mm, world.
QVector3D on_tissue(const SceneParts& parts, std::span<const swage_pose> X_WB, uint32_t object, const QVector3D& at);

}  // namespace swage::console
