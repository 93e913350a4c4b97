// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/words.hpp"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QRegularExpression>
#include <QTimeZone>
#include <cmath>
#include <numbers>

#include "base/quantity.hpp"
#include "record/store.hpp"

namespace swage::console {
namespace {

class ValueWords {
  Q_DECLARE_TR_FUNCTIONS(words)
};

}  // namespace

QString human_id(const QString& id) {
  QString words = id;
  words.replace(QLatin1Char('.'), QLatin1Char(' ')).replace(QLatin1Char('_'), QLatin1Char(' '));
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  return words;
}

double display_factor(const QString& unit) {
  if (unit == QLatin1String("m") || unit == QLatin1String("m/s") || unit == QLatin1String("kg")) return 1000;
  if (unit == QLatin1String("m2")) return 1e6;
  if (unit == QLatin1String("N*s")) return 1000;
  if (unit == QLatin1String("rad")) return 180 / std::numbers::pi;
  if (unit == QLatin1String("%")) return 100;
  return 1;
}

QString display_unit(const QString& unit) {
  if (unit == QLatin1String("m")) return QStringLiteral("mm");
  if (unit == QLatin1String("m/s")) return QStringLiteral("mm/s");
  if (unit == QLatin1String("kg")) return QStringLiteral("g");
  if (unit == QLatin1String("m2")) return QStringLiteral("mm²");
  if (unit == QLatin1String("N*s")) return QStringLiteral("mN·s");
  if (unit == QLatin1String("rad")) return QStringLiteral("°");
  return unit == QLatin1String("1") || unit == QLatin1String("yes/no") ? QString() : unit;
}

QString quantity_text(double value, const QString& unit) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  value = base::meaningful(value, unit.toStdString());
  if (unit == QLatin1String("yes/no")) return value > 0.5 ? ValueWords::tr("yes") : ValueWords::tr("no");
  // a tenth of a wire and less is told in micrometres
  if (unit == QLatin1String("m") && value != 0 && std::abs(value) < 1e-4)
    return QLocale().toString(1e6 * value, 'f', std::abs(value) < 1e-5 ? 1 : 0) + QChar(0x202f) +
           QStringLiteral("µm");
  // what a thread bears at rest is told in millinewtons
  if (unit == QLatin1String("N") && value != 0 && std::abs(value) < 0.01)
    return QLocale().toString(1e3 * value, 'f', 2) + QChar(0x202f) + QStringLiteral("mN");
  const double shown = value * display_factor(unit);
  const QString suffix = display_unit(unit);
  // counts without decimals, everything else with three digits that mean something
  const bool whole = suffix.isEmpty() && std::abs(shown - std::round(shown)) < 1e-9;
  const double size = std::abs(shown);
  int decimals = whole ? 0 : size >= 100 ? 0 : size >= 10 ? 1 : 2;
  // a small share of one has two digits that mean something, too
  if (suffix.isEmpty() && !whole && size < 0.1) decimals = std::min(6, 1 - static_cast<int>(std::floor(std::log10(size))));
  const QString number = QLocale().toString(shown, 'f', decimals);
  if (suffix.isEmpty()) return number;
  return suffix == QStringLiteral("°") ? number + suffix : number + QChar(0x202f) + suffix;
}

double nice_end(double value) {
  if (!(value > 0)) return 0;
  const double ten = std::pow(10, std::floor(std::log10(value)));
  for (const double m : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (value <= m * ten * (1 + 1e-9)) return m * ten;
  }
  return 10 * ten;
}

QString clock_text(double seconds) {
  const int s = static_cast<int>(std::max(0.0, std::floor(seconds)));
  return QStringLiteral("%1:%2").arg(s / 60, 2, 10, QLatin1Char('0')).arg(s % 60, 2, 10, QLatin1Char('0'));
}

QString person_text(const QString& name) { return name == QLatin1String(record::kGuest) ? QObject::tr("Guest") : name; }

QString verdict_text(const QString& outcome) {
  if (outcome == QLatin1String("passed")) return ValueWords::tr("Passed");
  if (outcome == QLatin1String("failed")) return ValueWords::tr("Not passed");
  if (outcome == QLatin1String("void")) return ValueWords::tr("Void");
  if (outcome == QLatin1String("aborted")) return ValueWords::tr("Stopped");
  if (outcome == QLatin1String("running")) return ValueWords::tr("Running");
  return human_id(outcome);
}

QString mode_text(const QString& mode) {
  if (mode == QLatin1String("practice")) return ValueWords::tr("Practice");
  if (mode == QLatin1String("test")) return ValueWords::tr("Test");
  if (mode == QLatin1String("demo")) return ValueWords::tr("Demo");
  return human_id(mode);
}

QString remark_text(const QString& remark) {
  static const QRegularExpression kSlow(QStringLiteral("^at (\\d+) % of real speed$")),
      kForces(QStringLiteral("^no forces for ([\\d.]+) s$")), kSteps(QStringLiteral("^(\\d+) steps not recorded$"));
  QStringList out;
  for (const QString& part : remark.split(QStringLiteral(", "), Qt::SkipEmptyParts)) {
    if (const auto m = kSlow.match(part); m.hasMatch())
      out += ValueWords::tr("at %1 % of real speed").arg(m.captured(1));
    else if (const auto f = kForces.match(part); f.hasMatch())
      out += ValueWords::tr("no forces for %1 s").arg(QLocale().toString(f.captured(1).toDouble(), 'f', 1));
    else if (const auto n = kSteps.match(part); n.hasMatch())
      out += ValueWords::tr("%1 steps not recorded").arg(n.captured(1));
    else
      out += part;
  }
  return out.join(QStringLiteral(", "));
}

QString when_text(const QString& utc) {
  const QDateTime time = QDateTime::fromString(utc, Qt::ISODate);
  if (!time.isValid()) return utc;
  return QLocale().toString(time.toLocalTime(), ValueWords::tr("d MMM yyyy HH:mm"));
}

}  // namespace swage::console
