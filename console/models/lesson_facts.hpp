// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QStringList>
#include <map>
#include <optional>
#include <string>

#include "console/models/metric_facts.hpp"
#include "host/catalogue.hpp"

namespace swage::console {

/// The grip force required by a lesson, N.
struct ForceBand {
  double low = 0, high = 0;
};

/// The criteria of a lesson, in sentences with its own values.
struct Criteria {
  QStringList pass, limits, ends, points;  // `limits` end a test, `ends` end practice as well
  bool show = false;      // a demonstration, which is neither judged nor stored
  double max_time_s = 0;     // time limit; 0: none
  double max_tension_N = 0;  // limit of the thread tension; 0: none
};

/// The criteria from the card of the lesson's plugin; empty where it has none.
Criteria read_criteria(const std::string& lesson_path, const host::Catalogue& catalogue);

/// Reads the lesson's interval "force", or its limit "max_force" with no minimum, checked against its plugin's table,
/// defaults included. No value when the file, the plugin or the parameter is missing.
std::optional<ForceBand> force_band(const std::string& lesson_path, const host::Catalogue& catalogue);

/// The metrics of a lesson from its plugin's card; empty where it cannot be read.
std::vector<host::MetricInfo> lesson_metrics(const std::string& lesson_path, const host::Catalogue& catalogue);

/// The lesson's target for a metric, SI: an upper limit for peak force, time, drops; an interval for the mean force.
MetricTarget metric_target(const std::string& lesson_path, const std::string& metric_id,
                           const host::Catalogue& catalogue);

/// The same of all its metrics, by their ids; those without a target are left out.
std::map<std::string, MetricTarget> metric_targets(const std::string& lesson_path, const host::Catalogue& catalogue);

}  // namespace swage::console
