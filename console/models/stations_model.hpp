// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QString>
#include <functional>
#include <vector>

#include "record/stations.hpp"

namespace swage::console {

/// "● runs", "▲ lost for 12 s": a sign with every state, so that colour is not needed.
QString station_state_text(const record::StationNow& now);
/// Faults of a station in timing, solver, devices or record; "● in order" without any.
QString station_health_text(const record::StationNow& now);
/// "OR 2   Take the tips   ✓ read"
QString sent_text(const record::StationMessage& message);

/// The stations of the school, one per row, sorted by name; a row keeps its place while its station is listed.
class StationsModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kStation, kWho, kLesson, kState, kPhase, kTime, kForce, kCues, kScore, kHealth, kColumns };
  enum Role { kName = Qt::UserRole };

  using QAbstractTableModel::QAbstractTableModel;
  void set_stations(const std::vector<record::StationNow>& stations, const QString& own_name);
  /// Sets the theme's text for the meaning of a cue.
  void set_cue_words(std::function<QString(const QString& meaning)> words);
  int row_of(const QString& name) const;
  const record::StationNow& at(int row) const { return stations_[static_cast<size_t>(row)]; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QString text(const record::StationNow& now, int column) const;
  std::vector<record::StationNow> stations_;
  std::function<QString(const QString&)> cue_words_;
  QString own_;
};

}  // namespace swage::console
