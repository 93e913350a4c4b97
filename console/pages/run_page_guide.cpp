// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Live help on the Run page: a ghost of an expert's instruments, which waits for the trainee.
#include "console/pages/run_page.hpp"

namespace swage::console {

void RunPage::set_expert(ExpertOpener open) {
  expert_ = std::move(open);
  update_cues();
}

// Before the attempt, so that its record says how it began. `like`: the lesson as it is played, with its seed.
void RunPage::begin_guide(const session::Options& like) {
  end_guide();
  guide_options_ = like;
  guide_told_ = false;
  if (!expert_ || !guided() || cues_hidden() || like.mode == "demo") return;
  base::Problems problems;
  if (auto expert = expert_(like, problems)) {
    guide_ = std::make_unique<Guide>(std::move(expert));
    return;
  }
  for (const base::Problem& p : problems) {
    if (p.severity != base::Severity::kError) continue;
    events_->note(0, tr("No guide: %1").arg(QString::fromStdString(p.message)));
    return;
  }
}

void RunPage::end_guide() {
  if (!guide_) return;
  for (SceneView* view : views_) view->set_ghost(nullptr);
  guide_.reset();
}

void RunPage::show_guide() {
  for (SceneView* view : views_) view->set_ghost(guide_ ? &guide_->card() : nullptr, tr("Expert"));
}

// beside what the views show now
void RunPage::move_guide() {
  const snapshot::Snapshot* shown = control_->shown();
  if (!guide_ || !shown) return;
  const std::vector<swage_pose>& X_WB = guide_->beside(*shown);
  for (SceneView* view : views_) view->show_ghost(X_WB);
  if (!guide_->failed() || std::exchange(guide_told_, true)) return;
  events_->note(shown->time_s, tr("No guide: the scripted expert does not pass this lesson as it is set."));
}

void RunPage::toggle_guide(bool on) {
  if (!control_->running()) return;
  on ? begin_guide(session::Options(guide_options_)) : end_guide();
  show_guide();
  move_guide();
}

}  // namespace swage::console
