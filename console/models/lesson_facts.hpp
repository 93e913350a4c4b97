// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <optional>
#include <string>

#include "console/models/metric_facts.hpp"
#include "host/catalogue.hpp"

namespace swage::console {

/// The grip force that a lesson asks for, N.
struct ForceBand {
  double low = 0, high = 0;
};

/// Reads the lesson's interval "force", or its limit "max_force" without a least force, checked against its plugin's table,
/// defaults included. Nothing when the file, the plugin or the parameter is not there.
std::optional<ForceBand> force_band(const std::string& lesson_path, const host::Catalogue& catalogue);

/// What the lesson asks of a metric, SI: at most so much peak force, time, drops; a mean force inside its interval.
MetricTarget metric_target(const std::string& lesson_path, const std::string& metric_id,
                           const host::Catalogue& catalogue);

}  // namespace swage::console
