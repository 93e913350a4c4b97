// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/ghost_tools.hpp"

#include <algorithm>
#include <cstring>

#include "console/models/said.hpp"

namespace swage::console {

std::vector<GhostTips> ghost_tips(const snapshot::SceneCard& card, const SceneParts& parts, const QString& name) {
  std::vector<GhostTips> out;
  const bool several = parts.tips_of.size() > 1;
  for (const auto& [object, tips] : parts.tips_of)
    out.push_back({several ? QStringLiteral("%1: %2").arg(name, said_id(card.objects[object].name)) : name, tips});
  return out;
}

void GhostTools::set(const snapshot::SceneCard& card, const QString& name, const UiTheme& ui) {
  drop();
  there_ = true;
  const SceneParts parts = make_parts(card);
  tips_ = ghost_tips(card, parts, name);
  for (const ScenePart& part : parts.part) {
    if (!renderer_ || part.role != Role::kTool || part.in_world()) continue;
    const int added = renderer_->add_part(part.mesh, {ui["ghost"], 0, 0, Finish::kGhost}, {});
    renderer_->set_visible(added, false);
    part_.push_back({added, part.body});
  }
}

void GhostTools::drop() {
  if (renderer_ && !part_.empty()) renderer_->drop_from(part_.front().first);
  forget();
}

void GhostTools::forget() { *this = GhostTools(renderer_); }

void GhostTools::colour(const UiTheme& ui) {
  for (const auto& [part, body] : part_) renderer_->set_surface(part, {ui["ghost"], 0, 0, Finish::kGhost});
}

bool GhostTools::show(std::span<const swage_pose> X_WB) {
  if (!there_) return false;
  const bool was = std::exchange(shown_, !X_WB.empty());
  const auto same = [](const swage_pose& a, const swage_pose& b) { return std::memcmp(&a, &b, sizeof a) == 0; };
  if (was == shown_ && std::ranges::equal(X_WB, X_WB_, same)) return false;
  X_WB_.assign(X_WB.begin(), X_WB.end());
  for (const auto& [part, body] : part_) {
    const bool seen = body < X_WB.size();
    renderer_->set_visible(part, seen);
    if (!seen) continue;
    QMatrix4x4 m;
    m.translate(to_mm(X_WB[body].p));
    m.rotate(to_qt(X_WB[body].q));
    renderer_->set_pose(part, m);
  }
  return true;
}

// State is not told by colour alone: the owner's name stands beside the instruments.
void GhostTools::paint(Overlay& overlay, const Eye& eye, const QSizeF& size) const {
  if (!shown()) return;
  for (const auto& [words, tips] : tips_) {
    QVector3D middle;
    float n = 0;
    for (const Spot& tip : tips) {
      if (tip.body >= X_WB_.size()) continue;
      const swage_pose& X = X_WB_[tip.body];
      middle += to_mm(X.p) + to_qt(X.q).rotatedVector(tip.p_B);
      n += 1;
    }
    if (n > 0) overlay.ghost(eye.project(middle / n, size), words);
  }
}

}  // namespace swage::console
