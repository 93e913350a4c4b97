// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A person's latest value of each metric of a lesson against the band of experts, for bars.
#pragma once

#include <functional>

#include <QString>
#include <QVector>
#include <optional>

#include "console/models/attempts_model.hpp"

namespace swage::console {

struct MetricBar {
  QString id, name, value, band;     // value and band in words
  double latest = 0, low = 0, high = 0;  // places from 0, the better end, to 1; the band's ends
  bool inside = false;               // within the band or better
};

/// Experts' values of a metric in its own unit, a list per expert. Empty: there are none.
using ExpertValues = std::function<std::vector<std::vector<double>>(const QString& metric)>;

/// A bar for each metric that has a direction, a value in the newest judged attempt, and a band. `attempts`: of one lesson.
QVector<MetricBar> metric_bars(const QVector<record::AttemptRow>& attempts, const ExpertValues& experts);

}  // namespace swage::console
