// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/limits_panel.hpp"

#include <QAbstractItemDelegate>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "console/models/course_words.hpp"
#include "console/models/metric_bars.hpp"
#include "console/models/metric_titles.hpp"
#include "console/models/words.hpp"
#include "console/widgets/parts.hpp"

namespace swage::console {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

enum LimitColumn { kMetric, kLeast, kMost, kGate, kSource };

// A number that an instructor typed is shown as typed; one that was computed, with three digits.
QString shown(double value, const judge::Limit& limit, const QString& unit) {
  const int digits = limit.source == "instructor" ? 6 : 3;
  return std::isfinite(value) ? QLocale().toString(value * display_factor(unit), 'g', digits) : QString();
}

// "Time" alone would be read as a value in seconds
QString limit_title(const QString& id) {
  return id.startsWith(QLatin1String("points.")) ? LimitsPanel::tr("Points lost: %1").arg(metric_title(id)) : metric_title(id);
}

}  // namespace

LimitsPanel::LimitsPanel(CourseEditing* editing, QWidget* parent) : QWidget(parent), editing_(editing) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  Card card = make_card(tr("Limits, besides the lesson's own verdict"), this);
  make_table(card.frame);
  card.body->addWidget(table_, 1);
  together_ = make_muted({}, card.frame);
  together_->setObjectName(QStringLiteral("together"));
  card.body->addWidget(together_);
  card.body->addLayout(make_buttons(card.frame));
  column->addWidget(card.frame);
}

void LimitsPanel::make_table(QWidget* parent) {
  table_ = new QTableWidget(0, 5, parent);
  table_->setObjectName(QStringLiteral("limits"));
  table_->setAccessibleName(tr("Limits"));
  table_->setHorizontalHeaderLabels({tr("Metric"), tr("At least"), tr("At most"), tr("Safety"), tr("Source")});
  table_->verticalHeader()->hide();
  table_->setShowGrid(false);
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setTabKeyNavigation(false);
  table_->setMinimumHeight(130);
  table_->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
  table_->horizontalHeader()->setHighlightSections(false);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  table_->setToolTip(tr("F2 or a double click changes a value; empty asks for nothing"));
  connect(table_, &QTableWidget::cellChanged, this, &LimitsPanel::edit_cell);
  // queued, as the table still uses the row while its editor closes
  connect(table_->itemDelegate(), &QAbstractItemDelegate::closeEditor, this, &LimitsPanel::drop_wanted, Qt::QueuedConnection);
}

QLayout* LimitsPanel::make_buttons(QWidget* parent) {
  constexpr int kLeastMetric = 18;  // letters; the open list shows all
  row_ = new QBoxLayout(QBoxLayout::LeftToRight);
  metric_ = new QComboBox(parent);
  metric_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  metric_->setMinimumContentsLength(kLeastMetric);
  metric_->setObjectName(QStringLiteral("limit_metric"));
  metric_->setAccessibleName(tr("Metric to limit"));
  metric_->setPlaceholderText(tr("The metrics of this lesson are not known here"));
  row_->addWidget(metric_, 1);
  auto* buttons = new QHBoxLayout;
  const auto add = [&](const QString& words, const char* key, const char* name, void (LimitsPanel::*call)()) {
    auto* button = make_button(words, {}, QString::fromLatin1(name), parent);
    if (call == &LimitsPanel::suggest) button->setToolTip(tr("Each limit such that all but the worst tenth of the experts' attempts keep it"));
    give_key(button, QString::fromLatin1(key));
    connect(button, &QPushButton::clicked, this, call);
    buttons->addWidget(button);
  };
  add(tr("Add limit"), "Ctrl+M", "add_limit", &LimitsPanel::add_limit);
  add(tr("Remove limit"), "Ctrl+Shift+M", "remove_limit", &LimitsPanel::remove_limit);
  add(tr("From experts"), "Ctrl+E", "suggest_limits", &LimitsPanel::suggest);
  row_->addLayout(buttons);
  return row_;
}

void LimitsPanel::set_narrow(bool narrow) { row_->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight); }

// with the limit whose number is being typed as the last row
void LimitsPanel::fill() {
  const record::CourseStep* s = editing_->step();
  if (!s) return;
  const auto quiet = editing_->quiet();
  std::vector<judge::Limit> all = s->limits;
  if (wanted_) all.push_back(*wanted_);
  table_->setRowCount(static_cast<int>(all.size()));
  for (int i = 0; i < table_->rowCount(); ++i) {
    const judge::Limit& l = all[static_cast<size_t>(i)];
    const QString id = QString::fromStdString(l.metric), unit = metric_unit(id, QString::fromStdString(l.unit));
    const QString suffix = display_unit(unit);
    const QString cells[] = {suffix.isEmpty() ? limit_title(id) : tr("%1, %2").arg(limit_title(id), suffix), shown(l.least, l, unit),
                             shown(l.most, l, unit), QString(), QString::fromStdString(l.source)};
    for (int c = 0; c < table_->columnCount(); ++c) {
      auto* item = new QTableWidgetItem(cells[c]);
      item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
      if (c == kLeast || c == kMost) item->setFlags(item->flags() | Qt::ItemIsEditable);
      if (c == kGate) item->setFlags(item->flags() | Qt::ItemIsUserCheckable), item->setCheckState(l.is_gate ? Qt::Checked : Qt::Unchecked);
      table_->setItem(i, c, item);
    }
  }
}

