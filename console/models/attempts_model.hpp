// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QVector>
#include <optional>

#include "console/models/metric_facts.hpp"
#include "record/store.hpp"

namespace swage::console {

/// Attempts of one person, one row each. Sort by kSortRole.
class AttemptsModel : public QAbstractTableModel {
  Q_OBJECT
 public:
  enum Column { kWhen, kLesson, kMode, kVerdict, kScore, kTime, kReason, kColumns };
  enum Role { kSortRole = Qt::UserRole, kId };

  using QAbstractTableModel::QAbstractTableModel;
  void set_attempts(const std::vector<record::AttemptRow>& attempts);
  const QVector<record::AttemptRow>& attempts() const { return rows_; }

  int rowCount(const QModelIndex& parent = {}) const override;
  int columnCount(const QModelIndex& parent = {}) const override;
  QVariant data(const QModelIndex& index, int role) const override;
  QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

 private:
  QVector<record::AttemptRow> rows_;
};

/// An attempt that a scripted or recorded hand made: shown, and no person's progress.
bool is_hand(const record::AttemptRow& attempt);
/// An attempt that counts for its person: judged, not void, not of a recorded hand. Every count and every curve is of these.
bool counts(const record::AttemptRow& attempt);
/// Only an attempt that was passed has a score.
bool has_score(const record::AttemptRow& attempt);

/// One metric over the attempts, oldest first; what a chart draws.
struct MetricPoint {
  double value = 0;  // as shown, in the unit of the series
  bool met = false, test = false;
  QString day, tip;
};
struct MetricSeries {
  QString id, name, unit;
  int32_t better = SWAGE_BETTER_NONE;
  QString formula;      // how it is computed, where the lesson says
  MetricTarget target;  // as shown
  double factor = 1;    // from SI to what is shown
  QVector<double> curve;  // a value per point, where a law of learning was fitted; empty otherwise
  QString fit;            // what the fit says, or why there is none
  std::optional<double> least, most;  // of the metric's own scale, as shown: no value lies beyond
  int failed = 0, without_score = 0;  // not passed: those among the points, and those left out because they have no score
  std::optional<std::pair<double, double>> experts;  // their band, 10 % to 90 %, as shown
  QString who;                                       // the experts are
  QVector<MetricPoint> points;
};

/// Fits the curve of learning and says what it means.
void fit_series(MetricSeries& series);
/// The metrics that these attempts have (score and time first), and the series of one of them. An attempt that was not passed has
/// no score and is no point of the score's series; of any other metric it counts with what was measured.
QStringList metric_ids(const QVector<record::AttemptRow>& attempts);
MetricSeries metric_series(const QVector<record::AttemptRow>& attempts, const QString& id);

}  // namespace swage::console
