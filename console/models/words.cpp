// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/words.hpp"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QRegularExpression>
#include <QTimeZone>
#include <cmath>

#include "base/quantity.hpp"
#include "record/store.hpp"

namespace swage::console {
namespace {

class ValueWords {
  Q_DECLARE_TR_FUNCTIONS(words)
};

// Counts have no decimals, all other numbers three significant digits. `small`: the unit is smaller than the usual one.
int decimals_of(double shown, const QString& unit, bool small) {
  const double size = std::abs(shown);
  if (small && unit.startsWith(QChar(0xb5))) return size < 10 ? 1 : 0;
  if (small) return size < 10 ? 2 : 1;
  const bool whole = unit.isEmpty() && std::abs(shown - std::round(shown)) < 1e-9;
  if (whole) return 0;
  // a pure number below 0.1 has two significant digits
  if (unit.isEmpty() && size < 0.1) return std::min(6, 1 - static_cast<int>(std::floor(std::log10(size))));
  return size >= 100 ? 0 : size >= 10 ? 1 : 2;
}

}  // namespace

QString human_id(const QString& id) {
  QString words = id;
  words.replace(QLatin1Char('.'), QLatin1Char(' ')).replace(QLatin1Char('_'), QLatin1Char(' '));
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  return words;
}

QString unit_text(std::string_view unit) {
  if (unit == "1" || unit == "yes/no") return {};
  if (unit == "deg") return QStringLiteral("°");
  QString text = QString::fromUtf8(unit.data(), static_cast<qsizetype>(unit.size()));
  if (text.size() > 1 && text[0] == QLatin1Char('u')) text[0] = QChar(0xb5);
  return text.replace(QLatin1String("m2"), QStringLiteral("m²"))
      .replace(QLatin1String("m3"), QStringLiteral("m³"))
      .replace(QLatin1Char('*'), QChar(0xb7));
}

double display_factor(const QString& unit) { return base::usual_unit(unit.toStdString()).factor; }

QString display_unit(const QString& unit) { return unit_text(base::usual_unit(unit.toStdString()).unit); }

QString quantity_text(double value, const QString& unit) {
  if (!std::isfinite(value)) return QStringLiteral("–");
  const std::string si = unit.toStdString();
  value = base::meaningful(value, si);
  if (unit == QLatin1String("yes/no")) return value > 0.5 ? ValueWords::tr("yes") : ValueWords::tr("no");
  const base::Shown as = base::shown_unit(value, si);
  const double shown = value * as.factor;
  const QString suffix = unit_text(as.unit);
  return with_unit(QLocale().toString(shown, 'f', decimals_of(shown, suffix, as.factor > base::usual_unit(si).factor)), as.unit);
}

QString with_unit(const QString& number, std::string_view unit) {
  const QString suffix = unit_text(unit);
  if (suffix.isEmpty()) return number;
  return unit == "deg" ? number + suffix : number + QChar(0x202f) + suffix;
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

QString replay_clock(double shown_s, double wanted_s) {
  constexpr double kBehind_s = 1;
  const QString clock = clock_text(shown_s);
  return std::abs(wanted_s - shown_s) > kBehind_s ? ValueWords::tr("%1, on the way to %2").arg(clock, clock_text(wanted_s)) : clock;
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

QString date_text(const QDate& date) { return QLocale().toString(date, ValueWords::tr("d MMM yyyy")); }

QString when_text(const QString& utc) {
  const QDateTime time = QDateTime::fromString(utc, Qt::ISODate);
  if (!time.isValid()) return utc;
  return QLocale().toString(time.toLocalTime(), ValueWords::tr("d MMM yyyy HH:mm"));
}

}  // namespace swage::console
