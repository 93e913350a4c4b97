// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Pages about an attempt, to be printed: result, metrics, ratings, worst moments, traces, the thesis's two plots, notes.
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
  std::vector<record::Exported> about;  // the attempt as exports say it; none where that could not be read
};

/// "" or what went wrong. The pages say the person's code and name as the store shows them.
QString write_attempt_report(const AttemptReport& report, const QString& file);

}  // namespace swage::console
