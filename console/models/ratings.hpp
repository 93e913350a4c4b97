// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Scores of an attempt on the rating scales of surgeons (resources/scales), as text. GUI thread.
#pragma once

#include <QString>
#include <QVector>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "judge/rating.hpp"

namespace swage::console {

struct RatingLine {
  QString name, value, doc;  // "SMaRT: Efficiency", "4.2 of 5"; doc: the metrics that decide it, and the scale's source
  std::string id;            // "smart.efficiency"; "smart" for the mean, "SMaRT, computed (6 of 9 items)"
  double points = 0, lowest = 0, highest = 0;
  bool mean = false;  // mean of the scale's decided items
};

/// For each scale with an item decided by the attempt: the mean first, then those items. Empty for an attempt that did not end by
/// itself.
QVector<RatingLine> rating_lines(const std::string& outcome, judge::Metrics metrics);

/// An item with the points computed from the metrics and those of an instructor; either may be missing.
struct RatedItem {
  std::string id;      // "smart.efficiency", key of the stored ratings
  QString title, doc;  // doc: the metrics that decide it
  std::optional<double> computed, given;
};

/// A scale with all its items. Computed and given points are separate; neither enters the other's mean.
struct RatedScale {
  std::string id;
  QString title, source;  // source: origin of the scale and the assumptions made, from its file
  double lowest = 1, highest = 5;
  bool failed = false;         // the attempt
  int decided = 0, given = 0;  // number of items
  double computed_mean = 0, given_mean = 0;
  QVector<RatedItem> items;

  QString points_words(double points) const;  // "4.2 of 5"
  QString computed_words() const;             // a sentence with the computed mean and the number of items
  QString given_words() const;                // the same for the instructor's points; "" without any
};

/// All scales. `given`: an instructor's points by item.
QVector<RatedScale> rated_scales(const std::string& outcome, judge::Metrics metrics, const std::vector<std::pair<std::string, double>>& given);

}  // namespace swage::console
