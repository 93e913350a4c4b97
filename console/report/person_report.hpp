// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Pages about a person, to be printed: where they stand, one metric over the attempts, the latest values beside the experts'.
#pragma once

#include <QString>
#include <QVector>

#include "console/models/attempts_model.hpp"
#include "console/models/metric_bars.hpp"
#include "console/models/standing.hpp"
#include "record/export.hpp"

namespace swage::console {

struct PersonReport {
  QString name, code, lesson;  // name: "" where the page leaves the school
  Standing standing;                     // over all lessons
  MetricSeries series;
  QVector<MetricBar> bars;
  QVector<record::AttemptRow> attempts;  // of the lesson, newest first
  std::vector<record::Exported> about;   // the same as exports say them
};

/// A4 pages that print in grey, as many as the attempts need. "" or what went wrong.
QString write_report(const PersonReport& report, const QString& file);

}  // namespace swage::console
