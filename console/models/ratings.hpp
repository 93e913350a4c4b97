// SPDX-License-Identifier: LGPL-3.0-or-later
//
// An attempt on the rating scales of surgeons (resources/scales), in words. GUI thread.
#pragma once

#include <QString>
#include <QVector>
#include <string>

#include "judge/rating.hpp"

namespace swage::console {

struct RatingLine {
  QString name, value, doc;  // "SMaRT: Efficiency", "4.2 of 5"; doc: what decides it, and whose scale it is
  std::string id;            // "smart.efficiency"; "smart" of the mean, "SMaRT (6 of 9 items)"
  double points = 0, lowest = 0, highest = 0;
  bool mean = false;  // of the scale's decided items
};

/// Of each scale of which the attempt decides an item: the mean first, then those items. None of an attempt that did not end by
/// itself.
QVector<RatingLine> rating_lines(const std::string& outcome, judge::Metrics metrics);

}  // namespace swage::console
