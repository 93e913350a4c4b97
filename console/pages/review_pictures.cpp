// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/review_pictures.hpp"

#include <QVBoxLayout>
#include <cmath>

#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "console/pages/comparison.hpp"

namespace swage::console {

ReviewPictures::ReviewPictures(const ReviewedAttempt& attempt, QWidget* parent)
    : QWidget(parent), attempt_(attempt), snapshot_(std::make_unique<snapshot::Snapshot>()) {
  column_ = new QVBoxLayout(this);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(6);
  view_ = new SceneView(this);
  view_->setObjectName(QStringLiteral("review_view"));
  view_->setAccessibleName(tr("The attempt, replayed"));
  view_->set_whole_width(kWholeShape);
  view_->setMinimumWidth(kLeastPair_px);
  views_ = {view_};
  row_ = new QHBoxLayout;
  row_->setSpacing(8);
  row_->addWidget(view_, 1);
  column_->addLayout(row_, 1);
}

ReviewPictures::~ReviewPictures() = default;

void ReviewPictures::set_themes(const UiTheme& ui, const CueTheme& cues) {
  ui_ = ui;
  cues_ = cues;
  if (other_) other_->set_themes(ui, cues);
  for (SceneView* view : views_) view->set_themes(ui, cues);
}

void ReviewPictures::show_scene() {
  if (!attempt_.player()) return;
  reading_ = Reader(attempt_.player()->card());
  for (SceneView* view : views_) dress(view);
}

// The whole scene with its cues, also of a test: it is over.
void ReviewPictures::dress(SceneView* view) {
  view->set_card(attempt_.player()->card(), CameraPreset::kOrbit);
  view->look_at_knot();
  if (view == view_) return;
  view->set_cues_shown(true);
  view->set_task(tr("Replay: %1").arg(attempt_.review().title()));
}

void ReviewPictures::add_view(SceneView* view) {
  if (!attempt_.player() || views_.contains(view)) return;
  views_ += view;
  connect(view, &QObject::destroyed, this, [this, view] { views_.removeOne(view); });
  view->set_themes(ui_, cues_);
  dress(view);
  set_ghost();
  show_player(wanted_s_);
}

void ReviewPictures::remove_view(SceneView* view) {
  if (view == view_ || !views_.removeOne(view)) return;
  disconnect(view, nullptr, this, nullptr);
  view->set_hold(0);
  view->set_card({});
  view->set_texts({}, {});
  view->set_task({});
}

bool ReviewPictures::toward(double wanted_s, uint64_t most) {
  bool there = true;
  wanted_s_ = wanted_s;
  if (Player* player = attempt_.player()) {
    there = player->toward(static_cast<uint64_t>(std::llround(wanted_s / attempt_.review().dt_s)), most);
    show_player(wanted_s);
  }
  if (comparing()) there = other_->toward(wanted_s, most) && there;
  move_ghost();
  return there;
}

void ReviewPictures::show_player(double wanted_s) {
  const Player& player = *attempt_.player();
  player.fill(*snapshot_);
  const Reading reading = reading_.read(*snapshot_);
  Q_EMIT cues_on(reading.meanings);
  QString clock = replay_clock(snapshot_->time_s, wanted_s);
  if (!reading.phase.isEmpty()) clock = QStringLiteral("%1  %2").arg(said(reading.phase), clock);
  for (SceneView* view : views_) {
    view->show_snapshot(*snapshot_);
    view->set_hold(reading.hold.value_or(0));
    view->set_texts(clock, {});
  }
  const uint64_t first = player.first_difference();
  if (first < player.count()) Q_EMIT differs(static_cast<double>(first) * attempt_.review().dt_s);
}

QString ReviewPictures::compare(const QString& attempt_id) {
  record::AttemptRow row;
  record::Recording recording;
  const std::string id = attempt_id.toStdString();
  if (const QString why = attempt_.read_other(id, row, recording); !why.isEmpty()) return why;
  if (!other_) {
    other_ = new Comparison(this);
    other_->set_themes(ui_, cues_);
    column_->insertWidget(0, other_->head());
    row_->addWidget(other_, 1);
    connect(other_, &Comparison::aligned, this, [this] {
      if (!comparing()) return;
      set_ghost();
      Q_EMIT aligned();
    });
    connect(other_, &Comparison::ghost_changed, this, &ReviewPictures::set_ghost);
    connect(other_, &Comparison::closed, this, &ReviewPictures::end_comparison);
  }
  other_->set_attempt(attempt_.review(), row, std::move(recording), attempt_.store()->events(id), attempt_.opener());
  other_->show();
  other_->head()->show();
  set_ghost();
  return {};
}

// Shows the other attempt's instruments in this one's picture, on the shifted clock.
void ReviewPictures::set_ghost() {
  const bool wanted = attempt_.player() && comparing() && other_->ghost_wanted();
  for (SceneView* view : views_) view->set_ghost(wanted ? &other_->player()->card() : nullptr, wanted ? other_->ghost_name() : QString());
  move_ghost();
}

void ReviewPictures::move_ghost() {
  if (!comparing() || !other_->ghost_wanted()) return;
  for (SceneView* view : views_) view->show_ghost(other_->X_WB());
}

void ReviewPictures::toggle_ghost() {
  if (comparing()) other_->toggle_ghost();
}

void ReviewPictures::end_comparison() {
  if (!comparing()) return;
  other_->hide();
  other_->head()->hide();
  set_ghost();
  Q_EMIT ended();
}

bool ReviewPictures::comparing() const { return other_ && !other_->isHidden(); }

void ReviewPictures::look(CameraPreset preset) {
  const auto show = [preset](SceneView* view) { preset == CameraPreset::kNear ? view->look_close() : view->look(preset); };
  for (SceneView* view : views_) show(view);
  if (comparing()) show(other_->view());
}

}  // namespace swage::console
