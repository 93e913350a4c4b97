// SPDX-License-Identifier: LGPL-3.0-or-later
//
// An attempt on the rating scales of surgeons (resources/scales), in words. GUI thread.
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
  QString name, value, doc;  // "SMaRT: Efficiency", "4.2 of 5"; doc: what decides it, and whose scale it is
  std::string id;            // "smart.efficiency"; "smart" of the mean, "SMaRT, computed (6 of 9 items)"
  double points = 0, lowest = 0, highest = 0;
  bool mean = false;  // of the scale's decided items
};

/// Of each scale of which the attempt decides an item: the mean first, then those items. None of an attempt that did not end by
/// itself.
QVector<RatingLine> rating_lines(const std::string& outcome, judge::Metrics metrics);

/// An item as the metrics decide it, and as an instructor rates it; neither where nobody has.
struct RatedItem {
  std::string id;      // "smart.efficiency", as ratings are kept
  QString title, doc;  // doc: which metrics decide it
  std::optional<double> computed, given;
};

/// A scale with all its items. What is computed and what is given stand beside each other; neither enters the other's mean.
struct RatedScale {
  std::string id;
  QString title, source;  // source: whose scale it is, and what of it is assumed, as its file tells
  double lowest = 1, highest = 5;
  int decided = 0, given = 0;  // items
  double computed_mean = 0, given_mean = 0;
  QVector<RatedItem> items;

  QString points_words(double points) const;  // "4.2 of 5"
  QString computed_words() const;             // a sentence: that it is computed, the mean, and of how many items
  QString given_words() const;                // the same of the instructor's; "" where there is none
};

/// Every scale there is. `given`: an instructor's points by item.
QVector<RatedScale> rated_scales(const std::string& outcome, judge::Metrics metrics, const std::vector<std::pair<std::string, double>>& given);

}  // namespace swage::console
