// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QHash>
#include <QVector>

#include "console/models/standing.hpp"
#include "record/store.hpp"

namespace swage::console {

/// All people in the store with their standing. Sort by kSortRole.
class PeopleModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kName, kGroup, kCourse, kLast, kPassed, kSeen, kAttention, kColumns };
  enum Role { kId = Qt::UserRole, kSortRole, kGroupRole };

  using QAbstractTableModel::QAbstractTableModel;
  /// `attempts`: of all people, newest first. `groups`: name by id. `courses`: assigned courses, by person.
  void set_people(const std::vector<record::Person>& people, const std::vector<record::AttemptRow>& attempts,
                  const QHash<QString, QString>& groups = {}, const QHash<QString, QString>& courses = {},
                  const QDateTime& now = QDateTime::currentDateTimeUtc());
  int row_of(const QString& id) const;
  QStringList names() const;
  const record::Person& at(int row) const { return people_[row]; }
  const Standing& standing(int row) const { return standings_[row]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QVariant text(int row, int column) const;
  QVector<record::Person> people_;
  QVector<Standing> standings_;
  QHash<QString, QString> groups_, courses_;
};

}  // namespace swage::console
