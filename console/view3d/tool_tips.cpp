// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/tool_tips.hpp"

#include <array>
#include <utility>
#include <vector>

namespace swage::console {
namespace {

QVector3D place(const Vertex& v) { return {v.p[0], v.p[1], v.p[2]}; }

// the vertex where an edge meets the plane, at the fraction `u` of the edge
Vertex between(const Vertex& a, const Vertex& b, float u) {
  Vertex out = a;
  for (int i = 0; i < 3; ++i) {
    out.p[i] += u * (b.p[i] - a.p[i]);
    out.n[i] += u * (b.n[i] - a.n[i]);
  }
  return out;
}

// Closes the cut with faces on both sides, as the outline may run either way round.
void close(Mesh& mesh, const std::vector<std::pair<QVector3D, QVector3D>>& outline, const QVector3D& n) {
  QVector3D middle;
  for (const auto& [a, b] : outline) middle += (a + b) / (2.F * static_cast<float>(outline.size()));
  const auto add = [&](const QVector3D& p, const QVector3D& facing) {
    mesh.index.push_back(static_cast<uint32_t>(mesh.vertex.size()));
    mesh.vertex.push_back({{p.x(), p.y(), p.z()}, {facing.x(), facing.y(), facing.z()}});
  };
  for (const auto& [a, b] : outline) {
    for (const QVector3D& p : {middle, a, b}) add(p, n);
    for (const QVector3D& p : {middle, b, a}) add(p, n);
  }
}

}  // namespace

Mesh cut(const Mesh& mesh, const QVector3D& p, const QVector3D& n) {
  Mesh out;
  std::vector<std::pair<QVector3D, QVector3D>> outline;
  for (size_t i = 0; i + 2 < mesh.index.size(); i += 3) {
    std::vector<Vertex> kept;
    std::vector<QVector3D> on;
    for (size_t k = 0; k < 3; ++k) {
      const Vertex &a = mesh.vertex[mesh.index[i + k]], &b = mesh.vertex[mesh.index[i + (k + 1) % 3]];
      const float da = QVector3D::dotProduct(place(a) - p, n), db = QVector3D::dotProduct(place(b) - p, n);
      if (da <= 0) kept.push_back(a);
      if ((da <= 0) == (db <= 0)) continue;
      kept.push_back(between(a, b, da / (da - db)));
      on.push_back(place(kept.back()));
    }
    if (on.size() == 2) outline.push_back({on[0], on[1]});
    for (size_t k = 1; k + 1 < kept.size(); ++k)
      for (const Vertex& v : {kept[0], kept[k], kept[k + 1]}) {
        out.index.push_back(static_cast<uint32_t>(out.vertex.size()));
        out.vertex.push_back(v);
      }
  }
  if (!outline.empty()) close(out, outline, n);
  return out;
}

void keep_tips(const snapshot::SceneCard& card, SceneParts& parts) {
  const auto in_world = [&](const Spot& spot) { return to_mm(card.start[spot.body].p) + to_qt(card.start[spot.body].q).rotatedVector(spot.p_B); };
  for (const auto& [object, tips] : parts.tips_of) {
    if (tips.empty()) continue;
    QVector3D tip, middle;
    float n = 0;
    for (const Spot& spot : tips) tip += in_world(spot) / static_cast<float>(tips.size());
    for (const ScenePart& part : parts.part) {
      if (part.role != Role::kTool || part.object != object || part.in_world()) continue;
      for (const Vertex& v : part.mesh.vertex) middle += in_world({part.body, place(v)}), n += 1;
    }
    if (n <= 0) continue;
    const QVector3D back = (middle / n - tip).normalized();
    for (ScenePart& part : parts.part) {
      if (part.role != Role::kTool || part.object != object || part.in_world()) continue;
      const QQuaternion q = to_qt(card.start[part.body].q).conjugated();
      part.mesh = cut(part.mesh, q.rotatedVector(tip + kTips_mm * back - to_mm(card.start[part.body].p)), q.rotatedVector(back));
    }
  }
}

}  // namespace swage::console
