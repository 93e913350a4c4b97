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
  double value = 0;  // in the display unit
  bool passed = false;
};
struct GroupCell {
  QVector<GroupDot> dots;  // oldest first
  double mean = 0;         // of all dots
};
struct GroupFigure {
  QString metric, unit;         // display unit
  QStringList lessons, people;  // by title and by name
  QVector<QVector<GroupCell>> cell;  // [lesson][person]
  double low = 0, high = 1;          // range of all dots and zero, in the display unit
  int attempts = 0;
};

/// `attempts`: newest first. Attempts neither passed nor failed, void ones and those without the metric are left out.
GroupFigure group_figure(const std::vector<record::AttemptRow>& attempts, const QString& metric);

}  // namespace swage::console
