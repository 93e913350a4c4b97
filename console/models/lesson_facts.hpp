// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QStringList>
#include <optional>
#include <string>

#include "console/models/metric_facts.hpp"
#include "host/catalogue.hpp"

namespace swage::console {

/// The grip force that a lesson asks for, N.
struct ForceBand {
  double low = 0, high = 0;
};

/// What a lesson asks, in sentences with its own values.
struct Criteria {
  QStringList pass, limits, points;
  bool show = false;      // a demonstration: nothing is judged or kept
  double max_time_s = 0;     // its time limit; 0: none
  double max_tension_N = 0;  // how hard a thread may be drawn; 0: nothing is said
};

/// As the card of the lesson's plugin says; empty where it says nothing.
Criteria read_criteria(const std::string& lesson_path, const host::Catalogue& catalogue);

/// Reads the lesson's interval "force", or its limit "max_force" without a least force, checked against its plugin's table,
/// defaults included. Nothing when the file, the plugin or the parameter is not there.
std::optional<ForceBand> force_band(const std::string& lesson_path, const host::Catalogue& catalogue);

/// The metrics of a lesson as its plugin's card says; none where it cannot be read.
std::vector<host::MetricInfo> lesson_metrics(const std::string& lesson_path, const host::Catalogue& catalogue);

/// What the lesson asks of a metric, SI: at most so much peak force, time, drops; a mean force inside its interval.
MetricTarget metric_target(const std::string& lesson_path, const std::string& metric_id,
                           const host::Catalogue& catalogue);

}  // namespace swage::console