void LimitsPanel::refresh() {
  const record::CourseStep* s = editing_->step();
  if (!s) return;
  const int row = table_->currentRow(), column = table_->currentColumn();
  wanted_.reset();
  fill();
  if (row >= 0) table_->setCurrentCell(std::min(row, table_->rowCount() - 1), column);
  metric_->clear();
  for (const LessonMetric& m : editing_->metrics()) {
    const auto same = [&](const judge::Limit& l) { return l.metric == m.id.toStdString(); };
    if (std::none_of(s->limits.begin(), s->limits.end(), same)) metric_->addItem(limit_title(m.id), m.id);
  }
  metric_->setCurrentIndex(metric_->count() > 0 ? 0 : -1);  // a QComboBox with a placeholder text selects no item by itself
  together_->setText(s->limits.empty() ? tr("No limits: the lesson's own verdict is all that is asked.")
                                       : together_words(s->limits, editing_->experts()));
}

void LimitsPanel::add_limit() {
  if (!editing_->step()) return;
  judge::Limit fresh;
  fresh.metric = metric_->currentData().toString().toStdString();
  int32_t better = 0;
  for (const LessonMetric& m : editing_->metrics())
    if (m.id.toStdString() == fresh.metric) fresh.unit = m.unit.toStdString(), better = m.better;
  if (fresh.metric.empty()) return refused(tr("The metrics of this lesson are not known here: is it installed?"));
  const bool known = suggest_limit(fresh, editing_->experts(), better);
  const LimitColumn column = better == SWAGE_BETTER_HIGHER ? kLeast : kMost;
  if (known) {
    editing_->edit_step(tr("Add a limit"), [&](record::CourseStep& c) { c.limits.push_back(fresh); });
    return table_->setCurrentCell(table_->rowCount() - 1, column);
  }
  wanted_ = fresh;
  fill();
  table_->setCurrentCell(table_->rowCount() - 1, column);
  table_->editItem(table_->currentItem());
}

void LimitsPanel::remove_limit() {
  const auto at = table_->currentRow();
  const record::CourseStep* s = editing_->step();
  if (s && static_cast<size_t>(std::max(at, 0)) >= s->limits.size()) return drop_wanted();
  if (at >= 0) editing_->edit_step(tr("Remove a limit"), [&](record::CourseStep& c) { c.limits.erase(c.limits.begin() + at); });
}

// A limit whose number was not typed is dropped: none was written.
void LimitsPanel::drop_wanted() {
  if (!wanted_) return;
  wanted_.reset();
  refresh();
}

void LimitsPanel::edit_cell(int row, int column) {
  const record::CourseStep* s = editing_->step();
  if (editing_->filling() || !s) return;
  const QString text = table_->item(row, column)->text().trimmed();
  const bool is_new = static_cast<size_t>(row) == s->limits.size();
  if (is_new && (!wanted_ || text.isEmpty())) return;
  const judge::Limit now = is_new ? *wanted_ : s->limits[static_cast<size_t>(row)];
  const QString unit = metric_unit(QString::fromStdString(now.metric), QString::fromStdString(now.unit));
  bool ok = false;
  double value = QLocale().toDouble(text, &ok);
  if (!ok) value = text.toDouble(&ok);
  if (column != kGate && !text.isEmpty() && !ok) {
    Q_EMIT refused(is_new ? tr("\"%1\" is no number; no limit is added.").arg(text)
                          : tr("\"%1\" is no number; the limit stays as it was.").arg(text));
    return refresh();
  }
  const bool gate = table_->item(row, kGate)->checkState() == Qt::Checked;
  wanted_.reset();
  editing_->edit_step(is_new ? tr("Add a limit") : tr("Limit"), [&](record::CourseStep& c) {
    if (is_new) c.limits.push_back(now);
    judge::Limit& l = c.limits[static_cast<size_t>(row)];
    const double si = value / display_factor(unit);
    if (column == kLeast) l.least = text.isEmpty() ? -kInfinite : si;
    if (column == kMost) l.most = text.isEmpty() ? kInfinite : si;
    if (column == kGate) l.is_gate = gate;
    if (column != kGate) l.source = "instructor";
  });
}

void LimitsPanel::suggest() {
  const record::CourseStep* s = editing_->step();
  if (!s) return;
  const auto metrics = editing_->metrics();
  const auto them = editing_->experts();
  if (them.empty() || s->limits.empty())
    return refused(s->limits.empty() ? tr("There is no limit yet to take from the experts: add one first.")
                                     : tr("No attempts of experts at this lesson: no limit is changed. Experts are the people of "
                                          "the group \"Experts\"."));
  editing_->edit_step(tr("Limits from experts"), [&](record::CourseStep& c) {
    for (judge::Limit& l : c.limits)
      for (const LessonMetric& m : metrics)
        if (m.id.toStdString() == l.metric) suggest_limit(l, them, m.better);
  });
}

}  // namespace swage::console
