// SPDX-License-Identifier: Apache-2.0
#include "judge/rating.hpp"

#include <algorithm>
#include <cmath>

namespace swage::judge {
namespace {

std::optional<double> told(Metrics metrics, const std::string& id) {
  for (const auto& [metric, value] : metrics)
    if (metric == id && std::isfinite(value)) return value;
  return std::nullopt;
}

// mean position between `worst` (0) and `best` (1)
std::optional<double> share(const RatingItem& item, Metrics metrics) {
  double sum = 0;
  std::size_t count = 0;
  for (const RatedBy& by : item.by) {
    const std::optional<double> value = told(metrics, by.metric);
    if (!value) continue;
    sum += std::clamp((*value - by.worst) / (by.best - by.worst), 0.0, 1.0);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

}  // namespace

const std::string& said_in(const Words& words, const std::string& language) {
  static const std::string nothing;
  for (const auto& [code, text] : words)
    if (code == language) return text;
  return words.empty() ? nothing : words.front().second;
}

Rating rate(const RatingScale& scale, Metrics metrics, bool passed) {
  Rating out;
  double sum = 0;
  const bool applies = std::all_of(scale.needs.begin(), scale.needs.end(), [&](const std::string& id) { return told(metrics, id); });
  for (const RatingItem& item : scale.items) {
    std::optional<double> part = applies ? share(item, metrics) : std::nullopt;
    if (part && item.is_product && !passed) part = 0;
    if (!part) {
      out.item.push_back(std::nullopt);
      continue;
    }
    out.item.push_back(scale.lowest + *part * (scale.highest - scale.lowest));
    sum += *out.item.back();
    ++out.decided;
  }
  if (out.decided > 0) out.mean = sum / static_cast<double>(out.decided);
  return out;
}

}  // namespace swage::judge
