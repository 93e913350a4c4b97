// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/review_page.hpp"

#include <QAction>
#include <QHBoxLayout>
#include <QResizeEvent>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "console/pages/comparison.hpp"
#include "console/widgets/parts.hpp"
#include "console/widgets/plot_file.hpp"

namespace swage::console {
namespace {

constexpr int kTick_ms = 33;  // 30 pictures a second suffice for playback
constexpr uint64_t kMostSteps =
    300;  // steps computed between two pictures: the window stays responsive on a slow machine

}  // namespace

ReviewPage::ReviewPage(RecordingReader reader, PlayerOpener opener, QWidget* parent)
    : QWidget(parent),
      reader_(std::move(reader)),
      opener_(std::move(opener)),
      snapshot_(std::make_unique<snapshot::Snapshot>()) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 10, 12, 6);
  column->setSpacing(8);
  column->addWidget(make_head());
  pages_ = new QStackedWidget(this);
  auto* full = new QWidget(pages_);
  auto* rows = new QVBoxLayout(full);
  rows->setContentsMargins(0, 0, 0, 0);
  rows->setSpacing(8);
  auto* upper = new QHBoxLayout;
  upper->setSpacing(12);
  upper->addWidget(make_view(), 3);
  upper->addWidget(make_side(), 2);
  rows->addLayout(upper, 5);
  timeline_ = new Timeline(full);
  timeline_->setProperty("card", true);
  rows->addWidget(timeline_, 4);
  pages_->addWidget(full);
  pages_->addWidget(make_empty());
  column->addWidget(pages_, 1);
  show_problem(tr("Choose an attempt on the People page and press Enter, or open one that was saved to a file (Ctrl+O)."));

  connect(timeline_, &Timeline::moved, this, &ReviewPage::go);
  timer_.setInterval(kTick_ms);
  connect(&timer_, &QTimer::timeout, this, &ReviewPage::tick);
  add_keys();
  offer_picture(timeline_, QStringLiteral("traces"));
}

// Single-letter keys, active over the picture and in the tables beside it. On a button Space presses the button, in the list of traces it
// toggles one.
void ReviewPage::add_keys() {
  const auto key = [this](const QString& text, Qt::Key k, auto call) {
    auto* action = new QAction(text, this);
    action->setShortcut(k);
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this, call);
    for (QWidget* w : {static_cast<QWidget*>(timeline_), static_cast<QWidget*>(view_), static_cast<QWidget*>(metrics_),
                       static_cast<QWidget*>(moments_), static_cast<QWidget*>(worst_)})
      w->addAction(action);
    return action;
  };
  key(tr("Play"), Qt::Key_Space, [this] { toggle_play(); });
  key(tr("Loop"), Qt::Key_L, [this] { loop_->toggle(); });
  key(tr("Note"), Qt::Key_N, [this] { ask_note(); });
  key(tr("Next worst moment"), Qt::Key_W, [this] { to_next_worst(); });
  key(tr("Compare"), Qt::Key_C, [this] { ask_compare(); });
  // the timeline handles these two itself
  timeline_->removeAction(key(tr("Next event"), Qt::Key_Period, [this] { timeline_->go_to_moment(+1); }));
  timeline_->removeAction(key(tr("Event before"), Qt::Key_Comma, [this] { timeline_->go_to_moment(-1); }));
  key(tr("Ghost"), Qt::Key_G, [this] {
    if (comparing()) other_->toggle_ghost();
  });
  key(tr("End the comparison"), Qt::Key_Escape, [this] { end_comparison(); });
}

// No focus proxy: with one, Tab would stop at the page, go to the timeline next and skip all widgets between.
void ReviewPage::focusInEvent(QFocusEvent*) { timeline_->setFocus(); }

