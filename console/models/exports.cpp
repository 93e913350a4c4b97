// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/exports.hpp"

#include <QString>

namespace swage::console {
namespace {

std::string cell(const std::string& text) {
  QString out = QString::fromStdString(text);
  if (out.contains(QLatin1Char(',')) || out.contains(QLatin1Char('"')) || out.contains(QLatin1Char('\n')))
    out = QLatin1Char('"') + out.replace(QLatin1Char('"'), QStringLiteral("\"\"")) + QLatin1Char('"');
  return out.toStdString();
}

std::string number(double value) { return QString::number(value, 'g', 9).toStdString(); }

}  // namespace

std::string attempts_csv(const std::vector<record::AttemptRow>& attempts) {
  std::string out =
      "code,attempt,started_utc,lesson,lesson_digest,mode,device,scripted,synthetic,outcome,reason,void,void_reason,remark,score,"
      "time_s,metric,value,unit\n";
  for (const record::AttemptRow& a : attempts) {
    std::string head;
    for (const std::string& text : {a.person_code, a.id, a.started_utc, a.lesson_id, a.lesson_digest, a.mode, a.device,
                                    std::string(a.is_scripted ? "1" : "0"), std::string(a.is_synthetic ? "1" : "0"), a.outcome,
                                    a.reason, std::string(a.is_void ? "1" : "0"), a.void_reason, a.remark, number(a.score),
                                    number(a.simulated_s)})
      head += cell(text) + ',';
    if (a.metrics.empty()) out += head + ",,\n";
    for (const record::MetricValue& m : a.metrics) out += head + cell(m.id) + ',' + number(m.value) + ',' + cell(m.unit) + '\n';
  }
  return out;
}

}  // namespace swage::console
