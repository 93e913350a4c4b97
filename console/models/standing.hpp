// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where a person stands, from attempts alone: what the table of people says, and who needs attention.
#pragma once

#include <QDateTime>
#include <QString>
#include <QVector>

#include "record/store.hpp"

namespace swage::console {

struct Standing {
  int attempts = 0;         // that count: judged, by a person's hand, not void
  int passed = 0;           // of these
  int lessons_passed = 0;   // lessons with at least one
  QVector<bool> last;       // passed or not, oldest first, at most kLastShown
  QString last_utc, lesson;  // of the newest of all attempts
  int failing = 0;          // not passed in a row, at the end, in one lesson
  QString same_reason;      // why, where all of these have the same reason; an event's id
  int days = 0;             // since the newest
};

constexpr int kLastShown = 8;

/// `newest_first`: attempts of one person, of any lesson.
Standing standing_of(const std::vector<const record::AttemptRow*>& newest_first, const QDateTime& now);

/// The larger, the more a person needs attention. Attempts without a pass count once each from the third on, twice where the same
/// reason ends them all; a week without practice counts as one, up to four.
double attention(const Standing& standing);
/// The reason for it in a few words: "5 not passed, dropped each time", "12 days without practice", "ready for a test"; or "".
QString attention_words(const Standing& standing);

}  // namespace swage::console
