// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/progress_page.hpp"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QSplitter>
#include <QVBoxLayout>
#include <algorithm>

#include "console/models/metric_titles.hpp"
#include "console/models/words.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr int kCurve = 8;  // fewer points tell no curve
constexpr int kWatch_ms = 2000;  // what others have written appears that soon; a look costs under a millisecond

}  // namespace

ProgressPage::ProgressPage(StoreOpener opener, QWidget* parent)
    : QWidget(parent),
      opener_(std::move(opener)),
      people_(new PeopleModel(this)),
      attempts_(new AttemptsModel(this)),
      sorted_(new QSortFilterProxyModel(this)) {
  sorted_->setSourceModel(attempts_);
  sorted_->setSortRole(AttemptsModel::kSortRole);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(12, 10, 12, 6);
  stack_ = new QStackedWidget(this);
  auto* full = new QWidget(stack_);
  auto* columns = new QHBoxLayout(full);
  columns->setContentsMargins(0, 0, 0, 0);
  columns->setSpacing(12);
  QWidget* people = make_people();
  people->setFixedWidth(286);
  columns->addWidget(people);
  columns->addWidget(make_person(), 1);
  stack_->addWidget(full);
  stack_->addWidget(make_empty());
  row->addWidget(stack_);
  watch_.setInterval(kWatch_ms);
  connect(&watch_, &QTimer::timeout, this, &ProgressPage::look);
  watch_.start();
}

// what other programs and stations have written; nothing is asked while nobody looks
void ProgressPage::look() {
  if (isVisible() && store_ && !broken_ && store_->changed()) refresh();
}

QWidget* ProgressPage::make_people() {
  Card card = make_card(tr("People"), this);
  people_view_ = new QListView(card.frame);
  people_view_->setObjectName(QStringLiteral("people"));
  people_view_->setAccessibleName(tr("People"));
  people_view_->setModel(people_);
  people_view_->setItemDelegate(new TwoLineDelegate(PeopleModel::kSummary, people_view_));
  card.body->addWidget(people_view_, 1);
  connect(people_view_->selectionModel(), &QItemSelectionModel::currentChanged, this,
          &ProgressPage::show_person);
  return card.frame;
}

QWidget* ProgressPage::make_person() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(10);
  auto* head = new QHBoxLayout;
  name_ = new QLabel(box);
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
  column->addLayout(head);
  connect(lesson_, &QComboBox::currentIndexChanged, this, &ProgressPage::show_attempts);
  connect(metric_, &QComboBox::currentIndexChanged, this, &ProgressPage::show_metric);

  Card plot = make_card({}, box);
  chart_ = new MetricChart(plot.frame);
  plot.body->addWidget(chart_, 1);
  curve_ = make_muted({}, plot.frame);
  plot.body->addWidget(curve_);
  column->addWidget(plot.frame, 3);

  Card list = make_card(tr("Attempts"), box);
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
  connect(open, &QPushButton::clicked, this, &ProgressPage::open_file);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch(1);
  buttons->addWidget(open);
  buttons->addWidget(review_);
  list.body->addLayout(buttons);
  connect(review_, &QPushButton::clicked, this, &ProgressPage::review_current);
  connect(table_, &QTableView::activated, this, &ProgressPage::review_current);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this,
          [this] { review_->setEnabled(table_->selectionModel()->hasSelection()); });
  column->addWidget(list.frame, 2);
  return box;
}

QWidget* ProgressPage::make_empty() {
  auto* box = new QWidget(this);
  auto* column = new QVBoxLayout(box);
  empty_ = new QLabel(box);
  empty_->setObjectName(QStringLiteral("empty"));
  empty_->setAlignment(Qt::AlignCenter);
  empty_->setWordWrap(true);
  auto* go = make_button(tr("Run a lesson"), QStringLiteral("Ctrl+1"), QStringLiteral("run_lesson"), box);
  connect(go, &QPushButton::clicked, this, &ProgressPage::run_lesson);
  column->addStretch(2);
  column->addWidget(empty_);
  column->addSpacing(10);
  column->addWidget(go, 0, Qt::AlignHCenter);
  column->addStretch(3);
  return box;
}

void ProgressPage::review_current() {
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  if (!rows.isEmpty()) Q_EMIT review(rows.first().data(AttemptsModel::kId).toString());
}

// Asked only while it is seen: a lesson is opened for that. A target is of one lesson; attempts of several have several.
void ProgressPage::ask_lesson(MetricSeries& series) const {
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

void ProgressPage::set_theme(const UiTheme& theme) { chart_->set_theme(theme); }

bool ProgressPage::open() {
  if (store_ && !broken_) return true;
  store_.reset();
  broken_ = false;
  std::string error;
  if (opener_) store_ = opener_(error);
  if (!store_ && !error.empty())
    empty_->setText(tr("The attempts cannot be read: %1").arg(QString::fromStdString(error)));
  if (!store_ && error.empty())
    empty_->setText(tr("Nothing is kept: the program was started without a store."));
  if (!store_) return false;
  if (const int n = store_->recover(); n > 0) Q_EMIT recovered(n);
  return true;
}

// False, and said on the page, when the store no longer gives what it holds.
bool ProgressPage::reads() {
  if (store_->trouble().empty()) return true;
  broken_ = true;
  empty_->setText(QString::fromStdString(store_->trouble()));
  stack_->setCurrentIndex(1);
  return false;
}

void ProgressPage::refresh() {
  const QString id = people_view_->currentIndex().data(PeopleModel::kId).toString();
  const QModelIndexList rows = table_->selectionModel()->selectedRows();
  const QString attempt = rows.isEmpty() ? QString() : rows.first().data(AttemptsModel::kId).toString();
  if (!open()) {
    stack_->setCurrentIndex(1);
    return;
  }
  const std::vector<record::Person> people = store_->people();
  if (!reads()) return;
  people_->set_people(people);
  if (people_->rowCount() == 0) {
    empty_->setText(
        tr("No one here yet. Attempts appear here after the first lesson; without a name they are kept for "
           "Guest."));
    stack_->setCurrentIndex(1);
    return;
  }
  stack_->setCurrentIndex(0);
  people_view_->setCurrentIndex(people_->index(std::max(0, people_->row_of(id)), 0));
  for (int row = 0; !attempt.isEmpty() && row < sorted_->rowCount(); ++row) {
    if (sorted_->index(row, 0).data(AttemptsModel::kId).toString() == attempt) table_->selectRow(row);
  }
}

void ProgressPage::focus_attempts() {
  if (!table_->selectionModel()->hasSelection()) table_->selectRow(0);
  table_->setFocus();
}

void ProgressPage::select_person(const QString& name) {
  const qsizetype row = people_->names().indexOf(name);
  if (row >= 0) people_view_->setCurrentIndex(people_->index(static_cast<int>(row), 0));
}

void ProgressPage::show_person() {
  const QModelIndex index = people_view_->currentIndex();
  if (!index.isValid() || !store_) return;
  name_->setText(index.data().toString());
  all_ = store_->attempts(index.data(PeopleModel::kId).toString().toStdString());
  if (!reads()) return;

  // the lessons that this person has done
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
  show_attempts();
}

void ProgressPage::show_attempts() {
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

void ProgressPage::show_metric() {
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
