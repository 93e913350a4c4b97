// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Which way a metric is better, and how it is computed: as the lesson's card says, else the first card that knows it; else nothing is claimed.
#pragma once

#include <swage/abi/lesson_card.h>

#include <QString>
#include <optional>
#include <string>

#include "snapshot/scene_card.hpp"

namespace swage::console {

struct MetricFacts {
  int32_t better = SWAGE_BETTER_NONE;
  QString formula;  // "" where no card says it
};

/// What a lesson asks of a metric: at most, at least, or between. Neither where it does not say.
struct MetricTarget {
  std::optional<double> low, high;
  bool operator==(const MetricTarget&) const = default;
};

struct MetricSaid {
  MetricFacts facts;
  MetricTarget target;  // SI
};

/// `card`: of a scene of the metric's lesson; nullptr where there is none.
MetricFacts metric_facts(const snapshot::SceneCard* card, const std::string& id);

/// "lower is better", "" for SWAGE_BETTER_NONE; with an arrow where there is no other sign for it.
QString better_words(int32_t better, bool arrow = true);

}  // namespace swage::console
