// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/event_log.hpp"

#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "host/words.hpp"
#include "judge/host_events.hpp"

namespace swage::console {
namespace {

// the end of an event's doc explains its value, which is not shown here
QString meaning(const std::string& doc) {
  const QString text = said_event(doc);
  const bool whole = host::without_value(doc).size() == doc.size() || text.endsWith(QLatin1Char('.'));
  return whole ? text : text + QLatin1Char('.');
}

// true for events about the machine, not the trainee
bool is_technical(const judge::Name& event) {
  return event.owner == judge::kHostOwner && event.id != "host.reset" && event.id != "host.quarantined";
}

}  // namespace

void EventLog::clear() {
  beginResetModel();
  rows_.clear();
  endResetModel();
}

void EventLog::append(const Row& row) {
  const int at = static_cast<int>(rows_.size());
  beginInsertRows({}, at, at);
  rows_.append(row);
  endInsertRows();
}

void EventLog::add(const judge::Event& event, const judge::Script& script, double dt) {
  if (event.event >= script.events.size()) return;
  const judge::Name& name = script.events[event.event];
  append({static_cast<double>(event.step) * dt, said_name(name, script.events), meaning(name.doc),
          false, is_technical(name)});
}

void EventLog::note(double time_s, const QString& what, const QString& means) { append({time_s, what, means, true, false}); }

int EventLog::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int EventLog::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant EventLog::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rows_.size()) return {};
  const Row& row = rows_[index.row()];
  if (role == Qt::TextAlignmentRole && index.column() == kTime) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role == Qt::ToolTipRole)
    return QStringLiteral("%1  %2").arg(clock_text(row.time_s), row.means.isEmpty() ? row.what : row.means);
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case kTime:
      return QStringLiteral("%1.%2").arg(clock_text(row.time_s)).arg(int(row.time_s * 10) % 10);
    case kWhat:
      return row.what;
    case kMeans:
      return row.means;
    default:
      return {};
  }
}

QVariant EventLog::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole)
    return int((section == kTime ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kTime:
      return tr("Time");
    case kWhat:
      return tr("What happened");
    case kMeans:
      return tr("Meaning");
    default:
      return {};
  }
}

EventFilter::EventFilter(EventLog* log, QObject* parent) : QSortFilterProxyModel(parent), log_(log) {
  setSourceModel(log);
}

void EventFilter::show_technical(bool on) {
  technical_ = on;
  invalidateFilter();
}

int EventFilter::hidden() const { return log_->rowCount() - rowCount(); }

bool EventFilter::filterAcceptsRow(int row, const QModelIndex&) const {
  return technical_ || !log_->at(row).technical;
}

}  // namespace swage::console
