// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The worst moments of an attempt: the event that ended it, mishaps, and the peaks of the signals behind its metrics.
#pragma once

#include <functional>

#include "console/models/review.hpp"

namespace swage::console {

struct WorstMoment {
  double time_s = 0;
  QString what;  // "Grip force, peak 1.70 N, at most 0.90 N"
  QString tip;
  double weight = 0;  // greater is worse; from kOverLimit on a limit was exceeded
};
inline constexpr double kOverLimit = 10, kEndedIt = 100;
inline constexpr int kMostWorst = 8;

/// A lesson's target for a metric, SI.
using TargetFinder = std::function<MetricTarget(const std::string& metric)>;

/// Sorted by weight, worst first, at most kMostWorst. `target` may be empty.
QVector<WorstMoment> worst_moments(const Review& review, const record::Recording& recording, const TargetFinder& target = {});

}  // namespace swage::console
