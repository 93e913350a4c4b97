// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/made_with.hpp"

#include <QLocale>
#include <QObject>
#include <nlohmann/json.hpp>

#include "base/solver_health.hpp"
#include "console/models/qt_text.hpp"
#include "console/models/said.hpp"

namespace swage::console {
namespace {

using record::Exported;

double count(const Exported& e, const std::string& id) {
  for (const record::Health& h : e.health)
    if (h.id == id) return h.value;
  return 0;
}

template <class Text>
QString each_once(const std::vector<Exported>& attempts, Text text) {
  QStringList out;
  for (const Exported& e : attempts)
    if (const QString one = text(e); !out.contains(one)) out += one;
  return out.join(QStringLiteral(", "));
}

QString or_unknown(const std::string& text) { return text.empty() ? QObject::tr("unknown") : qt(text); }

QString input_words(const Exported& e) {
  return e.input == "scripted"   ? QObject::tr("recorded hand")
         : e.input == "force"    ? QObject::tr("device with forces")
         : e.input == "position" ? QObject::tr("device without forces")
                                 : QObject::tr("unknown");
}

QString timing_words(const std::vector<Exported>& attempts) {
  double steps = 0, late = 0, lost = 0, off_s = 0;
  for (const Exported& e : attempts) {
    steps += count(e, "steps.executed");
    late += count(e, "steps.late");
    lost += count(e, "steps.dropped") + count(e, "steps.not_recorded");
    off_s += count(e, "forces_off");
  }
  if (late + lost + off_s <= 0) return QObject::tr("timing: no fault");
  QString out = QObject::tr("timing: %L1 late and %L2 lost of %L3 steps").arg(late, 0, 'f', 0).arg(lost, 0, 'f', 0).arg(steps, 0, 'f', 0);
  if (off_s > 0) out += QObject::tr(", no forces for %L1 s").arg(off_s, 0, 'f', 1);
  return out;
}

QString solver_words(const std::vector<Exported>& attempts) {
  QStringList faults;
  bool known = false;
  for (const auto& field : base::kSolverHealthFields) {
    double n = 0;
    for (const Exported& e : attempts) {
      const std::string id = std::string("solver.") + field.id;
      n += count(e, id);
      for (const record::Health& h : e.health) known = known || h.id == id;
    }
    if (n > 0) faults += QStringLiteral("%1 %2").arg(QLocale().toString(n, 'f', 0), said(std::string(field.doc)));
  }
  if (!known) return QObject::tr("solver: not recorded");
  return faults.isEmpty() ? QObject::tr("solver: no fault") : QObject::tr("solver: %1").arg(faults.join(QStringLiteral(", ")));
}

QString calibration_words(const Exported& e) {
  const nlohmann::json list = nlohmann::json::parse(e.calibration, nullptr, false);
  QStringList sensors;
  if (list.is_array())
    for (const auto& one : list)
      if (one.is_object()) sensors += qt(one.value("sensor", std::string())) + QLatin1Char(' ') + qt(one.value("day", std::string())).left(10);
  return sensors.isEmpty() ? QObject::tr("no calibrated sensor") : sensors.join(QStringLiteral(", "));
}

}  // namespace

QStringList made_with(const std::vector<Exported>& attempts) {
  if (attempts.empty()) return {};
  const auto version = [](const Exported& e) {
    return e.attempt.lesson_digest.empty() ? QObject::tr("unknown") : qt(e.attempt.lesson_digest.substr(0, 12));
  };
  return {QObject::tr("lesson version %1").arg(each_once(attempts, version)),
          QObject::tr("metrics by %1").arg(each_once(attempts, [](const Exported& e) { return or_unknown(e.metric_version); })),
          QObject::tr("input: %1").arg(each_once(attempts, input_words)),
          timing_words(attempts),
          solver_words(attempts),
          QObject::tr("calibration: %1").arg(each_once(attempts, calibration_words))};
}

std::string made_with_csv(const Exported& attempt) {
  std::string out;
  const auto line = [&](const char* kind, const std::string& name, const std::string& value, const std::string& unit, const std::string& words) {
    out += std::string(kind) + "," + record::csv_field(name) + ",," + value + "," + record::csv_field(unit) + "," + record::csv_field(words) + "\n";
  };
  for (const auto& [key, text] : {std::pair{"lesson_version", attempt.attempt.lesson_digest}, {"metric_version", attempt.metric_version},
                                  {"plugins", attempt.plugins}, {"input", attempt.input}, {"calibration", attempt.calibration},
                                  {"display", attempt.display}, {"station", attempt.station}, {"app_version", attempt.app_version}})
    line("made_with", key, "", "", text);
  for (const record::Health& h : attempt.health) line("health", h.id, QString::number(h.value, 'g', 12).toStdString(), h.unit, "");
  return out;
}

}  // namespace swage::console
