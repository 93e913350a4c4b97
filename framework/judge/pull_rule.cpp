// SPDX-License-Identifier: Apache-2.0
#include "judge/pull_rule.hpp"

#include <swage/abi/lesson_card.h>

#include <algorithm>
#include <cmath>

#include "judge/host_events.hpp"

namespace swage::judge {

// clang-format off
const PullMetric kPullMetrics[kPullMeasureCount] = {
    {"knot.bears", "N", "What the knot bore when the program pulled a copy of it after the attempt.", "Knot bears", "greatest mean tension of both strands beside the pin, up to load", SWAGE_BETTER_HIGHER, SWAGE_SHOW_QUANTITY, 9},
    {"knot.pull_slip", "m", "Thread that went through the knot into its loop when the program pulled a copy of it.", "Slip when pulled", "slip over both strands, up to load or to where the knot gives way", SWAGE_BETTER_LOWER, SWAGE_SHOW_QUANTITY, 0},
    {"points.pull", "1", "Points lost for a knot that gives way when it is pulled.", "Knot gives way", "points (1 - min(1, bears / load))", SWAGE_BETTER_LOWER, SWAGE_SHOW_POINTS, 0},
};
// clang-format on

uint32_t declare_pull_metrics(Script& script) {
  const auto first = static_cast<uint32_t>(script.metrics.size());
  for (const PullMetric& metric : kPullMetrics) script.metrics.push_back({kHostOwner, metric.id, metric.unit, metric.doc});
  return first;
}

double points_lost(const PullRule& rule, double bears) {
  if (!std::isfinite(bears)) bears = 0;  // it slipped before anything was measured
  return rule.points * (1 - std::clamp(bears / rule.load, 0.0, 1.0));
}

double score_after_pull(const PullRule& rule, double score, double bears) {
  return std::max(std::min(score, kLeastOfPassed), score - points_lost(rule, bears));
}

}  // namespace swage::judge
