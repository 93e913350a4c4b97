// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/review_tables.hpp"

#include <QHeaderView>
#include <utility>

#include "console/models/metric_limits.hpp"
#include "console/models/words.hpp"

namespace swage::console {
namespace {

constexpr int kValueColumn = 1;
constexpr int kOtherColumn = 3;  // of the metrics: those of the compared attempt
constexpr int kAsked = Qt::UserRole, kIsBeyond = Qt::UserRole + 1;  // what is asked of a metric; whether a value is outside it
constexpr int kMostTraces = 6;   // with more each trace would be too low
constexpr int kFirstTraces = 4;  // chosen at first

void dress(QTableWidget& table, const QStringList& heads, int stretch, const char* name, const QString& accessible) {
  table.setColumnCount(static_cast<int>(heads.size()));
  table.setObjectName(QString::fromLatin1(name));
  table.setAccessibleName(accessible);
  table.setHorizontalHeaderLabels(heads);
  table.setShowGrid(false);
  table.setSelectionBehavior(QAbstractItemView::SelectRows);
  table.setSelectionMode(QAbstractItemView::SingleSelection);
  table.setEditTriggers(QAbstractItemView::NoEditTriggers);
  table.setTabKeyNavigation(false);
  table.verticalHeader()->hide();
  table.verticalHeader()->setDefaultSectionSize(24);
  table.horizontalHeader()->setHighlightSections(false);
  table.horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table.horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table.horizontalHeader()->setSectionResizeMode(stretch, QHeaderView::Stretch);
}

QTableWidgetItem* cell(const QString& text, const QString& tip = {}) {
  auto* out = new QTableWidgetItem(text);
  out->setToolTip(tip.isEmpty() ? text : tip);
  return out;
}

QString tip_of(const MetricLine& m) { return m.asked.isEmpty() ? m.doc : m.asked + QLatin1Char('\n') + m.doc; }

}  // namespace

MetricsTable::MetricsTable(QWidget* parent) : QTableWidget(parent) {
  dress(*this, {tr("Metric"), tr("Value"), tr("Better"), tr("Other attempt")}, 0, "review_metrics", tr("Metrics"));
  setColumnHidden(kOtherColumn, true);
  connect(this, &QTableWidget::currentCellChanged, this, &MetricsTable::tell);
}

void MetricsTable::set_theme(const UiTheme& ui) {
  beyond_ = ui["warn"];
  for (int row = 0; row < rowCount(); ++row)
    for (const int column : {kValueColumn, kOtherColumn})
      if (QTableWidgetItem* value = item(row, column); value && value->data(kIsBeyond).toBool()) value->setForeground(beyond_);
}

void MetricsTable::tell(int row) {
  const QTableWidgetItem* name = row < 0 ? nullptr : item(row, 0);
  Q_EMIT asked(name ? name->data(kAsked).toString() : QString());
}

// The value of this attempt or of the other one, with a sign where it is outside what the lesson asks of the metric.
QTableWidgetItem* MetricsTable::value_cell(const MetricLine& line, const MetricLine& metric) const {
  const Beyond where = beyond(line.number, metric.target);
  QTableWidgetItem* out = cell(marked_value(line, metric.target), tip_of(metric));
  out->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  if (where == Beyond::kNo) return out;
  out->setData(kIsBeyond, true);
  out->setData(Qt::AccessibleTextRole, tr("%1, beyond the limit. %2").arg(line.value, metric.asked));
  if (beyond_.isValid()) out->setForeground(beyond_);
  return out;
}

void MetricsTable::add(const MetricLine& m, const Review* other) {
  const int at = rowCount();
  insertRow(at);
  setItem(at, 0, cell(m.name, tip_of(m)));
  item(at, 0)->setData(kAsked, m.asked);
  setItem(at, kValueColumn, value_cell(m, m));
  if (other) {
    const MetricLine* same = other->metric(m.id);
    setItem(at, kOtherColumn, same ? value_cell(*same, m) : cell(QStringLiteral("–"), tip_of(m)));
    item(at, kOtherColumn)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
  }
  if (m.points) return;
  // the arrow alone, as text would leave too little room for the names on a small screen
  setItem(at, 2, cell(better_words(m.better).left(1), better_words(m.better, false)));
  item(at, 2)->setTextAlignment(Qt::AlignHCenter | Qt::AlignVCenter);
  item(at, 2)->setData(Qt::AccessibleTextRole, better_words(m.better, false));
}

void MetricsTable::add_heading() {
  const int at = rowCount();
  insertRow(at);
  QTableWidgetItem* head = cell(tr("Points lost, of 100"), tr("What each fault has cost of the score"));
  QFont bold = font();
  bold.setBold(true);
  head->setFont(bold);
  setItem(at, 0, head);
  setSpan(at, 0, 1, columnCount());
}

void MetricsTable::fill(const Review& review, const Review* other) {
  clearSpans();
  setRowCount(0);
  setColumnHidden(kOtherColumn, !other);
  // what is beyond its limit comes first: on a small screen the table shows six lines
  for (const MetricLine* m : by_limit(review)) add(*m, other);
  bool headed = false;
  for (const MetricLine& m : review.metrics) {
    if (!m.points) continue;
    if (!std::exchange(headed, true)) add_heading();
    add(m, other);
  }
}

MomentsTable::MomentsTable(QWidget* parent) : QTableWidget(parent) {
  dress(*this, {tr("Time"), tr("What happened"), tr("Meaning")}, 2, "review_moments", tr("What happened"));
  // a sentence that does not fit takes a second line
  setWordWrap(true);
  verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  const auto choose = [this](int at) {
    if (at >= 0) Q_EMIT chosen(item(at, 0)->data(Qt::UserRole).toDouble());
  };
  connect(this, &QTableWidget::cellClicked, this, choose);
  connect(this, &QTableWidget::cellActivated, this, choose);
}

void MomentsTable::fill(const QVector<Moment>& moments) {
  setRowCount(0);
  for (const Moment& m : moments) {
    if (m.technical) continue;
    const int at = rowCount();
    insertRow(at);
    setItem(at, 0, cell(tr("%L1 s").arg(m.time_s, 0, 'f', 2)));
    item(at, 0)->setData(Qt::UserRole, m.time_s);
    setItem(at, 1, cell(m.what));
    setItem(at, 2, cell(m.means));
  }
}

WorstTable::WorstTable(QWidget* parent) : QTableWidget(parent) {
  dress(*this, {tr("Time"), tr("What")}, 1, "review_worst", tr("Worst moments"));
  setToolTip(tr("A click goes there, Enter or a double click plays it again and again; W: the next"));
  connect(this, &QTableWidget::cellClicked, this, &WorstTable::go_to);
  connect(this, &QTableWidget::cellActivated, this, [this](int at) {
    go_to(at);
    Q_EMIT loop();
  });
}

void WorstTable::fill(const QVector<WorstMoment>& worst) {
  setRowCount(static_cast<int>(worst.size()));
  times_s_.clear();
  for (int i = 0; i < worst.size(); ++i) {
    const WorstMoment& m = worst[i];
    times_s_ += m.time_s;
    const QString words[] = {tr("%L1 s").arg(m.time_s, 0, 'f', 2), (m.weight >= kOverLimit ? QStringLiteral("▲ ") : QString()) + m.what};
    for (int c = 0; c < 2; ++c) setItem(i, c, cell(words[c], m.tip));
  }
}

void WorstTable::go_to(int at) {
  if (at < 0 || at >= times_s_.size()) return;
  setCurrentCell(at, 0);
  Q_EMIT chosen(times_s_[at]);
}

void WorstTable::next() {
  if (times_s_.isEmpty()) return;
  go_to(currentRow() < 0 || !visited_ ? 0 : (currentRow() + 1) % static_cast<int>(times_s_.size()));
  visited_ = true;
}

TracesList::TracesList(QWidget* parent) : QListWidget(parent) {
  setObjectName(QStringLiteral("review_traces"));
  setAccessibleName(tr("Which traces are shown"));
  connect(this, &QListWidget::itemChanged, this, &TracesList::tell);
}

void TracesList::fill(const QVector<Trace>& traces) {
  {
    const QSignalBlocker quiet(this);
    clear();
    int chosen = 0;
    for (const Trace& t : traces) {
      auto* entry = new QListWidgetItem(t.flat ? tr("%1 (never changes)").arg(t.name) : t.name, this);
      entry->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
      const bool on = t.wanted && chosen < kFirstTraces;
      chosen += on;
      entry->setCheckState(on ? Qt::Checked : Qt::Unchecked);
      entry->setToolTip(t.tip);
    }
  }
  tell();
}

void TracesList::tell() {
  QVector<int> traces;
  for (int i = 0; i < count() && traces.size() < kMostTraces; ++i) {
    if (item(i)->checkState() == Qt::Checked) traces += i;
  }
  Q_EMIT shown(traces);
}

}  // namespace swage::console
