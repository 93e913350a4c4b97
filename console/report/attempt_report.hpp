// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Printed report of an attempt: result, metrics, ratings, worst moments, traces, the thesis's two plots, notes.
#pragma once

#include <QString>
#include <QVector>
#include <optional>
#include <vector>

#include "console/models/insertion.hpp"
#include "console/models/review.hpp"
#include "console/models/worst_moments.hpp"
#include "record/export.hpp"
#include "record/school.hpp"

namespace swage::console {

struct AttemptReport {
  const Review& review;
  const record::Recording& recording;
  QVector<WorstMoment> worst;
  std::optional<EntryTrack> track;
  std::vector<record::Note> notes;
  std::vector<record::Exported> about;  // the attempt as in exports; empty if it could not be read
};

/// Returns "" or the error. The pages show the person's code and name as the store gives them.
QString write_attempt_report(const AttemptReport& report, const QString& file);

}  // namespace swage::console
