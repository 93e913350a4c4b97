// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A person's latest values against the band of experts.
#pragma once

#include <QString>
#include <QVector>
#include <functional>

#include "console/models/attempts_model.hpp"
#include "judge/learning.hpp"

namespace swage::console {

/// Values of a metric in its own unit, one list per expert, and who they are: "4 experts", "recorded expert hands".
struct Experts {
  std::vector<std::vector<double>> values;
  QString who;
};
/// Of a lesson. The id of the metric is as in the attempts; "score" and "time", too.
using ExpertFinder = std::function<Experts(const std::string& lesson_id, const QString& metric)>;

/// A school calls the group of those whose values are the measure so.
bool is_expert_group(const QString& name);
/// Judged and sound attempts at a lesson by the people in `expert_ids`; where none of them did it, by the recorded expert hand.
std::vector<const record::AttemptRow*> expert_attempts(const std::vector<record::AttemptRow>& all,
                                                       const std::vector<std::string>& expert_ids, const std::string& lesson_id);
/// The same out of a store; nothing of anybody else is read with its metrics.
std::vector<record::AttemptRow> read_expert_attempts(record::Store& store, const std::vector<std::string>& expert_ids,
                                                     const std::string& lesson_id);
/// Their values of a metric.
Experts experts_of(const std::vector<record::AttemptRow>& all, const std::vector<std::string>& expert_ids,
                   const std::string& lesson_id, const QString& metric);

/// The value of a metric of an attempt, "score" and "time", too; NaN where it has none, as an attempt that was not passed has no score.
double metric_value(const record::AttemptRow& attempt, const QString& metric);

struct MetricBar {
  QString id, name, value, band;   // in words
  double latest = 0;               // places: 0 is the better end of the bar, 1 the worse
  double low = 0, high = 0;        // of the band
  bool inside = false;             // within the band, or better
};
/// For each metric with a direction that the newest judged attempt has and experts have. `attempts`: of one lesson, newest first.
QVector<MetricBar> metric_bars(const QVector<record::AttemptRow>& attempts, const ExpertFinder& experts,
                               const std::function<int32_t(const QString& metric)>& better);

}  // namespace swage::console
