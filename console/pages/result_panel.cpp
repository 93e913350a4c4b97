// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/result_panel.hpp"

#include <QAccessible>
#include <algorithm>
#include <cmath>
#include <limits>

#include "console/models/metric_titles.hpp"
#include "console/models/ratings.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "console/widgets/parts.hpp"
#include "judge/metrics.hpp"

namespace swage::console {

QString reason_text(const std::string& reason, const judge::Script& script) {
  for (const judge::Name& e : script.events) {
    if (e.id == reason && !e.doc.empty()) return said_event(e.doc);
  }
  return said_id(reason);
}

namespace {

QGridLayout* make_numbers() {
  auto* grid = new QGridLayout;
  grid->setColumnStretch(0, 1);
  grid->setVerticalSpacing(5);
  return grid;
}

}  // namespace

ResultPanel::ResultPanel(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("result"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  const Card card = make_card(tr("Result"), this);
  column->addWidget(card.frame);
  add_outcome(card);
  add_points(card);
  const QList<QPushButton*> buttons = add_buttons(card);
  add_more(card);
  add_criteria(card);
  card.body->addStretch(1);
  // in the order in which they stand
  const QList<QPushButton*> order = buttons + QList<QPushButton*>{more_button_};
  for (int i = 1; i < order.size(); ++i) setTabOrder(order[i - 1], order[i]);
}

void ResultPanel::add_outcome(const Card& card) {
  outcome_ = new QLabel(card.frame);
  outcome_->setObjectName(QStringLiteral("outcome"));
  outcome_->setProperty("big", true);
  reason_ = new QLabel(card.frame);
  reason_->setWordWrap(true);
  metrics_ = make_numbers();
  card.body->addWidget(outcome_);
  card.body->addWidget(reason_);
  card.body->addSpacing(4);
  card.body->addLayout(metrics_);
}

void ResultPanel::add_points(const Card& card) {
  points_ = make_numbers();
  points_heading_ = make_heading(tr("Points lost"), card.frame);
  kept_ = make_muted({}, card.frame);
  kept_->setObjectName(QStringLiteral("kept"));
  course_ = make_muted({}, card.frame);
  course_->setObjectName(QStringLiteral("result_course"));
  course_->hide();
  problems_ = make_muted({}, card.frame);
  card.body->addWidget(points_heading_);
  card.body->addLayout(points_);
  card.body->addWidget(kept_);
  card.body->addWidget(course_);
  card.body->addWidget(problems_);
}

// What can be done next, in the order of the keyboard.
QList<QPushButton*> ResultPanel::add_buttons(const Card& card) {
  const auto make = [&card](const QString& words, const char* key, const char* name) {
    QPushButton* button = make_button(words, {}, QLatin1String(name), card.frame);
    button->setText(words + QLatin1Char('\n') + key_text(QLatin1String(key)));
    return button;
  };
  auto* again = make(tr("Again"), "F5", "again");
  review_ = make(tr("Review"), "Ctrl+R", "to_review");
  next_ = make(tr("Next lesson"), "Ctrl+Right", "next_lesson");
  auto* progress = make(tr("Progress"), "Ctrl+P", "to_progress");
  again->setToolTip(QStringLiteral("%1 (%2)").arg(tr("Again"), key_text(QStringLiteral("F5"))));  // a key of the window
  give_key(review_, QStringLiteral("Ctrl+R"));
  next_->setToolTip(QStringLiteral("%1 (%2)").arg(tr("Next lesson"), key_text(QStringLiteral("Ctrl+Right"))));  // a key of the page
  give_key(progress, QStringLiteral("Ctrl+P"));
  connect(again, &QPushButton::clicked, this, &ResultPanel::again);
  connect(review_, &QPushButton::clicked, this, [this] { Q_EMIT review(attempt_); });
  connect(next_, &QPushButton::clicked, this, &ResultPanel::next);
  connect(progress, &QPushButton::clicked, this, &ResultPanel::progress);
  auto* grid = new QGridLayout;
  const QList<QPushButton*> all = {again, review_, next_, progress};
  for (int i = 0; i < all.size(); ++i) grid->addWidget(all[i], i / 2, i % 2);
  card.body->addLayout(grid);
  return all;
}

void ResultPanel::add_more(const Card& card) {
  more_box_ = new QWidget(card.frame);
  more_ = make_numbers();
  more_->setContentsMargins(0, 0, 0, 0);
  more_box_->setLayout(more_);
  more_box_->hide();
  more_button_ = make_button(tr("All numbers"), {}, QStringLiteral("all_numbers"), card.frame);
  more_button_->setCheckable(true);
  connect(more_button_, &QPushButton::toggled, more_box_, &QWidget::setVisible);
  card.body->addWidget(more_button_);
  card.body->addWidget(more_box_);
}

void ResultPanel::add_criteria(const Card& card) {
  criteria_ = new QLabel(card.frame);
  criteria_->setObjectName(QStringLiteral("result_criteria"));
  criteria_->setWordWrap(true);
  criteria_->setTextFormat(Qt::RichText);
  criteria_->hide();
  card.body->addWidget(criteria_);
}

void ResultPanel::set_course(const QString& words) {
  course_->setText(words);
  course_->setVisible(!words.isEmpty());
}

void ResultPanel::set_criteria(const Criteria& asked) {
  const QString text = list_text(tr("To pass"), asked.pass) + list_text(tr("Limits in a test"), asked.limits) +
                       list_text(tr("Ends every attempt"), asked.ends);
  criteria_->setText(text);
  criteria_->setVisible(!text.isEmpty() && !asked.show);
}

void ResultPanel::set_theme(const UiTheme& theme) {
  theme_ = theme;
  paint_outcome();
}

void ResultPanel::paint_outcome() {
  const bool met = state_ == judge::Outcome::kPassed;
  const bool neutral = state_ == judge::Outcome::kAborted || state_ == judge::Outcome::kVoid;
  const QColor colour = met ? theme_["good"] : neutral ? theme_["muted"] : theme_["warn"];
  outcome_->setStyleSheet(QStringLiteral("color: %1").arg(colour.name()));
}

void ResultPanel::clear() {
  for (QGridLayout* grid : {metrics_, points_, more_}) {
    while (QLayoutItem* item = grid->takeAt(0)) {
      delete item->widget();
      delete item;
    }
  }
  more_button_->setChecked(false);
}

void ResultPanel::add_line(QGridLayout* to, const QString& name, const QString& value, const QString& doc) {
  const int row = to->count() / 2;
  auto* label = make_muted(name, this);
  auto* number = new QLabel(value, this);
  label->setToolTip(doc);
  number->setToolTip(doc);
  number->setAccessibleName(name);
  to->addWidget(label, row, 0);
  to->addWidget(number, row, 1, Qt::AlignRight | Qt::AlignTop);
}

// Time costs points by the active time, not by the clock: both are told beside each other.
QString ResultPanel::points_title(const session::Result& r, const std::string& id) const {
  const QString title = metric_title(QString::fromStdString(id));
  const double free_s = most("time.task");  // active time that costs no points
  const auto active = std::find_if(r.metrics.begin(), r.metrics.end(), [](const session::Result::Metric& m) { return m.id == "time.task"; });
  if (id != "points.time" || !std::isfinite(free_s) || active == r.metrics.end()) return title;
  const QString unit = QStringLiteral("s");
  return tr("%1: %2 active, %3 free").arg(title, quantity_text(active->value, unit), quantity_text(free_s, unit));
}

double ResultPanel::most(const std::string& metric) const {
  const auto target = targets_.find(metric);
  return target == targets_.end() ? std::numeric_limits<double>::infinity() : target->second.high.value_or(std::numeric_limits<double>::infinity());
}

// Those with a rank first and in its order, then what exceeds the lesson's limit, what cost points apart, the rest on demand. Where no
// points are told, as of an attempt that was stopped, the faults that were counted stand with the first.
void ResultPanel::add_metrics(const session::Result& r, const snapshot::SceneCard& card) {
  std::vector<std::pair<int, size_t>> first;
  std::vector<size_t> faults, beyond;
  bool more = false, points = false;
  const auto card_of = [&](size_t i) { return i < card.metrics.size() ? card.metrics[i] : snapshot::CardMetric{}; };
  const auto add = [&](QGridLayout* to, size_t i) {
    const session::Result::Metric& m = r.metrics[i];
    const QString unit = shown_unit(card_of(i).show, QString::fromStdString(m.unit)), value = quantity_text(m.value, unit);
    const bool over = std::find(beyond.begin(), beyond.end(), i) != beyond.end();
    add_line(to, metric_title(QString::fromStdString(m.id)), over ? tr("▲ %1, over %2").arg(value, quantity_text(most(m.id), unit)) : value, said(m.doc));
  };
  for (size_t i = 0; i < r.metrics.size(); ++i) {
    const session::Result::Metric& m = r.metrics[i];
    if (!std::isfinite(m.value)) continue;  // not reported: there was none
    const snapshot::CardMetric own = card_of(i);
    if (own.show == SWAGE_SHOW_POINTS) {
      if (m.value < 0.05) continue;  // less than is shown
      points = true;
      add_line(points_, points_title(r, m.id), QStringLiteral("−%L1").arg(m.value, 0, 'f', 1),
               said(m.doc));
    } else if (own.rank > 0) {
      first.emplace_back(own.rank, i);
    } else if (m.value > most(m.id)) {
      beyond.push_back(i);
    } else if (r.outcome != judge::Outcome::kPassed && own.show == SWAGE_SHOW_COUNT && own.better == SWAGE_BETTER_LOWER && m.value > 0) {
      faults.push_back(i);
    } else {
      more = true;
      add(more_, i);
    }
  }
  std::sort(first.begin(), first.end());
  for (const auto& [rank, i] : first) add(metrics_, i);
  for (const size_t i : beyond) add(metrics_, i);
  for (const size_t i : faults) add(metrics_, i);
  points_heading_->setVisible(points);
  // a lesson that ranks nothing shows everything
  more_button_->setVisible(more && !first.empty());
  more_box_->setVisible(more && first.empty());
}

// beside the lesson's own score, on demand
void ResultPanel::add_ratings(const session::Result& r) {
  for (const RatingLine& rating : rating_lines(judge::text(r.outcome), judge::metrics_of(r.metrics)))
    add_line(more_, rating.name, rating.value, rating.doc);
}

void ResultPanel::show_notes(const session::Result& r) {
  QStringList notes;
  for (const base::Problem& p : r.problems) {
    if (p.severity != base::Severity::kNote) notes += QString::fromStdString(p.where + ": ") + said_message(p.message);
  }
  problems_->setText(notes.join(QLatin1Char('\n')));
  problems_->setVisible(!notes.isEmpty());
}

void ResultPanel::announce() {
  outcome_->setAccessibleName(tr("Result"));
  outcome_->setAccessibleDescription(outcome_->text() + QStringLiteral(". ") + reason_->text());
  QAccessibleEvent announce(outcome_, QAccessible::Alert);
  QAccessible::updateAccessibility(&announce);
}

void ResultPanel::show_result(const session::Result& r, const snapshot::SceneCard& card, bool kept, bool readings_open) {
  state_ = r.outcome;
  attempt_ = QString::fromStdString(r.attempt_id);
  // a sign beside the word: no verdict by colour alone
  const QString sign = r.outcome == judge::Outcome::kPassed   ? QStringLiteral("✓ ")
                       : r.outcome == judge::Outcome::kFailed ? QStringLiteral("✗ ")
                                                              : QString();
  outcome_->setText(sign + verdict_text(QString::fromLatin1(judge::text(r.outcome))));
  reason_->setText(r.outcome == judge::Outcome::kAborted ? tr("Stopped before the lesson was over.")
                                                         : reason_text(r.reason, card.script));
  paint_outcome();
  clear();
  if (r.outcome == judge::Outcome::kPassed)
    add_line(metrics_, tr("Score"), QStringLiteral("%1 / 100").arg(r.score, 0, 'f', 0), {});
  add_line(metrics_, tr("Time"), clock_text(r.simulated_s), {});
  add_metrics(r, card);
  add_ratings(r);
  review_->setEnabled(kept);
  kept_->setText(r.not_kept               ? tr("▲ Not recorded: nothing of this attempt is kept.")
                 : !kept                  ? tr("Not recorded.")
                 : !r.kept_beside.empty() ? tr("▲ Recorded beside the store, until it can be written again.")
                 : r.missing_steps > 0    ? tr("▲ Recorded, but %1 steps are missing.").arg(r.missing_steps)
                 : card.mode == "hand"    ? tr("Recorded as an attempt of a recorded hand; it counts for nobody.")
                                          : tr("Recorded."));
  if (readings_open) add_remark(tr("The readings were open on the trainee's screen."));
  show_notes(r);
  announce();
}

void ResultPanel::add_remark(const QString& words) {
  if (!words.isEmpty()) kept_->setText(kept_->text() + QLatin1Char('\n') + tr("▲ %1").arg(words));
}

void ResultPanel::show_seen(const session::Result& r) {
  state_ = judge::Outcome::kAborted;
  attempt_.clear();
  outcome_->setText(tr("Seen"));
  reason_->setText(tr("A demonstration: nothing was judged or recorded."));
  paint_outcome();
  clear();
  add_line(metrics_, tr("Time"), clock_text(r.simulated_s), {});
  for (const session::Result::Metric& m : r.metrics) {
    if (std::isfinite(m.value) && metric_show(QString::fromStdString(m.id)) != SWAGE_SHOW_POINTS)
      add_line(metrics_, metric_title(QString::fromStdString(m.id)), quantity_text(m.value, QString::fromStdString(m.unit)),
               said(m.doc));
  }
  points_heading_->hide();
  more_button_->hide();
  more_box_->hide();
  review_->setEnabled(false);
  kept_->setText({});
  show_notes(r);
  announce();
}

}  // namespace swage::console
