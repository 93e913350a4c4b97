// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The circle of the needle at the tips, about whose axis the hand rotates to drive it. Free of Qt3D.
#pragma once

#include <QVector3D>
#include <optional>
#include <span>
#include <vector>

#include "console/view3d/scene_parts.hpp"

namespace swage::console {

struct NeedleCircle {
  QVector3D centre;  // mm, world
  QVector3D axis;    // unit; a right-handed rotation about it moves the needle point first
  float radius = 0;  // mm
};

/// The mirror image in the plane x = 0, for a lesson for the left hand, which is computed mirrored.
inline NeedleCircle mirrored(const NeedleCircle& c) {
  return {{-c.centre.x(), c.centre.y(), c.centre.z()}, {c.axis.x(), -c.axis.y(), -c.axis.z()}, c.radius};
}

/// How far behind the tips a needle may be held, mm: jaws are 4 to 6 mm long, and one that is held deep must be driven as well. With
/// 1 mm a needle held in the middle of the jaws did not move, and nothing said why.
inline constexpr float kHeldReach_mm = 3;

/// Centre lines of all bent wires that may be grasped, each once: points from the needle's point to its swage, mm, world.
std::vector<std::vector<QVector3D>> wire_lines(const snapshot::SceneCard& card, const SceneParts& parts, std::span<const swage_pose> X_WB);

/// The circle through point, middle and swage of the bent wire nearest to `tips` (mm, world), in its present pose. No value
/// where no wire is within `reach` mm, or it is straight.
std::optional<NeedleCircle> needle_circle(const snapshot::SceneCard& card, const SceneParts& parts,
                                          std::span<const swage_pose> X_WB, const QVector3D& tips,
                                          float reach = kHeldReach_mm);

}  // namespace swage::console
