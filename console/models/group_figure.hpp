// SPDX-License-Identifier: LGPL-3.0-or-later
//
// One metric over lessons and people, every attempt a dot: the thesis's figures D-1 (entry penetration) and D-2 (cosine of the
// penetration angle) for any metric and any selection of stored attempts.
#pragma once

#include <QString>
#include <QStringList>
#include <QVector>
#include <vector>

#include "record/store.hpp"

namespace swage::console {

struct GroupDot {
  double value = 0;  // as shown
  bool passed = false;
};
struct GroupCell {
  QVector<GroupDot> dots;  // oldest first
  double mean = 0;         // of all of them
};
struct GroupFigure {
  QString metric, unit;         // as shown
  QStringList lessons, people;  // by title and by name
  QVector<QVector<GroupCell>> cell;  // [lesson][person]
  double low = 0, high = 1;          // of all dots and zero, as shown
  int attempts = 0;
};

/// `attempts`: newest first. Those that were neither passed nor failed, are void, or lack the metric are left out.
GroupFigure group_figure(const std::vector<record::AttemptRow>& attempts, const QString& metric);

}  // namespace swage::console
