// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Which values of a recorded attempt are outside what its lesson asks, and the words for it. No widgets.
#pragma once

#include "console/models/review.hpp"
#include "console/models/worst_moments.hpp"

namespace swage::console {

enum class Beyond { kNo, kAbove, kBelow };

/// Whether a value is outside its target. A value on the limit, one that is not finite, and one without a target are not. Both in SI.
Beyond beyond(double value, const MetricTarget& target);
/// The sign that stands before such a value, so that it is not told by colour alone; "" for Beyond::kNo.
QString beyond_sign(Beyond where);
/// The value as text, behind its sign where it is outside the target: "▲ 1.60 N".
QString marked_value(const MetricLine& line, const MetricTarget& target);
/// The measurements, without deductions: those outside their targets first, each part in the order of the review. Pointers into it.
QVector<const MetricLine*> by_limit(const Review& review);
/// "At most 0.90 N is asked"; "" where the lesson asks nothing. `unit` is that of quantity_text().
QString limit_words(const MetricTarget& target, const QString& unit);
/// Gives each measurement of the attempt its target and the words for it; deductions have none.
void set_limits(Review& review, const TargetFinder& target);

}  // namespace swage::console
