// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/review_page.hpp"

#include <QAction>
#include <QHBoxLayout>
#include <QInputDialog>
#include <QTimer>
#include <QVBoxLayout>
#include <utility>

#include "console/models/qt_text.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "console/pages/attempt_chooser.hpp"
#include "console/pages/comparison.hpp"
#include "console/pages/pull_dialog.hpp"
#include "console/pages/review_tables.hpp"
#include "console/widgets/parts.hpp"
#include "console/widgets/plot_file.hpp"

namespace swage::console {

ReviewPage::ReviewPage(RecordingReader reader, PlayerOpener opener, QWidget* parent)
    : QWidget(parent),
      attempt_(std::move(reader), std::move(opener)),
      playback_({[this](double time_s, uint64_t most) { return pictures_->toward(time_s, most); },
                 [this]() -> std::optional<double> {
                   if (!attempt_.player()) return std::nullopt;
                   return static_cast<double>(attempt_.player()->at()) * attempt_.review().dt_s;
                 }}) {
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
  side_ = new ReviewSide(this);
  upper->addWidget(side_, 2);
  rows->addLayout(upper, 7);
  timeline_ = new Timeline(full);
  timeline_->setProperty("card", true);
  rows->addWidget(timeline_, 4);
  pages_->addWidget(full);
  pages_->addWidget(make_empty());
  column->addWidget(pages_, 1);
  show_problem(tr("Choose an attempt on the People page and press Enter, or open one that was saved to a file (Ctrl+O)."));
  connect_parts();
  add_keys();
  offer_picture(timeline_, QStringLiteral("traces"));
}

void ReviewPage::connect_parts() {
  connect(timeline_, &Timeline::moved, this, &ReviewPage::go);
  connect(&playback_, &Playback::moved, this, [this](double time_s) {
    timeline_->set_cursor(time_s);
    side_->set_cursor(time_s);
    transport_->set_time(time_s);
    forget_moment(time_s);
  });
  connect(&playback_, &Playback::rested, this, &ReviewPage::pull_if_asked);
  connect(&playback_, &Playback::playing_changed, transport_, &ReviewTransport::set_playing);
  connect(&playback_, &Playback::looped, timeline_, &Timeline::set_loop);
  connect(transport_, &ReviewTransport::gone_to, this, &ReviewPage::go);
  connect(transport_, &ReviewTransport::stepped, this, [this](double by_s) { go(timeline_->cursor() + by_s); });
  connect(transport_, &ReviewTransport::play_pressed, this, &ReviewPage::toggle_play);
  connect(transport_, &ReviewTransport::looped, &playback_, &Playback::set_loop);
  connect(transport_, &ReviewTransport::speed_chosen, &playback_, &Playback::set_speed);
  connect(transport_, &ReviewTransport::looked, pictures_, &ReviewPictures::look);
  connect(transport_, &ReviewTransport::forces_shown, view(), &SceneView::set_forces_shown);
  connect(side_, &ReviewSide::chosen, this, &ReviewPage::go);
  connect(side_, &ReviewSide::loop, this, &ReviewPage::loop_here);
  connect(side_, &ReviewSide::traces_shown, timeline_, &Timeline::set_shown);
  connect(side_, &ReviewSide::rated, this, &ReviewPage::rate);
  connect(pictures_, &ReviewPictures::cues_on, side_->legend(), &CueLegend::set_active);
  connect(pictures_, &ReviewPictures::aligned, this, &ReviewPage::show_other);
  connect(pictures_, &ReviewPictures::ended, this, &ReviewPage::show_compared);
  connect(pictures_, &ReviewPictures::differs, this, [this](double from_s) {
    if (note_->isVisible()) return;
    show_note(tr("From %L1 s on the picture is not the attempt bit for bit: it was recorded with another "
                 "version of a plugin. "
                 "Traces, events and metrics are as recorded.")
                  .arg(from_s, 0, 'f', 2));
  });
}

// Single-letter keys, active over the picture and in the tables beside it. On a button Space presses the button, in the list of traces it
// toggles one.
void ReviewPage::add_keys() {
  const auto key = [this](const QString& text, Qt::Key k, auto call) {
    auto* action = new QAction(text, this);
    action->setShortcut(k);
    action->setShortcutContext(Qt::WidgetShortcut);
    connect(action, &QAction::triggered, this, call);
    for (QWidget* w : QList<QWidget*>{timeline_, view()} + side_->tables()) w->addAction(action);
    return action;
  };
  key(tr("Play"), Qt::Key_Space, [this] { toggle_play(); });
  key(tr("Loop"), Qt::Key_L, [this] { transport_->loop()->toggle(); });
  key(tr("Note"), Qt::Key_N, [this] { ask_note(); });
  key(tr("Next worst moment"), Qt::Key_W, [this] { side_->next_worst(); });
  key(tr("Compare"), Qt::Key_C, [this] { ask_compare(); });
  key(tr("Pull the knot"), Qt::Key_K, [this] { ask_pull(); });
  // the timeline handles these two itself
  timeline_->removeAction(key(tr("Next event"), Qt::Key_Period, [this] { timeline_->go_to_moment(+1); }));
  timeline_->removeAction(key(tr("Event before"), Qt::Key_Comma, [this] { timeline_->go_to_moment(-1); }));
  key(tr("Ghost"), Qt::Key_G, [this] { pictures_->toggle_ghost(); });
  key(tr("End the comparison"), Qt::Key_Escape, [this] { end_comparison(); });
}

// No focus proxy: with one, Tab would stop at the page, go to the timeline next and skip all widgets between.
void ReviewPage::focusInEvent(QFocusEvent*) { timeline_->setFocus(); }

// the timeline refers to the attempt
ReviewPage::~ReviewPage() { timeline_->set_review(nullptr, nullptr); }

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
  pull_ = add(tr("Pull the knot…"), "review_pull", tr("Does the knot hold, as it is at the cursor? A copy of it is pulled (K)"), [this] { ask_pull(); });
  row->addSpacing(8);
  exports_ = new AttemptExports(attempt_, box);
  connect(exports_, &AttemptExports::told, this, &ReviewPage::show_note);
  row->addWidget(exports_);
  return box;
}

