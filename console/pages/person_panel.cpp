// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/person_panel.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>

#include "console/models/metric_titles.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "console/widgets/parts.hpp"
#include "console/widgets/plot_file.hpp"

namespace swage::console {
namespace {

constexpr int kLeastCombo_px = 130;  // of lesson and metric on a small screen; the open list shows their whole names

}  // namespace

PersonPanel::PersonPanel(QWidget* parent)
    : QWidget(parent), attempts_(new AttemptsModel(this)), sorted_(new QSortFilterProxyModel(this)) {
  sorted_->setSourceModel(attempts_);
  sorted_->setSortRole(AttemptsModel::kSortRole);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(6);
  column->addWidget(make_head());
  tabs_ = new QTabWidget(this);
  tabs_->setObjectName(QStringLiteral("person_tabs"));
  tabs_->setAccessibleName(tr("Progress, attempts"));
  tabs_->setDocumentMode(true);
  tabs_->addTab(make_curve(), tr("Pro&gress"));
  tabs_->addTab(make_attempts(), tr("&Attempts"));
  group_plot_ = new GroupPlot(tabs_);
  group_plot_->setToolTip(tr("Every judged attempt of the people chosen above (Ctrl or Shift and a click choose several)"));
  offer_picture(group_plot_, QStringLiteral("group"));
  auto* group = new QWidget(tabs_);
  auto* rows = new QVBoxLayout(group);
  rows->setContentsMargins(0, 6, 0, 0);
  rows->addWidget(group_plot_, 1);
  rows->addWidget(make_muted(tr("A row for each person chosen above: Ctrl or Shift and a click choose several, Ctrl+A all."), group));
  tabs_->addTab(group, tr("G&roup"));
  connect(tabs_, &QTabWidget::currentChanged, this, &PersonPanel::show_group);
  group_later_.setSingleShot(true);
  group_later_.setInterval(0);
  connect(&group_later_, &QTimer::timeout, this, &PersonPanel::draw_group);
  connect(tabs_, &QTabWidget::currentChanged, this, &PersonPanel::choose_newest);
  column->addWidget(tabs_, 1);
}

QWidget* PersonPanel::make_head() {
  auto* box = new QWidget(this);
  auto* head = new QHBoxLayout(box);
  head->setContentsMargins(0, 0, 0, 0);
  name_ = new QLabel(box);
  name_->setObjectName(QStringLiteral("person_name"));
  name_->setProperty("big", true);
  summary_ = make_muted({}, box);
  summary_->setObjectName(QStringLiteral("person_summary"));
  head->addWidget(name_);
  head->addSpacing(12);
  head->addWidget(summary_, 1);
  const auto combo = [&](const QString& label, const QString& name) {
    auto* text = make_muted(label, box);
    text->setWordWrap(false);
    auto* c = new QComboBox(box);
    c->setObjectName(name);
    c->setAccessibleName(label);
    c->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    c->setMinimumWidth(kLeastCombo_px);
    text->setBuddy(c);
    head->addWidget(text);
    head->addWidget(c);
    return c;
  };
  lesson_ = combo(tr("Lesson"), QStringLiteral("lesson_filter"));
  metric_ = combo(tr("Metric"), QStringLiteral("metric"));
  connect(lesson_, &QComboBox::currentIndexChanged, this, &PersonPanel::show_attempts);
  connect(metric_, &QComboBox::currentIndexChanged, this, &PersonPanel::show_metric);
  return box;
}

QWidget* PersonPanel::make_curve() {
  auto* box = new QWidget(this);
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(0, 6, 0, 0);
  Card plot = make_card({}, box);
  chart_ = new MetricChart(plot.frame);
  offer_picture(chart_, QStringLiteral("progress"));
  plot.body->addWidget(chart_, 1);
  curve_ = make_muted({}, plot.frame);
  curve_->setObjectName(QStringLiteral("curve_words"));
  plot.body->addWidget(curve_);
  row->addWidget(plot.frame, 5);
  Card latest = make_card(tr("Latest attempt, experts' band"), box);
  bars_ = new BandBars(latest.frame);
  offer_picture(bars_, QStringLiteral("latest"));
  QScrollArea* scroll = make_scroll(latest.frame);
  scroll->setWidget(bars_);
  latest.body->addWidget(scroll, 1);
  row->addWidget(latest.frame, 3);
  return box;
}

// the selected lesson, or the only one
std::string PersonPanel::only_lesson() const {
  std::string lesson = lesson_->currentData().toString().toStdString();
  for (const record::AttemptRow& a : attempts_->attempts()) {
    if (lesson.empty()) lesson = a.lesson_id;
    if (lesson != a.lesson_id) return {};
  }
  return lesson;
}

void PersonPanel::show_bars() {
  if (!isVisible()) return;
  const std::string lesson = only_lesson();
  if (lesson.empty() || !experts_) return bars_->set_bars({}, tr("Choose a lesson to see its values beside the experts'."));
  const bool any = std::any_of(attempts_->attempts().begin(), attempts_->attempts().end(), [](const auto& a) { return counts(a); });
  if (!any) return bars_->set_bars({}, tr("No attempt that counts yet: there is nothing to see beside the experts' values."));
  bars_->set_bars(metric_bars(attempts_->attempts(), experts_,
                              [&](const QString& id) {
                                return finder_ ? finder_(QString::fromStdString(lesson), id.toStdString()).facts.better
                                               : metric_facts(nullptr, id.toStdString()).better;
                              }),
                  tr("No expert has done this lesson. Experts are the people of the group \"Experts\"; without them the recorded "
                     "expert's attempts stand in."));
}

QWidget* PersonPanel::make_attempts() {
  Card list = make_card({}, this);
  table_ = make_row_table(sorted_, tr("Attempts"), QStringLiteral("attempts"), list.frame);
  table_->setSortingEnabled(true);
  table_->sortByColumn(AttemptsModel::kWhen, Qt::DescendingOrder);
  table_->horizontalHeader()->setSectionResizeMode(AttemptsModel::kReason, QHeaderView::Stretch);
  table_->setToolTip(tr("Enter or a double click opens the attempt"));
  list.body->addWidget(table_, 1);
  review_ =
      make_button(tr("Review this attempt"), QStringLiteral("Enter"), QStringLiteral("review"), list.frame);
  auto* open = make_button(tr("Open..."), QStringLiteral("Ctrl+O"), QStringLiteral("open_attempt"), list.frame);
  open->setToolTip(tr("Look at an attempt that was saved to a file (Ctrl+O)"));
  connect(open, &QPushButton::clicked, this, &PersonPanel::open_file);
  void_ = make_button(tr("Void…"), QStringLiteral("Ctrl+D"), QStringLiteral("void_attempt"), list.frame);
  void_->setShortcut(QKeySequence(QStringLiteral("Ctrl+D")));
  connect(void_, &QPushButton::clicked, this, &PersonPanel::void_attempt);
  give_ = make_button(tr("Give to…"), QStringLiteral("Ctrl+Shift+G"), QStringLiteral("give_attempt"), list.frame);
  give_->setToolTip(tr("This attempt is another person's: a guest's, or of a name that was mistaken"));
  give_key(give_, QStringLiteral("Ctrl+Shift+G"));
  connect(give_, &QPushButton::clicked, this, &PersonPanel::give_attempt);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(void_);
  buttons->addWidget(give_);
  buttons->addStretch(1);
  buttons->addWidget(open);
  buttons->addWidget(review_);
  list.body->addLayout(buttons);
  connect(review_, &QPushButton::clicked, this, &PersonPanel::review_current);
  connect(table_, &QTableView::activated, this, &PersonPanel::review_current);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          &PersonPanel::update_buttons);
  update_buttons();
  return list.frame;
}

