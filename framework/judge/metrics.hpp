// SPDX-License-Identifier: Apache-2.0
//
// Metrics of an attempt, as limits and scales take them. [any]
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace swage::judge {

/// Of a list of anything that has an id and a value.
template <class List>
std::vector<std::pair<std::string, double>> metrics_of(const List& list) {
  std::vector<std::pair<std::string, double>> out;
  for (const auto& metric : list) out.emplace_back(metric.id, metric.value);
  return out;
}

}  // namespace swage::judge
