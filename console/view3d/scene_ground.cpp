// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/scene_ground.hpp"

#include <algorithm>
#include <cmath>
#include <map>

namespace swage::console {
namespace {

constexpr float kTouch_mm = 0.05F;  // the work may begin so far inside its stage

// the largest level face of the parts that satisfy `wanted`, not above `highest`
template <class Wanted>
Ground find_level(const snapshot::SceneCard& card, const SceneParts& parts, float highest,
                  const Wanted& wanted) {
  struct Level {
    Bounds bounds;
    double area = 0;
    size_t part = 0;
  };
  std::map<long, Level> levels;  // by height, in hundredths of a millimetre
  for (size_t k = 0; k < parts.part.size(); ++k) {
    const ScenePart& part = parts.part[k];
    if (!wanted(part)) continue;
    const QQuaternion q = to_qt(card.start[part.body].q);
    const QVector3D p = to_mm(card.start[part.body].p);
    const auto at = [&](uint32_t i) {
      const float* v = part.mesh.vertex[i].p;
      return p + q.rotatedVector({v[0], v[1], v[2]});
    };
    for (size_t i = 0; i + 2 < part.mesh.index.size(); i += 3) {
      const QVector3D a = at(part.mesh.index[i]), b = at(part.mesh.index[i + 1]),
                      c = at(part.mesh.index[i + 2]);
      const QVector3D n = QVector3D::crossProduct(b - a, c - a);
      if (n.z() < 0.999F * n.length() || n.length() <= 0 || a.z() > highest) continue;
      Level& level = levels[std::lround(100 * a.z())];
      level.part = k;
      level.area += 0.5 * static_cast<double>(n.length());
      for (const QVector3D& v : {a, b, c}) level.bounds.add(v);
    }
  }
  Ground ground;
  double most = 0;
  for (const auto& [height, level] : levels) {
    if (level.area <= most) continue;
    most = level.area;
    const QVector3D size = level.bounds.high - level.bounds.low, c = level.bounds.centre();
    ground = {level.bounds.high.z(), true, level.part, {c.x(), c.y(), 0}, 0.5F * size.x(), 0.5F * size.y()};
  }
  return ground;
}

bool is_stage(const ScenePart& part) { return part.role == Role::kStage && !part.soft; }

// The level below the highest part of the work, if that part has room on it: the grid stays on a tray in whose floor another part of the work begins.
Ground below_highest(const snapshot::SceneCard& card, const SceneParts& parts) {
  Bounds highest;
  for (const ScenePart& p : parts.part) {
    Bounds own;
    if (p.role == Role::kWork && !only_follows(p, parts)) add_bounds(card, p, own);
    if (!own.empty() && (highest.empty() || own.low.z() > highest.low.z())) highest = own;
  }
  if (highest.empty()) return {};
  const Ground ground = find_level(card, parts, highest.low.z() + kTouch_mm, is_stage);
  return std::min(ground.half_x, ground.half_y) >= highest.radius() ? ground : Ground{};
}

}  // namespace

void add_bounds(const snapshot::SceneCard& card, const ScenePart& part, Bounds& bounds) {
  const swage_pose X_WB = part.in_world() ? swage_pose{{0, 0, 0}, {1, 0, 0, 0}} : card.start[part.body];
  const QQuaternion q = to_qt(X_WB.q);
  const QVector3D p = to_mm(X_WB.p);
  for (const Vertex& v : part.mesh.vertex) bounds.add(p + q.rotatedVector({v.p[0], v.p[1], v.p[2]}));
}

bool only_follows(const ScenePart& part, const SceneParts& parts) {
  if (part.thread < 0) return false;
  return std::any_of(parts.part.begin(), parts.part.end(), [](const ScenePart& p) { return p.role == Role::kWork && p.thread < 0; });
}

Ground find_ground(const snapshot::SceneCard& card, const SceneParts& parts) {
  Ground ground = find_level(card, parts, parts.work.low.z() + kTouch_mm, is_stage);
  if (!ground.on_stage) ground = below_highest(card, parts);
  if (ground.on_stage) return ground;
  Bounds all = parts.work;
  for (const ScenePart& p : parts.part) {
    if (p.soft) add_bounds(card, p, all);
  }
  return {all.low.z(), false, 0, parts.work.centre() * QVector3D(1, 1, 0), 0, 0};
}

Ground find_shelf(const snapshot::SceneCard& card, const SceneParts& parts) {
  return find_level(card, parts, 1e9F, [](const ScenePart& p) { return p.soft; });
}

}  // namespace swage::console
