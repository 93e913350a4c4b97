// SPDX-License-Identifier: Apache-2.0
//
// Metrics of an attempt, in the form for limits and scales. [any]
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace swage::judge {

/// From a list of any type with an id and a value.
template <class List>
std::vector<std::pair<std::string, double>> metrics_of(const List& list) {
  std::vector<std::pair<std::string, double>> out;
  for (const auto& metric : list) out.emplace_back(metric.id, metric.value);
  return out;
}

}  // namespace swage::judge
