// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The circle of the needle at the tips: what a hand turns about to drive it in. Free of Qt3D.
#pragma once

#include <QVector3D>
#include <optional>
#include <span>

#include "console/view3d/scene_parts.hpp"

namespace swage::console {

struct NeedleCircle {
  QVector3D centre;  // mm, world
  QVector3D axis;    // unit; right-handed about it the point goes first
  float radius = 0;  // mm
};

/// The mirror image in the plane x = 0, in which a lesson for the left hand is computed.
inline NeedleCircle mirrored(const NeedleCircle& c) {
  return {{-c.centre.x(), c.centre.y(), c.centre.z()}, {c.axis.x(), -c.axis.y(), -c.axis.z()}, c.radius};
}

/// Through the point, the middle and the swage of the bent wire that is nearest to `tips` (mm, world), as it stands now. Nothing
/// where no wire is within `reach` mm, or it is straight.
std::optional<NeedleCircle> needle_circle(const snapshot::SceneCard& card, const SceneParts& parts,
                                          std::span<const swage_pose> X_WB, const QVector3D& tips,
                                          float reach = 1);

}  // namespace swage::console
