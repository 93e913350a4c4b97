// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/people_model.hpp"

#include "console/models/qt_text.hpp"
#include "console/models/words.hpp"

#include <unordered_map>

namespace swage::console {
namespace {

// newest at the right, as in the chart
QString signs(const QVector<bool>& last) {
  QStringList out;
  for (const bool passed : last) out += passed ? QStringLiteral("✓") : QStringLiteral("✗");
  return out.join(QLatin1Char(' '));
}

QString seen(const Standing& s) {
  if (s.last_utc.isEmpty()) return QObject::tr("not yet");
  return s.days == 0 ? QObject::tr("today") : s.days == 1 ? QObject::tr("yesterday") : QObject::tr("%1 days ago").arg(s.days);
}

}  // namespace

void PeopleModel::set_people(const std::vector<record::Person>& people, const std::vector<record::AttemptRow>& attempts,
                             const QHash<QString, QString>& groups, const QHash<QString, QString>& courses,
                             const QDateTime& now) {
  beginResetModel();
  std::unordered_map<std::string, std::vector<const record::AttemptRow*>> of;
  for (const record::AttemptRow& a : attempts) of[a.person_id].push_back(&a);
  people_.clear();
  standings_.clear();
  groups_ = groups;
  courses_ = courses;
  for (const record::Person& p : people) {
    people_ += p;
    standings_ += standing_of(of[p.id], now);
  }
  endResetModel();
}

int PeopleModel::row_of(const QString& id) const {
  for (int i = 0; i < people_.size(); ++i) {
    if (qt(people_[i].id) == id) return i;
  }
  return -1;
}

QStringList PeopleModel::names() const {
  QStringList names;
  for (const record::Person& p : people_) names += qt(p.name);
  return names;
}

int PeopleModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(people_.size());
}

int PeopleModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant PeopleModel::text(int row, int column) const {
  const record::Person& p = people_[row];
  const Standing& s = standings_[row];
  switch (column) {
    case kName:
      return person_text(qt(p.name));
    case kGroup:
      return groups_.value(qt(p.group_id));
    case kCourse:
      return courses_.value(qt(p.id));
    case kLast:
      return signs(s.last);
    case kPassed:
      return s.attempts == 0 ? QString() : tr("%1 of %2").arg(s.passed).arg(s.attempts);
    case kSeen:
      return seen(s);
    case kAttention:
      return attention_words(s);
    default:
      return {};
  }
}

QVariant PeopleModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= people_.size()) return {};
  const record::Person& p = people_[index.row()];
  const Standing& s = standings_[index.row()];
  switch (role) {
    case Qt::DisplayRole:
      return text(index.row(), index.column());
    case Qt::ToolTipRole:
      return index.column() == kName && p.code != p.name && !p.code.empty() ? tr("%1, kept as %2").arg(qt(p.name), qt(p.code))
             : index.column() == kLast ? tr("The last %n attempt(s), newest at the right: ✓ passed, ✗ not passed", nullptr,
                                            static_cast<int>(s.last.size()))
                                       : text(index.row(), index.column());
    case kId:
      return qt(p.id);
    case kGroupRole:
      return qt(p.group_id);
    case kSortRole:
      if (index.column() == kAttention) return attention(s);
      if (index.column() == kSeen) return s.last_utc;
      if (index.column() == kPassed) return s.passed;
      if (index.column() == kLast) return static_cast<int>(s.last.count(true));
      return text(index.row(), index.column()).toString().toCaseFolded();
    default:
      return {};
  }
}

QVariant PeopleModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) return int(Qt::AlignLeft | Qt::AlignVCenter);
  if (role != Qt::DisplayRole) return {};
  const QString heads[] = {tr("Name"), tr("Group"), tr("Course"), tr("Last attempts"), tr("Passed"), tr("Last seen"), tr("How it goes")};
  return section >= 0 && section < kColumns ? heads[section] : QString();
}

}  // namespace swage::console
