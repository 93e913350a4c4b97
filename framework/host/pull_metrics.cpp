// SPDX-License-Identifier: Apache-2.0
#include "host/pull_metrics.hpp"

#include "judge/pull_rule.hpp"

namespace swage::host {

const std::vector<MetricInfo>& pull_metrics() {
  static const std::vector<MetricInfo> all = [] {
    std::vector<MetricInfo> out;
    for (const judge::PullMetric& m : judge::kPullMetrics)
      out.push_back({m.id, m.unit, m.doc, m.formula, "", m.better, SWAGE_EVIDENCE_D, m.title, m.show, m.rank, "", ""});
    return out;
  }();
  return all;
}

}  // namespace swage::host
