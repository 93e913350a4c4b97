// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "console/models/metric_titles.hpp"

namespace swage::test {

/// Registers the labels of a lesson plugin's card with some metrics, as the catalogue gives them.
inline void learn_known_metrics() {
  host::PluginInfo plugin;
  for (const char* id : {"force.peak", "motion.path", "grasp.tries"}) {
    host::MetricInfo m;
    m.id = id;
    m.better = SWAGE_BETTER_LOWER;
    m.evidence = SWAGE_EVIDENCE_C;
    plugin.metrics.push_back(m);
  }
  console::learn_metric_labels({plugin});
}

}  // namespace swage::test
