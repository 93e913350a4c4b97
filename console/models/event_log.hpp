// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QVector>

#include "judge/verdict.hpp"

namespace swage::console {

/// What happened in the running attempt, newest last.
class EventLog : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kTime, kWhat, kMeans, kColumns };
  struct Row {
    double time_s = 0;
    QString what, means;
    bool by_person = false;  // a mark, a pause: not from the scene
  };

  using QAbstractTableModel::QAbstractTableModel;
  void clear();
  void add(const judge::Event& event, const judge::Script& script, double dt);
  void note(double time_s, const QString& what);
  const Row& at(int row) const { return rows_[row]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void append(const Row& row);
  QVector<Row> rows_;
};

}  // namespace swage::console