QWidget* ReviewPage::make_view() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  pictures_ = new ReviewPictures(attempt_, box);
  column->addWidget(pictures_, 1);
  // two lines at most, the whole text as tooltip: more would make the page taller than a small window
  note_ = new ElidedLabel(box, 2);
  note_->setProperty("muted", true);
  note_->setObjectName(QStringLiteral("review_note"));
  note_->hide();
  column->addWidget(note_);
  transport_ = new ReviewTransport(box);
  column->addWidget(transport_);
  return box;
}

void ReviewPage::set_themes(const UiTheme& ui, const CueTheme& cues) {
  pictures_->set_themes(ui, cues);
  timeline_->set_theme(ui);
  side_->set_themes(ui, cues);
}

void ReviewPage::show_problem(const QString& text) {
  problem_->setText(text);
  pages_->setCurrentIndex(1);
  headline_->clear();
  verdict_->clear();
  exports_->set_available(false);
}

void ReviewPage::show_note(const QString& text) {
  note_at_s_.reset();
  note_->setText(text);
  note_->show();
}

void ReviewPage::show_note_here(const QString& text) {
  show_note(text);
  note_at_s_ = playback_.wanted_s();
}

// what is said of another moment goes
void ReviewPage::forget_moment(double time_s) {
  const auto another = [time_s](const std::optional<double>& at_s) { return at_s && *at_s != time_s; };
  if (another(pull_at_s_)) pull_at_s_.reset();
  if (!another(note_at_s_)) return;
  note_at_s_.reset();
  note_->hide();
}

void ReviewPage::pull_if_asked() {
  if (!std::exchange(pull_at_s_, std::nullopt)) return;
  note_at_s_.reset();
  note_->hide();
  QTimer::singleShot(0, this, &ReviewPage::ask_pull);  // after the picture of this moment
}

// Nothing refers to the attempt any more: another one can be opened.
void ReviewPage::leave() {
  playback_.stop();
  pull_at_s_.reset();
  note_at_s_.reset();
  end_comparison();
  timeline_->set_review(nullptr, nullptr);
}

bool ReviewPage::open(std::shared_ptr<record::Store> store, const QString& id) {
  leave();
  return show_opened(attempt_.open(std::move(store), id));
}

bool ReviewPage::open_file(const QString& file) {
  leave();
  return show_opened(attempt_.open_file(file));
}

bool ReviewPage::show_opened(const QString& problem) {
  if (!problem.isEmpty()) {
    show_problem(problem);
    Q_EMIT opened();
    return false;
  }
  playback_.set_length(review().length_s, review().dt_s);
  transport_->loop()->setChecked(false);
  show_review();
  go(0);
  Q_EMIT opened();
  return true;
}

