// SPDX-License-Identifier: Apache-2.0
//
// The metrics of the pull of a knot (judge/pull_rule.hpp) in the form of a lesson's card. [main]
#pragma once

#include <vector>

#include "host/plugin_info.hpp"

namespace swage::host {

/// In the order of judge::PullMeasure.
const std::vector<MetricInfo>& pull_metrics();

}  // namespace swage::host