// the views go below play and speed where one row would make the tables too narrow, as on a small screen or in German
void ReviewPage::resizeEvent(QResizeEvent* event) {
  constexpr double kShare = 0.68;  // of the page's width; with more the names of metrics are cut off, with less the picture is too low
  const int one_row = transport_->itemAt(0)->sizeHint().width() + transport_->spacing() + transport_->itemAt(1)->sizeHint().width();
  const QMargins margins = layout()->contentsMargins();
  const bool narrow = one_row > kShare * (width() - margins.left() - margins.right() - 12);
  transport_->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  QWidget::resizeEvent(event);
}

// the player refers to the recording
ReviewPage::~ReviewPage() { player_.reset(); }

// the page without an attempt: how to open one
QWidget* ReviewPage::make_empty() {
  auto* box = new QWidget(pages_);
  auto* column = new QVBoxLayout(box);
  problem_ = new QLabel(box);
  problem_->setObjectName(QStringLiteral("review_problem"));
  problem_->setAlignment(Qt::AlignCenter);
  problem_->setWordWrap(true);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  auto* choose = make_button(tr("Choose an attempt"), QStringLiteral("Ctrl+4"), QStringLiteral("review_choose"), box);
  connect(choose, &QPushButton::clicked, this, &ReviewPage::back);
  buttons->addWidget(choose);
  auto* open = make_button(tr("Open a file…"), QStringLiteral("Ctrl+O"), QStringLiteral("review_open"), box);
  connect(open, &QPushButton::clicked, this, &ReviewPage::ask_file);
  buttons->addWidget(open);
  buttons->addStretch(1);
  column->addStretch(2);
  column->addWidget(problem_);
  column->addSpacing(10);
  column->addLayout(buttons);
  column->addStretch(3);
  return box;
}

QWidget* ReviewPage::make_head() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 0, 0, 0);
  auto* back = make_button(tr("‹ People"), {}, QStringLiteral("review_back"), box);
  connect(back, &QPushButton::clicked, this, &ReviewPage::back);
  row->addWidget(back);
  headline_ = new ElidedLabel(box);
  headline_->setObjectName(QStringLiteral("review_title"));
  QFont font = headline_->font();
  font.setPointSizeF(font.pointSizeF() * 1.15);
  font.setBold(true);
  headline_->setFont(font);
  verdict_ = new ElidedLabel(box);
  verdict_->setObjectName(QStringLiteral("review_verdict"));
  // one below the other: a small window has no room for both beside the buttons
  auto* words = new QVBoxLayout;
  words->setSpacing(0);
  words->addWidget(headline_);
  words->addWidget(verdict_);
  row->addSpacing(8);
  row->addLayout(words, 1);
  const auto add = [&](const QString& text, const char* name, const QString& tip, auto call) {
    auto* button = make_button(text, {}, QString::fromLatin1(name), box);
    button->setToolTip(tip);
    connect(button, &QPushButton::clicked, this, call);
    row->addWidget(button);
    button->hide();
    return button;
  };
  note_button_ = add(tr("Note…"), "review_note_button", tr("Write a note at the cursor (N)"), [this] { ask_note(); });
  compare_ = add(tr("Compare…"), "review_compare", tr("Another attempt at this lesson beside it, on the same clock (C)"),
                 [this] { ask_compare(); });
  row->addSpacing(8);
  add_exports(row, box);
  return box;
}

QWidget* ReviewPage::make_view() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  view_ = new SceneView(box);
  view_->setObjectName(QStringLiteral("review_view"));
  view_->setAccessibleName(tr("The attempt, replayed"));
  pictures_ = new QHBoxLayout;
  pictures_->setSpacing(8);
  pictures_->addWidget(view_, 1);
  column->addLayout(pictures_, 1);
  // one line with the whole text as tooltip: a wrapped sentence would make the page taller than the window
  note_ = new ElidedLabel(box);
  note_->setProperty("muted", true);
  note_->setObjectName(QStringLiteral("review_note"));
  note_->hide();
  column->addWidget(note_);
  column->addWidget(make_transport());
  return box;
}

