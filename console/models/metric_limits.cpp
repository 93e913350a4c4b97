// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/metric_limits.hpp"

#include <QObject>

#include "console/models/metric_titles.hpp"
#include "console/models/qt_text.hpp"
#include "console/models/words.hpp"

namespace swage::console {

Beyond beyond(double value, const MetricTarget& target) {
  if (target.high && value > *target.high) return Beyond::kAbove;
  if (target.low && value < *target.low) return Beyond::kBelow;
  return Beyond::kNo;
}

QString beyond_sign(Beyond where) {
  if (where == Beyond::kAbove) return QStringLiteral("▲");
  return where == Beyond::kBelow ? QStringLiteral("▼") : QString();
}

QString marked_value(const MetricLine& line, const MetricTarget& target) {
  const QString sign = beyond_sign(beyond(line.number, target));
  return sign.isEmpty() ? line.value : sign + QLatin1Char(' ') + line.value;
}

QVector<const MetricLine*> by_limit(const Review& review) {
  QVector<const MetricLine*> out;
  for (const bool marked : {true, false})
    for (const MetricLine& m : review.metrics)
      if (!m.points && (beyond(m.number, m.target) != Beyond::kNo) == marked) out += &m;
  return out;
}

QString limit_words(const MetricTarget& target, const QString& unit) {
  const auto text = [&](double value) { return quantity_text(value, unit); };
  if (target.low && target.high) return QObject::tr("From %1 to %2 is asked").arg(text(*target.low), text(*target.high));
  if (target.high) return QObject::tr("At most %1 is asked").arg(text(*target.high));
  return target.low ? QObject::tr("At least %1 is asked").arg(text(*target.low)) : QString();
}

void set_limits(Review& review, const TargetFinder& target) {
  if (!target) return;
  for (MetricLine& line : review.metrics) {
    if (line.points) continue;
    line.target = target(line.id);
    line.asked = limit_words(line.target, line.unit);
  }
}

}  // namespace swage::console
