// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What a person's course asks next, in words for the Run page.
#pragma once

#include <QHash>
#include <QString>
#include <optional>
#include <span>

#include "record/course.hpp"
#include "record/store.hpp"

namespace swage::console {

/// A lesson whose turn has not come.
struct ClosedLesson {
  QString words;  // "Not open yet in the course “Basic”: “Grasp” comes first (1 of 2 Test attempts in a row)."
  QString first;  // id of the lesson that comes first
};

struct CourseNext {
  QString words;                 // "Basic: 1 of 3 lessons passed. Next: Insertion"
  QString lesson_id;             // the first lesson that may be done now and is not passed; "" when all are passed
  QHash<QString, QString> steps; // by lesson id: "1 of 2 Test attempts in a row"
  QHash<QString, ClosedLesson> closed;  // by lesson id
};

CourseNext course_next(const record::Course& course, std::span<const record::AttemptRow> attempts);

/// The first unfinished course, or the last one where all are finished; no value without a course. Closed is what no course has open.
std::optional<CourseNext> course_next(std::span<const record::Course> courses, std::span<const record::AttemptRow> attempts);

}  // namespace swage::console
