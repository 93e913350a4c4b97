// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The right side of the Review page: metrics, worst moments, events, traces, entry, scales as tabs, and the legend of cues.
#pragma once

#include <QTabWidget>
#include <QWidget>
#include <optional>

#include "console/models/reading.hpp"
#include "console/models/review.hpp"
#include "console/models/worst_moments.hpp"
#include "console/widgets/cue_legend.hpp"
#include "console/widgets/track_plot.hpp"

namespace swage::console {

class ElidedLabel;
class MetricsTable;
class MomentsTable;
class RatingPanel;
class TracesList;
class WorstTable;

class ReviewSide : public QWidget {
  Q_OBJECT
 public:
  explicit ReviewSide(QWidget* parent);
  void set_themes(const UiTheme& ui, const CueTheme& cues);
  /// `can_rate`: whether an instructor's points can be kept.
  void fill(const Review& review, const record::Recording& recording, const QVector<WorstMoment>& worst, bool can_rate);
  /// The metrics beside those of another attempt, or nullptr.
  void fill_metrics(const Review& review, const Review* other);
  /// Shows the ratings as they were, after one could not be kept.
  void show_scales(const Review& review, bool can_rate);
  void set_cursor(double time_s) { track_->set_cursor(time_s); }
  CueLegend* legend() { return legend_; }
  WorstTable* worst() { return worst_; }
  /// Goes to the worst moment, then to the next.
  void next_worst();
  /// The tables in which the page's single-letter keys act.
  QList<QWidget*> tables() const;

 Q_SIGNALS:
  void chosen(double time_s);
  /// The chosen moment is to be played again and again.
  void loop();
  void traces_shown(const QVector<int>& traces);
  void rated(const QString& item_id, std::optional<double> points);

 private:
  bool event(QEvent* event) override;
  QWidget* make_metrics();

  MetricsTable* metrics_;
  ElidedLabel* asked_;
  WorstTable* worst_;
  MomentsTable* moments_;
  TracesList* traces_;
  TrackPlot* track_;
  RatingPanel* ratings_;
  QTabWidget* tabs_;
  CueLegend* legend_;
};

}  // namespace swage::console
