// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A person's standing, from the attempts alone: for the table of people and the order of attention.
#pragma once

#include <QDateTime>
#include <QString>
#include <QVector>

#include "record/store.hpp"

namespace swage::console {

struct Standing {
  int attempts = 0;         // that count: judged, by a person, not void
  int passed = 0;           // of these
  int lessons_passed = 0;   // lessons with at least one passed attempt
  QVector<bool> last;       // passed or not, oldest first, at most kLastShown
  QString last_utc, lesson;  // of the newest attempt, counted or not
  int failing = 0;          // attempts not passed in a row, up to the newest, in one lesson
  QString same_reason;      // their common reason, an event's id; "" where reasons differ
  int days = 0;             // since the newest attempt
};

constexpr int kLastShown = 8;

/// `newest_first`: attempts of one person, of any lesson.
Standing standing_of(const std::vector<const record::AttemptRow*>& newest_first, const QDateTime& now);

/// The larger, the more a person needs attention. From the third on each failed attempt in a row counts 1, or 2 where all have the same
/// reason; each week without practice counts 1, up to four.
double attention(const Standing& standing);
/// The reason in a few words: "5 not passed, dropped each time", "12 days without practice", "ready for a test"; or "".
QString attention_words(const Standing& standing);

}  // namespace swage::console
