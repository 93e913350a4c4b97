// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/people_model.hpp"

namespace swage::console {

void PeopleModel::set_people(const std::vector<record::Person>& people) {
  beginResetModel();
  people_ = QVector<record::Person>(people.begin(), people.end());
  endResetModel();
}

int PeopleModel::row_of(const QString& id) const {
  for (int i = 0; i < people_.size(); ++i) {
    if (QString::fromStdString(people_[i].id) == id) return i;
  }
  return -1;
}

QStringList PeopleModel::names() const {
  QStringList names;
  for (const record::Person& p : people_) names += QString::fromStdString(p.name);
  return names;
}

int PeopleModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(people_.size());
}

QVariant PeopleModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= people_.size()) return {};
  const record::Person& p = people_[index.row()];
  switch (role) {
    case Qt::DisplayRole:
      return QString::fromStdString(p.name);
    case kId:
      return QString::fromStdString(p.id);
    case kSummary:
    case Qt::AccessibleDescriptionRole:
      return p.attempts == 1 ? tr("1 attempt") : tr("%1 attempts").arg(p.attempts);
    default:
      return {};
  }
}

}  // namespace swage::console
