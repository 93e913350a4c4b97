// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/sight.hpp"

#include <algorithm>
#include <cmath>

namespace swage::console {
namespace {

// Slab test: intersects the ranges of the ray between each pair of faces; the box is hit if they overlap.
bool meets(const Bounds& box, const QVector3D& from, const QVector3D& along) {
  float first = 0, last = 1e9F;
  for (int k = 0; k < 3; ++k) {
    if (std::abs(along[k]) < 1e-6F) {
      if (from[k] < box.low[k] || from[k] > box.high[k]) return false;
      continue;
    }
    const float a = (box.low[k] - from[k]) / along[k], b = (box.high[k] - from[k]) / along[k];
    first = std::max(first, std::min(a, b));
    last = std::min(last, std::max(a, b));
  }
  return first < last;
}

Bounds box_of(const ScenePart& part) {
  Bounds box;
  for (const Vertex& v : part.mesh.vertex) box.add({v.p[0], v.p[1], v.p[2]});
  return box;
}

}  // namespace

QVector3D on_tissue(const SceneParts& parts, std::span<const swage_pose> X_WB, uint32_t object, const QVector3D& at) {
  for (const ScenePart& part : parts.part) {
    if (part.object != object || !part.soft || part.in_world() || part.body >= X_WB.size()) continue;
    const Bounds box = box_of(part);
    if (box.empty()) continue;
    const QQuaternion q = to_qt(X_WB[part.body].q);
    const QVector3D p_W = to_mm(X_WB[part.body].p);
    QVector3D p = q.conjugated().rotatedVector(at - p_W);
    for (int k = 0; k < 3; ++k) p[k] = std::clamp(p[k], box.low[k], box.high[k]);
    return p_W + q.rotatedVector(p);
  }
  return at;
}

bool hidden(const SceneParts& parts, std::span<const swage_pose> X_WB, const QVector3D& at, const QVector3D& to_viewer) {
  return std::any_of(parts.part.begin(), parts.part.end(), [&](const ScenePart& part) {
    if ((part.role != Role::kStage && !part.soft) || part.wire || part.in_world() || part.body >= X_WB.size()) return false;
    const Bounds box = box_of(part);
    if (box.empty()) return false;
    const QQuaternion to_body = to_qt(X_WB[part.body].q).conjugated();
    return meets(box, to_body.rotatedVector(at - to_mm(X_WB[part.body].p)), to_body.rotatedVector(to_viewer));
  });
}

}  // namespace swage::console
