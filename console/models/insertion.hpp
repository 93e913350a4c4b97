// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The thesis's entry penetration: where the needle's centre line crossed the surface while in the tissue, seen perpendicular to
// the surface, with the circle of the needle at the first puncture. The area outside the circle is torn.
#pragma once

#include <QPolygonF>
#include <QVector>
#include <optional>

#include "record/recorder.hpp"

namespace swage::console {

struct EntryTrack {
  QVector<QPolygonF> passes;        // one per entry; mm in the surface, the first puncture at (0, 0)
  QVector<QVector<double>> time_s;  // of every point
  double radius_mm = 0;             // of the needle; 0 when the recording lacks it
  QVector<QPolygonF>
      cosine;  // one line per stay in the tissue: time, s, and cosine of the penetration angle: 0 perfect, 1 worst
  double mean_cosine = 0;  // mean over the time in the tissue
  double wound = 0;        // greatest distance of the wound's edge over the needle's radius; 1 is perfect
};

/// No value when the recording lacks the signals pierce.at_* or the needle never entered.
std::optional<EntryTrack> entry_track(const record::Recording& recording);

}  // namespace swage::console