void ReviewPage::set_themes(const UiTheme& ui, const CueTheme& cues) {
  ui_ = ui;
  cues_ = cues;
  if (other_) other_->set_themes(ui, cues);
  view_->set_themes(ui, cues);
  timeline_->set_theme(ui);
  track_->set_theme(ui);
  legend_->set_themes(ui, cues);
}

void ReviewPage::show_problem(const QString& text) {
  problem_->setText(text);
  pages_->setCurrentIndex(1);
  headline_->clear();
  verdict_->clear();
  set_exports_enabled(false);
}

void ReviewPage::set_file_services(FileOpener open, FileReader read) {
  open_file_ = std::move(open);
  read_file_ = std::move(read);
}

bool ReviewPage::open(std::shared_ptr<record::Store> store, const QString& id) {
  store_ = std::move(store);
  from_store_ = true;
  file_.clear();
  return show_attempt(id, reader_);
}

bool ReviewPage::open_file(const QString& file) {
  const std::string path = file.toStdString();
  std::string error;
  store_.reset();
  from_store_ = false;
  file_ = path;
  if (open_file_) store_ = open_file_(path, error);
  const std::vector<record::AttemptRow> attempts = store_ ? store_->attempts("") : std::vector<record::AttemptRow>();
  if (attempts.size() != 1) {
    if (store_ && error.empty()) error = store_->trouble();
    if (error.empty())
      error = attempts.empty() ? path + " holds no attempt."
                               : path + " is a store of several attempts: start with --store to see them.";
    show_problem(QString::fromStdString(error));
    return false;
  }
  return show_attempt(QString::fromStdString(attempts.front().id),
              [this, path](const std::string& id, record::Recording& out, std::string& why) {
                return read_file_(path, id, out, why);
              });
}

// by its id, or by a unique prefix of it
bool ReviewPage::find_attempt(const std::string& id, record::AttemptRow& out) {
  if (store_->attempt(id, out)) return true;
  std::string found;
  for (const record::AttemptRow& a : store_->attempt_heads()) {
    if (id.empty() || !a.id.starts_with(id)) continue;
    if (!found.empty()) return false;
    found = a.id;
  }
  return !found.empty() && store_->attempt(found, out);
}

bool ReviewPage::show_attempt(const QString& id, const RecordingReader& reader) {
  playing_ = false;
  timer_.stop();
  end_comparison();
  player_.reset();
  timeline_->set_review(nullptr, nullptr);
  recording_ = {};
  review_ = {};
  record::AttemptRow row;
  std::string error;
  if (!find_attempt(id.toStdString(), row)) {
    show_problem(store_->trouble().empty() ? tr("This attempt is no longer in the store.")
                                           : QString::fromStdString(store_->trouble()));
    return false;
  }
  if (!reader || !reader(row.id, recording_, error)) {
    show_problem(tr("The attempt cannot be read: %1").arg(QString::fromStdString(error)));
    return false;
  }
  base::Problems problems;
  if (opener_) player_ = opener_(recording_, problems);
  loop_->setChecked(false);
  review_.attempt = row;
  read_moments();
  show_review(problems);
  go(0);
  return true;
}

void ReviewPage::set_loop(bool on) {
  constexpr double kAround_s = 1;  // shows the cause of a moment and its consequence
  loop_from_s_ = on ? std::max(0.0, wanted_s_ - kAround_s) : 0;
  loop_to_s_ = on ? std::min(review_.length_s, wanted_s_ + kAround_s) : 0;
  timeline_->set_loop(loop_from_s_, loop_to_s_);
}

void ReviewPage::show_review(const base::Problems& problems) {
  pages_->setCurrentIndex(0);
  set_exports_enabled(true);
  headline_->setText(review_.title());
  verdict_->setText(review_.facts());
  play_->setText(tr("Play"));
  note_button_->setVisible(from_store_ && desk_ && desk_->school());
  compare_->setVisible(from_store_);
  worst_shown_ = false;
  timeline_->set_review(&review_, &recording_);
  const QSignalBlocker quiet(time_);
  time_->setRange(0, review_.length_s);
  fill_side();
  note_->setVisible(!player_);
  if (!player_) {
    const QString why = problems.empty() ? QString() : QString::fromStdString(problems.front().message);
    note_->setText(
        tr("The picture cannot be replayed: %1 Traces, events and metrics are as recorded.").arg(why));
    return;
  }
  reading_ = Reader(player_->card());
  legend_->set_meanings(Reader::meanings(player_->card()));
  view_->set_card(player_->card(), CameraPreset::kOrbit);
}

