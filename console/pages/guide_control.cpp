// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/guide_control.hpp"

#include <utility>

#include "console/models/said.hpp"

namespace swage::console {

void GuideControl::begin(const session::Options& like, bool wanted) {
  end();
  like_ = like;
  told_ = false;
  if (!expert_ || !wanted || like.mode == "demo") return;
  base::Problems problems;
  if (auto expert = expert_(like, problems)) {
    guide_ = std::make_unique<Guide>(std::move(expert));
    return;
  }
  for (const base::Problem& p : problems) {
    if (p.severity != base::Severity::kError) continue;
    Q_EMIT noted(0, tr("No guide"), said_message(p.message));
    return;
  }
}

void GuideControl::end() {
  if (!guide_) return;
  for (SceneView* view : views_) view->set_ghost(nullptr);
  guide_.reset();
}

void GuideControl::show() {
  for (SceneView* view : views_) show_in(view);
}

void GuideControl::show_in(SceneView* view) const { view->set_ghost(guide_ ? &guide_->card() : nullptr, tr("Expert")); }

void GuideControl::move(const snapshot::Snapshot* shown) {
  if (!guide_ || !shown) return;
  const std::vector<swage_pose>& X_WB = guide_->beside(*shown);
  for (SceneView* view : views_) view->show_ghost(X_WB);
  if (!guide_->failed() || std::exchange(told_, true)) return;
  Q_EMIT noted(shown->time_s, tr("No guide"), tr("The scripted expert does not pass this lesson as it is set."));
}

void GuideControl::toggle(bool wanted, const snapshot::Snapshot* shown) {
  wanted ? begin(session::Options(like_), true) : end();
  show();
  move(shown);
}

}  // namespace swage::console
