// SPDX-License-Identifier: Apache-2.0
//
// A knot is pulled once its attempt has been passed, where the lesson asks for it ("pull"): metrics and points of that. Nothing in the state of an
// attempt tells whether a knot holds, so that no lesson can judge it. [main]
#pragma once

#include <cstdint>
#include <string>

#include "judge/verdict.hpp"

namespace swage::judge {

struct PullRule {
  double load = 0;    // N, up to which the knot is pulled; 0: it is not. Normal: 0.1
  double points = 0;  // of 100, that a knot costs which bears nothing; in proportion, none at `load`. Normal: 0 to 40
};

/// Least score of an attempt that was passed, here as in the lessons of the series.
inline constexpr double kLeastOfPassed = 40;

/// A metric of the pull, as metrics of lessons are declared (abi/lesson_card.h).
struct PullMetric {
  const char *id, *unit, *doc, *title, *formula;
  int32_t better, show, rank;
};

/// In the order in which declare_pull_metrics() adds them.
enum PullMeasure : uint32_t { kPullBears, kPullSlip, kPullPoints, kPullMeasureCount };
extern const PullMetric kPullMetrics[kPullMeasureCount];

/// Adds them to a script. Returns the index of the first.
uint32_t declare_pull_metrics(Script&);

/// Points lost by a knot that has borne so much [N].
double points_lost(const PullRule& rule, double bears);

/// Score of a passed attempt after the pull of its knot.
double score_after_pull(const PullRule& rule, double score, double bears);

}  // namespace swage::judge