// selects the newest attempt for the buttons below
void PersonPanel::choose_newest() {
  if (tabs_->currentIndex() == 1 && !table_->selectionModel()->hasSelection()) table_->selectRow(0);
}

void PersonPanel::update_buttons() {
  const record::AttemptRow* row = chosen_row();
  for (QPushButton* b : {review_, void_, give_}) b->setEnabled(row);
  const bool is_void = row && row->is_void;
  void_->setText((is_void ? tr("Count again") : tr("Void…")) + QStringLiteral("   ") + key_text(QStringLiteral("Ctrl+D")));
  void_->setToolTip(is_void ? tr("This attempt counts again (Ctrl+D)")
                            : tr("Void this attempt and say why, as after a fault or a wrong lesson: it is kept and counts for nothing (Ctrl+D)"));
}

const record::AttemptRow* PersonPanel::chosen_row() const {
  const std::string id = chosen_attempt().toStdString();
  for (const record::AttemptRow& a : all_)
    if (a.id == id) return &a;
  return nullptr;
}

QString PersonPanel::chosen_attempt() const {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  return rows.isEmpty() ? QString() : rows.first().data(AttemptsModel::kId).toString();
}

void PersonPanel::review_current() {
  if (const QString id = chosen_attempt(); !id.isEmpty()) Q_EMIT review(id);
}

// Opens the lesson for target and formula, so only while the panel is visible. A target is of one lesson; several lessons have several.
void PersonPanel::ask_lesson(MetricSeries& series) const {
  if (!finder_ || !isVisible()) return;
  const std::string id = series.id.toStdString();
  std::string lesson;
  bool several = false;
  for (const record::AttemptRow& a : attempts_->attempts()) {
    const bool own =
        id == "score" || id == "time" ||
        std::any_of(a.metrics.begin(), a.metrics.end(), [&](const auto& m) { return m.id == id; });
    if (!own) continue;
    several |= !lesson.empty() && lesson != a.lesson_id;
    lesson = a.lesson_id;
  }
  if (lesson.empty()) return;
  const MetricSaid said = finder_(QString::fromStdString(lesson), id);
  series.better = said.facts.better;
  series.formula = said.facts.formula;
  if (several) return;
  if (said.target.low) series.target.low = series.factor * *said.target.low;
  if (said.target.high) series.target.high = series.factor * *said.target.high;
}

