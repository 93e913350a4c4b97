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

/// Whether a scripted or recorded hand made the attempt: it is shown, but is no person's progress.
bool is_hand(const record::AttemptRow& attempt);
/// The name of that hand in its lesson, for people: "novice"; "" where it is not known.
QString hand_name(const record::AttemptRow& attempt);
/// Whether the attempt counts for its person: judged, not void, not by a recorded hand. All counts and curves use only such attempts.
bool counts(const record::AttemptRow& attempt);
/// Only an attempt that was passed has a score.
bool has_score(const record::AttemptRow& attempt);

/// One metric over the attempts, oldest first, as drawn in a chart.
struct MetricPoint {
  double value = 0;  // in the display unit of the series
  bool met = false, test = false;
  QString day, tip;
};
struct MetricSeries {
  QString id, name, unit;
  int32_t better = SWAGE_BETTER_NONE;
  QString formula;      // how the metric is computed, if the lesson says so
  MetricTarget target;  // in the display unit
  double factor = 1;    // from SI to the display unit
  QVector<double> curve;  // fitted value at each point; empty without a fitted learning curve
  QString fit;            // result of the fit, or why there is none
  std::optional<double> least, most;  // limits of the metric's scale, in the display unit
  int failed = 0, without_score = 0;  // attempts not passed: among the points, and left out because they have no score
  std::optional<std::pair<double, double>> experts;  // the experts' band, 10 % to 90 %, in the display unit
  QString who;                                       // who the experts are
  QVector<MetricPoint> points;
};

/// Fits the learning curve and puts its meaning into words.
void fit_series(MetricSeries& series);
/// The metrics of these attempts (score and time first), and the series of one of them. An attempt that was not passed has
/// no score and is left out of the score's series; in all other series it counts with its measured value.
QStringList metric_ids(const QVector<record::AttemptRow>& attempts);
MetricSeries metric_series(const QVector<record::AttemptRow>& attempts, const QString& id);

}  // namespace swage::console
