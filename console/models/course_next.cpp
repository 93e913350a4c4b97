// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/course_next.hpp"

#include <QCoreApplication>

#include "console/models/said.hpp"
#include "record/progress.hpp"

namespace swage::console {
namespace {

class NextWords {
  Q_DECLARE_TR_FUNCTIONS(course_next)
};

// How far a person is with a lesson by its rule. A course counts attempts in Test alone.
QString step_words(const record::CourseStep& step, const record::StepStanding& stands) {
  const judge::Standing& s = stands.rule;
  if (s.passed) return NextWords::tr("passed");
  if (step.rule.kind == judge::PassRule::Kind::kLcCusum)
    return NextWords::tr("%1 Test attempts counted, learning-curve test at %L2 of %L3").arg(stands.tests).arg(s.sum, 0, 'f', 1).arg(step.rule.signal, 0, 'f', 1);
  if (s.is_earned) return NextWords::tr("only the first %1 Test attempts of a later day are missing, %2 done").arg(step.rule.later_day).arg(s.confirmed);
  return NextWords::tr("%1 of %2 Test attempts in a row").arg(s.in_a_row).arg(step.rule.in_a_row);
}

}  // namespace

CourseNext course_next(const record::Course& course, std::span<const record::AttemptRow> attempts) {
  CourseNext out;
  const std::vector<record::StepStanding> stands = record::standing(course, attempts);
  size_t passed = 0;
  QString next;
  for (size_t i = 0; i < course.steps.size(); ++i) {
    const record::CourseStep& step = course.steps[i];
    const QString id = QString::fromStdString(step.lesson_id);
    out.steps[id] = step_words(step, stands[i]);
    passed += stands[i].rule.passed;
    if (!out.lesson_id.isEmpty() || stands[i].rule.passed || !stands[i].is_open) continue;
    out.lesson_id = id;
    next = said(step.title.empty() ? step.lesson_id : step.title);
  }
  out.words = NextWords::tr("%1: %2 of %3 lessons passed.").arg(QString::fromStdString(course.title)).arg(passed).arg(course.steps.size());
  if (!next.isEmpty()) out.words += QLatin1Char(' ') + NextWords::tr("Next: %1, %2.").arg(next, out.steps[out.lesson_id]);
  return out;
}

std::optional<CourseNext> course_next(std::span<const record::Course> courses, std::span<const record::AttemptRow> attempts) {
  std::optional<CourseNext> out;
  for (const record::Course& course : courses) {
    if (course.steps.empty()) continue;
    out = course_next(course, attempts);
    if (!out->lesson_id.isEmpty()) break;
  }
  return out;
}

}  // namespace swage::console
