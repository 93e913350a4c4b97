// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/comparison.hpp"

#include <QHBoxLayout>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kTitle = 3, kAlign = 2;  // shares of the row: a name, a date and a verdict are longer than an event
constexpr int kAlignLetters = 10;      // of an event, at least

}  // namespace

QVector<CommonEvent> common_events(const Review& first, const Review& other) {
  QVector<CommonEvent> out;
  const auto of = [](const QVector<Moment>& moments, const QString& id) {
    return std::find_if(moments.begin(), moments.end(), [&](const Moment& m) { return m.id == id && !m.by_person; });
  };
  for (const Moment& m : first.moments) {
    if (m.by_person || m.technical || m.id.isEmpty()) continue;
    if (std::any_of(out.begin(), out.end(), [&](const CommonEvent& e) { return e.id == m.id; })) continue;
    const auto found = of(other.moments, m.id);
    if (found != other.moments.end()) out += {m.id, m.what, m.time_s, found->time_s};
  }
  return out;
}

Comparison::Comparison(QWidget* parent) : QWidget(parent), snapshot_(std::make_unique<snapshot::Snapshot>()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  make_head();
  view_ = new SceneView(this);
  view_->setObjectName(QStringLiteral("other_view"));
  view_->setAccessibleName(tr("The other attempt, replayed"));
  view_->set_whole_width(kWholeShape);
  view_->setMinimumWidth(kLeastPair_px);
  column->addWidget(view_, 1);
  problem_ = make_muted({}, this);
  problem_->setObjectName(QStringLiteral("other_problem"));
  problem_->hide();
  column->addWidget(problem_);
}

void Comparison::make_head() {
  head_ = new QWidget(parentWidget());
  auto* row = new QHBoxLayout(head_);
  row->setContentsMargins(0, 0, 0, 0);
  title_ = new ElidedLabel(head_, 2);  // two lines are as high as the controls beside them
  title_->setObjectName(QStringLiteral("other_title"));
  row->addWidget(title_, kTitle);
  auto* label = make_muted(tr("Align"), head_);
  label->setWordWrap(false);
  row->addWidget(label);
  align_ = new QComboBox(head_);
  align_->setObjectName(QStringLiteral("align"));
  align_->setAccessibleName(tr("Align the attempts at"));
  align_->setToolTip(tr("What lies at the same place of the timeline in both attempts"));
  align_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  align_->setMinimumContentsLength(kAlignLetters);
  label->setBuddy(align_);
  row->addWidget(align_, kAlign);
  ghost_ = new QCheckBox(tr("Ghost"), head_);
  ghost_->setObjectName(QStringLiteral("ghost"));
  ghost_->setChecked(true);
  ghost_->setToolTip(tr("Show these instruments in the other picture, too, seen through (G)"));
  row->addWidget(ghost_);
  auto* close = make_button(QStringLiteral("✕"), {}, QStringLiteral("close_comparison"), head_);
  close->setAccessibleName(tr("End the comparison"));
  close->setToolTip(tr("End the comparison (Esc)"));
  row->addWidget(close);
  connect(align_, &QComboBox::currentIndexChanged, this, &Comparison::aligned);
  connect(ghost_, &QCheckBox::toggled, this, &Comparison::ghost_changed);
  connect(close, &QPushButton::clicked, this, &Comparison::closed);
}

// the player refers to the recording
Comparison::~Comparison() { player_.reset(); }

void Comparison::set_themes(const UiTheme& ui, const CueTheme& cues) { view_->set_themes(ui, cues); }

void Comparison::set_attempt(const Review& first, const record::AttemptRow& row, record::Recording recording,
                             const std::vector<record::EventRow>& events, const PlayerOpener& opener) {
  player_.reset();
  recording_ = std::move(recording);
  base::Problems problems;
  if (opener) player_ = opener(recording_, problems);
  review_ = make_review(row, recording_, events, player_ ? &player_->card() : nullptr);
  const QString person = person_text(QString::fromStdString(row.person_name));
  const bool same = row.person_id == first.attempt.person_id;
  ghost_name_ = !review_.hand.isEmpty() ? review_.hand : same ? tr("Other attempt") : person;
  const QString who = review_.hand.isEmpty() ? person : tr("%1, %2").arg(person, review_.hand);
  // the row stands above both pictures; where two lines have no room for all, the date goes first, and the verdict stays
  title_->setText(tr("Right: %1; %2, %3").arg(review_.verdict(), who, when_text(QString::fromStdString(row.started_utc))));
  problem_->setVisible(!player_);
  if (player_) {
    view_->set_card(player_->card(), CameraPreset::kOrbit);
    view_->look_at_knot();
  } else {
    problem_->setText(tr("The picture cannot be replayed: %1")
                          .arg(problems.empty() ? QString() : said_message(problems.front().message)));
  }
  fill_events(first);
}

void Comparison::fill_events(const Review& first) {
  {
    const QSignalBlocker quiet(align_);
    align_->clear();
    align_->addItem(tr("Start"), 0.0);
    for (const CommonEvent& e : common_events(first, review_)) align_->addItem(e.what, e.other_s - e.first_s);
    align_->addItem(tr("End"), review_.length_s - first.length_s);
    align_->setCurrentIndex(align_->count() > 2 ? 1 : 0);  // a common event is a better default than the two starts
  }
  Q_EMIT aligned();
}

double Comparison::later_s() const { return align_->currentData().toDouble(); }

bool Comparison::toward(double first_s, uint64_t most) {
  if (!player_) return true;
  const double at = std::clamp(first_s + later_s(), 0.0, review_.length_s);
  const bool there = player_->toward(static_cast<uint64_t>(std::llround(at / review_.dt_s)), most);
  player_->fill(*snapshot_);
  view_->show_snapshot(*snapshot_);
  view_->set_texts(replay_clock(snapshot_->time_s, at), {});
  return there;
}

}  // namespace swage::console
