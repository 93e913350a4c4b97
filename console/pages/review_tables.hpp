// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The tables beside the picture of an attempt: metrics, what happened, worst moments, and the choice of traces.
#pragma once

#include <QListWidget>
#include <QTableWidget>

#include "console/cues/ui_theme.hpp"
#include "console/models/review.hpp"
#include "console/models/worst_moments.hpp"

namespace swage::console {

/// Measurements first, then deductions under a heading of their own, as both may have the same name.
class MetricsTable : public QTableWidget {
  Q_OBJECT
 public:
  explicit MetricsTable(QWidget* parent);
  /// `other`: an attempt that is compared, or nullptr.
  void fill(const Review& review, const Review* other);
  /// The colour of values outside what the lesson asks; a sign stands before them.
  void set_theme(const UiTheme& ui);

 Q_SIGNALS:
  /// What the lesson asks of the metric in the current row, "" where it asks nothing.
  void asked(const QString& words);

 private:
  void add(const MetricLine& metric, const Review* other);
  QTableWidgetItem* value_cell(const MetricLine& line, const MetricLine& metric) const;
  void add_heading();
  void tell(int row);

  QColor beyond_;
};

class MomentsTable : public QTableWidget {
  Q_OBJECT
 public:
  explicit MomentsTable(QWidget* parent);
  void fill(const QVector<Moment>& moments);

 Q_SIGNALS:
  void chosen(double time_s);
};

class WorstTable : public QTableWidget {
  Q_OBJECT
 public:
  explicit WorstTable(QWidget* parent);
  void fill(const QVector<WorstMoment>& worst);
  /// The next call of next() begins with the worst moment.
  void start_again() { visited_ = false; }
  /// Goes to the worst moment, then to the next.
  void next();

 Q_SIGNALS:
  void chosen(double time_s);
  /// A moment is to be played again and again, for a debriefing.
  void loop();

 private:
  void go_to(int row);

  QVector<double> times_s_;
  bool visited_ = false;
};

class TracesList : public QListWidget {
  Q_OBJECT
 public:
  explicit TracesList(QWidget* parent);
  void fill(const QVector<Trace>& traces);

 Q_SIGNALS:
  /// Indices of the traces to show.
  void shown(const QVector<int>& traces);

 private:
  void tell();
};

}  // namespace swage::console
