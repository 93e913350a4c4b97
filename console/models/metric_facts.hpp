// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Direction and formula of a metric: from the lesson's card, else from the first card with that metric; else none.
#pragma once

#include <swage/abi/lesson_card.h>

#include <QString>
#include <optional>
#include <string>

#include "snapshot/scene_card.hpp"

namespace swage::console {

struct MetricFacts {
  int32_t better = SWAGE_BETTER_NONE;
  QString formula;  // "" where no card has it
};

/// A lesson's target for a metric: an upper limit, a lower limit, or both. Neither where the lesson has none.
struct MetricTarget {
  std::optional<double> low, high;
  bool operator==(const MetricTarget&) const = default;
};

struct MetricSaid {
  MetricFacts facts;
  MetricTarget target;  // SI
};

/// `card`: scene card of the metric's lesson; nullptr without one.
MetricFacts metric_facts(const snapshot::SceneCard* card, const std::string& id);

/// "lower is better", "" for SWAGE_BETTER_NONE; `arrow`: with an arrow in front.
QString better_words(int32_t better, bool arrow = true);

}  // namespace swage::console