void ReviewPage::show_review() {
  pages_->setCurrentIndex(0);
  exports_->set_available(true);
  headline_->setText(review().title());
  verdict_->setText(review().facts());
  transport_->set_playing(false);
  transport_->set_length(review().length_s);
  note_button_->setVisible(attempt_.can_note());
  compare_->setVisible(attempt_.from_store());
  pull_->setVisible(player() && attempt_.has_knot());
  side_->worst()->start_again();
  timeline_->set_review(&attempt_.review(), &attempt_.recording());
  fill_side();
  note_->setVisible(!player());
  if (!player()) {
    note_->setText(tr("The picture cannot be replayed: %1 Traces, events and metrics are as recorded.").arg(attempt_.why_no_player()));
    return;
  }
  side_->legend()->set_meanings(Reader::meanings(player()->card()));
  pictures_->show_scene();
}

void ReviewPage::fill_side() {
  side_->fill(review(), attempt_.recording(), attempt_.worst(), attempt_.can_note());
  show_metrics();
}

void ReviewPage::show_metrics() { side_->fill_metrics(review(), comparing() ? &comparison()->review() : nullptr); }

void ReviewPage::set_desk(SchoolDesk* desk) {
  attempt_.set_desk(desk);
  connect(desk, &SchoolDesk::changed, this, [this] {
    if (!attempt_.is_open() || !isVisible()) return;
    attempt_.read_moments();
    timeline_->set_review(&attempt_.review(), &attempt_.recording());
    if (comparing()) timeline_->set_other(&comparison()->review(), &comparison()->recording(), comparison()->later_s());
    timeline_->set_cursor(playback_.wanted_s());
    fill_side();
  });
}

void ReviewPage::rate(const QString& item_id, std::optional<double> points) {
  if (attempt_.rate(item_id, points)) return;
  show_note(tr("▲ The rating was not kept: %1").arg(attempt_.desk_problem()));
  side_->show_scales(review(), true);
}

void ReviewPage::ask_note() {
  if (!note_button_->isVisible()) return;
  const QString text = QInputDialog::getText(this, tr("Note"), tr("At %L1 s:").arg(playback_.wanted_s(), 0, 'f', 2));
  if (text.trimmed().isEmpty() || add_note(text)) return;
  show_note(tr("▲ The note was not kept: %1").arg(attempt_.desk_problem()));
}

// for a debriefing: plays the moment at the cursor in a loop
void ReviewPage::loop_here() {
  transport_->loop()->setChecked(false);
  transport_->loop()->setChecked(true);
  if (!playing()) toggle_play();
}

void ReviewPage::ask_compare() {
  if (!attempt_.from_store() || !attempt_.is_open()) return;
  AttemptChooser dialog(attempt_.store()->attempts("", review().attempt.lesson_id), review().attempt.id, this);
  if (dialog.exec() == QDialog::Accepted && !dialog.chosen().isEmpty()) compare(dialog.chosen());
}

// of the moment that the picture shows
void ReviewPage::ask_pull() {
  if (!pull_->isVisible()) return;
  if (playing()) toggle_play();
  const double at_s = playback_.wanted_s();
  if (playback_.moving()) {
    pull_at_s_ = at_s;
    return show_note_here(tr("The knot is pulled as soon as the picture is at the cursor."));
  }
  PullDialog::Services services;
  services.open = [this](const PullWish& wish, QString& why) {
    base::Problems problems;
    auto puller = attempt_.player()->pull_knot(wish, problems);
    why = puller ? QString() : problems.empty() ? tr("This attempt has no knot.") : said_message(problems.back().message);
    return puller;
  };
  if (attempt_.can_note()) services.keep = [this, at_s](const QString& text) { return attempt_.add_note(text, at_s); };
  services.dress = [this](SceneView& view) { pictures_->set_colours(view); };
  PullDialog dialog(std::move(services), at_s, this);
  if (!dialog.pull()) return show_note_here(tr("▲ At %1: %2 Go to where it is tied, such as the end.").arg(clock_text(at_s), dialog.why()));
  dialog.exec();
}

bool ReviewPage::compare(const QString& attempt_id) {
  if (!attempt_.store() || !attempt_.is_open()) return false;
  const QString problem = pictures_->compare(attempt_id);
  if (!problem.isEmpty()) {
    show_note(tr("▲ %1").arg(problem));
    return false;
  }
  show_compared();
  return true;
}

// the other attempt in the traces, on its shifted clock
void ReviewPage::show_other() {
  timeline_->set_other(&comparison()->review(), &comparison()->recording(), comparison()->later_s());
  go(playback_.wanted_s());
}

void ReviewPage::show_compared() {
  comparing() ? show_other() : timeline_->set_other(nullptr, nullptr, 0);
  show_metrics();
  timeline_->setFocus();
}

}  // namespace swage::console
