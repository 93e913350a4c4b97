// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QSortFilterProxyModel>
#include <QVector>

#include "judge/verdict.hpp"

namespace swage::console {

/// The events of the running attempt, newest last.
class EventLog : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kTime, kWhat, kMeans, kColumns };
  struct Row {
    double time_s = 0;
    QString what, means;
    bool by_person = false;  // a note, a pause: not from the scene
    bool technical = false;  // about the machine: shown with the instructor's details only
  };

  using QAbstractTableModel::QAbstractTableModel;
  void clear();
  void add(const judge::Event& event, const judge::Script& script, double dt);
  void note(double time_s, const QString& what, const QString& means = {});
  const Row& at(int row) const { return rows_[row]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  void append(const Row& row);
  QVector<Row> rows_;
};

/// The events for the trainee: without missed deadlines and other technical events, unless these are asked for.
class EventFilter : public QSortFilterProxyModel {
  Q_OBJECT
 public:
  explicit EventFilter(EventLog* log, QObject* parent = nullptr);
  void show_technical(bool on);
  int hidden() const;  // number of hidden rows

 protected:
  bool filterAcceptsRow(int row, const QModelIndex& parent) const override;

 private:
  EventLog* log_;
  bool technical_ = false;
};

}  // namespace swage::console
