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

// position between `worst` (0) and `best` (1)
double position(const RatedBy& by, double value) { return std::clamp((value - by.worst) / (by.best - by.worst), 0.0, 1.0); }

bool of_lost_points(const RatingItem& item) {
  return std::any_of(item.by.begin(), item.by.end(), [](const RatedBy& by) { return by.metric.starts_with("points."); });
}

// mean position
std::optional<double> share(const RatingItem& item, Metrics metrics) {
  double sum = 0;
  std::size_t count = 0;
  for (const RatedBy& by : item.by) {
    const std::optional<double> value = by.of_failed ? std::nullopt : told(metrics, by.metric);
    if (!value) continue;
    sum += position(by, *value);
    ++count;
  }
  if (count == 0) return std::nullopt;
  return sum / static_cast<double>(count);
}

// lowest position
std::optional<double> share_of_failed(const RatingItem& item, Metrics metrics) {
  std::optional<double> lowest;
  for (const RatedBy& by : item.by)
    if (const std::optional<double> value = by.of_failed ? told(metrics, by.metric) : std::nullopt)
      lowest = std::min(lowest.value_or(1), position(by, *value));
  return lowest;
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
    const bool without_points = !passed && !item.is_product && of_lost_points(item);
    std::optional<double> part;
    if (applies) part = without_points ? share_of_failed(item, metrics) : share(item, metrics);
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