void ReviewPage::go(double time_s) {
  wanted_s_ = std::clamp(time_s, 0.0, review_.length_s);
  timeline_->set_cursor(wanted_s_);
  track_->set_cursor(wanted_s_);
  const QSignalBlocker quiet(time_);
  time_->setValue(wanted_s_);
  clock_.start();
  if (!timer_.isActive()) timer_.start();
}

void ReviewPage::toggle_play() {
  if (review_.length_s <= 0) return;
  playing_ = !playing_;
  if (playing_ && wanted_s_ >= review_.length_s - 1e-9) wanted_s_ = 0;
  play_->setText(playing_ ? tr("Pause") : tr("Play"));
  go(wanted_s_);
}

// advances the cursor during playback, and the scene towards the cursor; stops when the scene has reached a resting cursor
void ReviewPage::tick() {
  if (playing_) {
    // in nanoseconds: whole milliseconds would lose half of one per picture, nearly a second in a minute
    const double on = static_cast<double>(clock_.nsecsElapsed()) * 1e-9 * speed_->currentData().toDouble();
    clock_.start();
    const double before = wanted_s_;
    wanted_s_ = std::min(wanted_s_ + on, review_.length_s);
    if (loop_to_s_ > loop_from_s_ && (wanted_s_ >= loop_to_s_ || wanted_s_ < loop_from_s_)) wanted_s_ = loop_from_s_;
    // a slow machine plays more slowly but skips nothing; after a jump the cursor waits for the picture
    if (player_) {
      const double reach = static_cast<double>(player_->at() + kMostSteps) * review_.dt_s;
      if (wanted_s_ > reach) wanted_s_ = std::max(reach, std::min(before, wanted_s_));
    }
    timeline_->set_cursor(wanted_s_);
    track_->set_cursor(wanted_s_);
    const QSignalBlocker quiet(time_);
    time_->setValue(wanted_s_);
    if (wanted_s_ >= review_.length_s) toggle_play();
  }
  bool there = true;
  if (player_) {
    there = player_->toward(static_cast<uint64_t>(std::llround(wanted_s_ / review_.dt_s)), kMostSteps);
    show_player();
  }
  if (comparing()) there = other_->toward(wanted_s_, kMostSteps) && there;
  move_ghost();
  if (there && !playing_) timer_.stop();
}

void ReviewPage::show_player() {
  player_->fill(*snapshot_);
  view_->show_snapshot(*snapshot_);
  const Reading reading = reading_.read(*snapshot_);
  view_->set_hold(reading.hold.value_or(0));
  legend_->set_active(reading.meanings);
  QString clock = clock_text(snapshot_->time_s);
  // a large jump takes seconds to compute
  constexpr double kBehind_s = 1;
  if (std::abs(wanted_s_ - snapshot_->time_s) > kBehind_s) clock = tr("%1, on the way to %2").arg(clock, clock_text(wanted_s_));
  view_->set_texts(reading.phase.isEmpty() ? clock : QStringLiteral("%1  %2").arg(said(reading.phase), clock), {});
  const uint64_t differs = player_->first_difference();
  if (differs >= player_->count() || note_->isVisible()) return;
  note_->setText(tr("From %L1 s on the picture is not the attempt bit for bit: it was recorded with another "
                    "version of a plugin. "
                    "Traces, events and metrics are as recorded.")
                     .arg(static_cast<double>(differs) * review_.dt_s, 0, 'f', 2));
  note_->show();
}

}  // namespace swage::console
