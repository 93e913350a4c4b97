// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How obliquely open jaws stand to the wire between them, and which key turns them across it. Free of Qt3D.
#pragma once

#include <QQuaternion>
#include <QVector3D>
#include <optional>
#include <span>
#include <vector>

#include "console/view3d/scene_parts.hpp"

namespace swage::console {

struct JawAngle {
  QVector3D at;       // mm, world: the middle between the tips
  QVector3D closing;  // unit: from one jaw to the other
  QVector3D wire;     // unit: along the wire, where it is nearest to the tips
  QVector3D faces;    // unit: the direction in the jaws' faces that is nearest to the wire's
  float angle = 0;    // rad, 0..pi/2, between the wire and the faces: 0 across the wire
};

/// Jaws within this angle of the wire count as across it, rad (10 deg). From 15 deg on jaws that close on a needle in tissue turn it enough to
/// widen its wound, unless the hand gives way.
inline constexpr float kAcross = 0.1745F;

/// The angle of open jaws to the wire nearest to their tips. `tips`: places of both jaws (SceneParts::tips). No value where no wire is within
/// 1.5 mm of the tips, the jaws are closed, or there are not two of them.
std::optional<JawAngle> jaw_angle(const snapshot::SceneCard& card, const SceneParts& parts, std::span<const swage_pose> X_WB,
                                  std::span<const Spot> tips);

/// A turn of the jaws about an axis of the view.
struct JawTurn {
  int key = 0;      // Qt::Key of the instrument: Z, X, or an arrow
  float angle = 0;  // rad, above 0
};

/// The smallest turn by one key after which the jaws stand across the wire; no value where they do. `q_WC`: of the view, +z towards the viewer.
std::optional<JawTurn> jaw_turn(const JawAngle& jaws, const QQuaternion& q_WC);

}  // namespace swage::console
