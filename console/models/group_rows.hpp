// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How each person of a group stands, in one course or over all lessons: for the group's printed table. Pure functions.
#pragma once

#include <QString>
#include <QVector>
#include <optional>
#include <vector>

#include "console/models/standing.hpp"
#include "record/course.hpp"
#include "record/store.hpp"

namespace swage::console {

struct GroupRow {
  QString name, code;
  int lessons_passed = 0;           // in a course by its rules, else lessons with a passed attempt
  QVector<bool> passed_steps;       // of a course, in its order
  int attempts = 0, passed = 0;     // that count, in the course's lessons
  std::optional<double> last_score; // of the newest passed attempt that counts; 0 to 100
  QString last_utc;                 // of the newest attempt; "" for none
  double attention = 0;             // as in the table of people
  QString flag;                     // why the person needs attention; "" where not
};

/// `newest_first`: all attempts of the person, with metrics. Without a course: over all lessons.
GroupRow group_row(const record::Person& person, const std::vector<record::AttemptRow>& newest_first, const record::Course* course,
                   const QDateTime& now);

/// Those who need attention first, then by name.
void sort_by_attention(QVector<GroupRow>& rows);

}  // namespace swage::console
