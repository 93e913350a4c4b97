// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A person's latest values beside the experts' band.
#pragma once

#include <QString>
#include <QVector>
#include <functional>

#include "console/models/attempts_model.hpp"
#include "judge/learning.hpp"

namespace swage::console {

/// Values of a metric in its own unit, one list per expert, and a description: "4 experts", "recorded expert hands".
struct Experts {
  std::vector<std::vector<double>> values;
  QString who;
};
/// Finds experts of a lesson. The metric id is that in the attempts, or "score" or "time".
using ExpertFinder = std::function<Experts(const std::string& lesson_id, const QString& metric)>;

/// Whether a group of that name is the group of experts.
bool is_expert_group(const QString& name);
/// Judged and sound attempts at a lesson by the people in `expert_ids`; without any, those of the recorded expert hand.
std::vector<const record::AttemptRow*> expert_attempts(const std::vector<record::AttemptRow>& all,
                                                       const std::vector<std::string>& expert_ids, const std::string& lesson_id);
/// The same attempts read from a store, which reads the metrics of these people only.
std::vector<record::AttemptRow> read_expert_attempts(record::Store& store, const std::vector<std::string>& expert_ids,
                                                     const std::string& lesson_id);
/// The values of a metric of these experts.
Experts experts_of(const std::vector<record::AttemptRow>& all, const std::vector<std::string>& expert_ids,
                   const std::string& lesson_id, const QString& metric);

/// The value of an attempt's metric, or of "score" or "time"; NaN where it has none: an attempt that was not passed has no score.
double metric_value(const record::AttemptRow& attempt, const QString& metric);

struct MetricBar {
  QString id, name, value, band;   // as text
  double latest = 0;               // position: 0 is the better end of the bar, 1 the worse
  double low = 0, high = 0;        // positions of the band's ends
  bool inside = false;             // inside the band, or better
};
/// One bar for each directed metric that both the newest judged attempt and experts have. `attempts`: of one lesson, newest first.
QVector<MetricBar> metric_bars(const QVector<record::AttemptRow>& attempts, const ExpertFinder& experts,
                               const std::function<int32_t(const QString& metric)>& better);

}  // namespace swage::console
