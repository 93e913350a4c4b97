// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Printed report of an attempt: result, metrics, ratings, worst moments, traces, the thesis's two plots, notes.
#pragma once

#include <QString>
#include <QStringList>
#include <QVector>
#include <optional>
#include <vector>

#include "console/models/insertion.hpp"
#include "console/models/review.hpp"
#include "console/models/worst_moments.hpp"
#include "record/export.hpp"
#include "record/school.hpp"

namespace swage::console {

class Sheet;

struct AttemptReport {
  const Review& review;
  const record::Recording& recording;
  QVector<WorstMoment> worst;
  std::optional<EntryTrack> track;
  std::vector<record::Note> notes;
  std::vector<record::Exported> about;  // the attempt as in exports; empty if it could not be read
};

/// A metric on paper: name, value behind the review's sign where it is beyond its limit, and direction; below them what the lesson asks of
/// such a metric, "" for the others.
struct PrintedMetric {
  QStringList cells;
  QString below;
};

/// As in the review those beyond their limits come first.
QVector<PrintedMetric> metric_rows(const Review& review);
void draw_attempt(Sheet& sheet, const AttemptReport& report);
/// Returns "" or the error. The pages show the person's code and name as the store gives them.
QString write_attempt_report(const AttemptReport& report, const QString& file);

}  // namespace swage::console
