// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/person_panel.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QVBoxLayout>
#include <algorithm>

#include "console/models/metric_titles.hpp"
#include "console/models/words.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kCurve = 8;  // fewer points tell no curve

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
  Card plot = make_card({}, this);
  chart_ = new MetricChart(plot.frame);
  plot.body->addWidget(chart_, 1);
  curve_ = make_muted({}, plot.frame);
  curve_->setObjectName(QStringLiteral("curve_words"));
  plot.body->addWidget(curve_);
  return plot.frame;
}

QWidget* PersonPanel::make_attempts() {
  Card list = make_card({}, this);
  table_ = new QTableView(list.frame);
  table_->setObjectName(QStringLiteral("attempts"));
  table_->setAccessibleName(tr("Attempts"));
  table_->setModel(sorted_);
  table_->setSortingEnabled(true);
  table_->sortByColumn(AttemptsModel::kWhen, Qt::DescendingOrder);
  table_->setShowGrid(false);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setTabKeyNavigation(false);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setDefaultSectionSize(28);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(AttemptsModel::kReason, QHeaderView::Stretch);
  table_->setSelectionMode(QAbstractItemView::SingleSelection);
  table_->setToolTip(tr("Enter or a double click opens the attempt"));
  list.body->addWidget(table_, 1);
  review_ =
      make_button(tr("Review this attempt"), QStringLiteral("Enter"), QStringLiteral("review"), list.frame);
  review_->setEnabled(false);
  auto* open = make_button(tr("Open..."), QStringLiteral("Ctrl+O"), QStringLiteral("open_attempt"), list.frame);
  open->setToolTip(tr("Look at an attempt that was saved to a file (Ctrl+O)"));
  connect(open, &QPushButton::clicked, this, &PersonPanel::open_file);
  attempt_buttons_ = new QHBoxLayout;
  attempt_buttons_->addStretch(1);
  attempt_buttons_->addWidget(open);
  attempt_buttons_->addWidget(review_);
  list.body->addLayout(attempt_buttons_);
  connect(review_, &QPushButton::clicked, this, &PersonPanel::review_current);
  connect(table_, &QTableView::activated, this, &PersonPanel::review_current);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          [this] { review_->setEnabled(table_->selectionModel()->hasSelection()); });
  return list.frame;
}

QString PersonPanel::chosen_attempt() const {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  return rows.isEmpty() ? QString() : rows.first().data(AttemptsModel::kId).toString();
}

void PersonPanel::review_current() {
  if (const QString id = chosen_attempt(); !id.isEmpty()) Q_EMIT review(id);
}

// Asked only while it is seen: a lesson is opened for that. A target is of one lesson; attempts of several have several.
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

void PersonPanel::set_theme(const UiTheme& theme) { chart_->set_theme(theme); }

void PersonPanel::focus_attempts() {
  tabs_->setCurrentIndex(1);
  if (!table_->selectionModel()->hasSelection()) table_->selectRow(0);
  table_->setFocus();
}

// a lesson is only asked while somebody looks
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
}

// the lessons that this person has done
void PersonPanel::fill_lessons() {
  const QString before = lesson_->currentData().toString();
  const QSignalBlocker quiet(lesson_);
  lesson_->clear();
  lesson_->addItem(tr("All lessons"), QString());
  for (const record::AttemptRow& a : all_) {
    const QString id = QString::fromStdString(a.lesson_id);
    if (lesson_->findData(id) < 0)
      lesson_->addItem(QString::fromStdString(a.lesson_title.empty() ? a.lesson_id : a.lesson_title), id);
  }
  lesson_->setCurrentIndex(std::max(0, lesson_->findData(before)));
}

void PersonPanel::show_attempts() {
  const std::string lesson = lesson_->currentData().toString().toStdString();
  std::vector<record::AttemptRow> shown;
  int met = 0;
  for (const record::AttemptRow& a : all_) {
    if (!lesson.empty() && a.lesson_id != lesson) continue;
    shown.push_back(a);
    met += a.outcome == "passed" && !a.is_void && !is_hand(a);
  }
  attempts_->set_attempts(shown);
  review_->setEnabled(false);
  summary_->setText(shown.size() == 1 ? tr("1 attempt, %1 passed").arg(met)
                                      : tr("%1 attempts, %2 passed").arg(shown.size()).arg(met));
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
  chart_->set_series(series);
  const auto n = static_cast<int>(series.points.size());
  curve_->setText(n >= kCurve
                      ? QString()
                      : tr("A curve needs %1 finished attempts. %2 more.").arg(kCurve).arg(kCurve - n));
  curve_->setVisible(n < kCurve);
}

}  // namespace swage::console
