// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Printed report of a person: standing, one metric over the attempts, the latest values beside the experts'.
#pragma once

#include <QString>
#include <QVector>

#include "console/models/attempts_model.hpp"
#include "console/models/metric_bars.hpp"
#include "console/models/standing.hpp"
#include "record/export.hpp"

namespace swage::console {

struct PersonReport {
  QString name, code, lesson;  // name: "" for a page that leaves the school
  Standing standing;                     // over all lessons
  MetricSeries series;
  QVector<MetricBar> bars;
  QVector<record::AttemptRow> attempts;  // of the lesson, newest first
  std::vector<record::Exported> about;   // the same attempts as in exports
};

/// Writes A4 pages for printing in grey, as many as the attempts need. Returns "" or the error.
QString write_report(const PersonReport& report, const QString& file);

}  // namespace swage::console