// Choosing a person changes the selection and the metric: the attempts of the group are read once, after both.
void PersonPanel::show_group() { group_later_.start(); }

void PersonPanel::draw_group() {
  if (!group_ || tabs_->currentWidget() != group_plot_->parentWidget() || !isVisible()) return;
  group_plot_->set_figure(group_figure(group_(lesson_->currentData().toString().toStdString()), metric_->currentData().toString()));
}

void PersonPanel::set_theme(const UiTheme& theme) {
  group_plot_->set_theme(theme);
  chart_->set_theme(theme);
  bars_->set_theme(theme);
}

void PersonPanel::focus_attempts() {
  tabs_->setCurrentIndex(1);
  if (!table_->selectionModel()->hasSelection()) table_->selectRow(0);
  table_->setFocus();
}

// the lesson is read only while the panel is visible
void PersonPanel::showEvent(QShowEvent*) { show_metric(); }

void PersonPanel::show_person(const QString& name, std::vector<record::AttemptRow> attempts) {
  const QString chosen = name == name_->text() ? chosen_attempt() : QString();
  name_->setText(name);
  all_ = std::move(attempts);
  fill_lessons();
  show_attempts();
  for (int row = 0; !chosen.isEmpty() && row < sorted_->rowCount(); ++row) {
    if (sorted_->index(row, 0).data(AttemptsModel::kId).toString() == chosen) table_->selectRow(row);
  }
  choose_newest();
}

// the lessons of this person's attempts, newest first
void PersonPanel::fill_lessons() {
  const bool same = lesson_->count() > 0 && shown_id_ == (all_.empty() ? std::string() : all_.front().person_id);
  const QString before = lesson_->currentData().toString();
  const QSignalBlocker quiet(lesson_);
  shown_id_ = all_.empty() ? std::string() : all_.front().person_id;
  lesson_->clear();
  lesson_->addItem(tr("All lessons"), QString());
  for (const record::AttemptRow& a : all_) {
    const QString id = QString::fromStdString(a.lesson_id);
    if (lesson_->findData(id) < 0)
      lesson_->addItem(said(a.lesson_title.empty() ? a.lesson_id : a.lesson_title), id);
  }
  // for another person the newest lesson is selected, as all lessons together have no learning curve
  const int at = lesson_->findData(before), newest = lesson_->count() > 1 ? 1 : 0;
  lesson_->setCurrentIndex(same && at >= 0 ? at : newest);
}

void PersonPanel::show_attempts() {
  const std::string lesson = lesson_->currentData().toString().toStdString();
  std::vector<record::AttemptRow> shown;
  int counted = 0, met = 0;
  for (const record::AttemptRow& a : all_) {
    if (!lesson.empty() && a.lesson_id != lesson) continue;
    shown.push_back(a);
    counted += counts(a);
    met += counts(a) && a.outcome == "passed";
  }
  attempts_->set_attempts(shown);
  update_buttons();
  // listed attempts that do not count are mentioned, so that the count agrees with the table of people
  const int others = static_cast<int>(shown.size()) - counted;
  summary_->setText(tr("%1 of %2 attempts passed").arg(met).arg(counted) + (others > 0 ? tr(", %1 more not counted").arg(others) : QString()));
  summary_->setToolTip(tr("Counted is what a person finished. Recorded hands, void attempts and those that were stopped count for nobody."));
  const QString before = metric_->currentData().toString();
  const QSignalBlocker quiet(metric_);
  metric_->clear();
  for (const QString& id : metric_ids(attempts_->attempts())) metric_->addItem(metric_title(id), id);
  metric_->setCurrentIndex(std::max(0, metric_->findData(before)));
  show_metric();
}

void PersonPanel::show_metric() {
  MetricSeries series = metric_series(attempts_->attempts(), metric_->currentData().toString());
  ask_lesson(series);
  const std::string lesson = only_lesson();
  if (!lesson.empty()) fit_series(series);
  if (lesson.empty() && !series.points.isEmpty()) series.fit = tr("These are several lessons. Choose one to see its learning curve.");
  if (!lesson.empty() && experts_ && isVisible() && metric_show(series.id) != SWAGE_SHOW_YES_NO) {
    const Experts them = experts_(lesson, series.id);
    const judge::Band band = judge::expert_band(them.values);
    if (band.attempts > 0) series.experts = {{series.factor * band.p10, series.factor * band.p90}};
    series.who = them.who;
  }
  chart_->set_series(series);
  curve_->setText(series.fit);
  show_bars();
  show_group();
}

}  // namespace swage::console
