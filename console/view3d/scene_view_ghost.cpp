// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Somebody else's instruments in the scene, seen through: an expert's beside a trainee's, or those of another attempt.
#include <algorithm>
#include <cstring>
#include <utility>

#include "console/view3d/overlay.hpp"
#include "console/view3d/scene_view.hpp"

namespace swage::console {

void SceneView::set_ghost(const snapshot::SceneCard* card, const QString& name) {
  if (ghost_ && renderer_ && !ghost_->part.empty()) renderer_->drop_from(ghost_->part.front().first);
  ghost_.reset();
  if (card) {
    ghost_ = std::make_unique<Ghost>();
    ghost_->name = name;
    const SceneParts parts = make_parts(*card);
    for (const auto& [object, tips] : parts.tips_of) ghost_->tips.push_back(tips);
    for (const ScenePart& part : parts.part) {
      if (!renderer_ || part.role != Role::kTool || part.in_world()) continue;
      const int added = renderer_->add_part(part.mesh, {ui_["ghost"], 0, 0, Finish::kGhost}, {});
      renderer_->set_visible(added, false);
      ghost_->part.push_back({added, part.body});
    }
  }
  touch();
  update();
}

void SceneView::show_ghost(std::span<const swage_pose> X_WB) {
  if (!ghost_) return;
  const bool was = std::exchange(ghost_->shown, !X_WB.empty());
  const auto same = [](const swage_pose& a, const swage_pose& b) { return std::memcmp(&a, &b, sizeof a) == 0; };
  if (was == ghost_->shown && std::ranges::equal(X_WB, ghost_->X_WB, same)) return;
  ghost_->X_WB.assign(X_WB.begin(), X_WB.end());
  for (const auto& [part, body] : ghost_->part) {
    const bool there = body < X_WB.size();
    renderer_->set_visible(part, there);
    if (!there) continue;
    QMatrix4x4 m;
    m.translate(to_mm(X_WB[body].p));
    m.rotate(to_qt(X_WB[body].q));
    renderer_->set_pose(part, m);
  }
  touch();
}

// No state by colour alone: whose instruments these are stands beside them.
void SceneView::paint_ghost(Overlay& overlay, const Panel& panel) const {
  if (!ghost_shown()) return;
  for (const std::vector<Spot>& tips : ghost_->tips) {
    QVector3D middle;
    float n = 0;
    for (const Spot& tip : tips) {
      if (tip.body >= ghost_->X_WB.size()) continue;
      const swage_pose& X = ghost_->X_WB[tip.body];
      middle += to_mm(X.p) + to_qt(X.q).rotatedVector(tip.p_B);
      n += 1;
    }
    if (n > 0) overlay.ghost(panel.view.eye.project(middle / n, panel.size), ghost_->name);
  }
}

}  // namespace swage::console
