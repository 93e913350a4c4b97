// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QAbstractListModel>
#include <QVector>

#include "record/store.hpp"

namespace swage::console {

/// Who has attempts in the store.
class PeopleModel : public QAbstractListModel {
  Q_OBJECT
 public:
  enum Role { kId = Qt::UserRole, kSummary };

  using QAbstractListModel::QAbstractListModel;
  void set_people(const std::vector<record::Person>& people);
  int row_of(const QString& id) const;
  QStringList names() const;

  int rowCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;

 private:
  QVector<record::Person> people_;
};

}  // namespace swage::console
