// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/course_next.hpp"

#include <QCoreApplication>
#include <QSet>

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
  if (s.is_earned && step.rule.later_day == 1) return NextWords::tr("only the first Test attempt of a later day is missing");
  if (s.is_earned) return NextWords::tr("only the first %1 Test attempts of a later day are missing, %2 done").arg(step.rule.later_day).arg(s.confirmed);
  if (step.rule.in_a_row == 1) return NextWords::tr("no passed Test attempt yet");
  return NextWords::tr("%1 of %2 Test attempts in a row").arg(s.in_a_row).arg(step.rule.in_a_row);
}

QString title_of(const record::CourseStep& step) { return said(step.title.empty() ? step.lesson_id : step.title); }

// Lessons that may be done now: their turn has come, or they are passed already.
QSet<QString> open_lessons(const record::Course& course, const std::vector<record::StepStanding>& stands) {
  QSet<QString> out;
  for (size_t i = 0; i < course.steps.size(); ++i)
    if (stands[i].is_open || stands[i].rule.passed) out += QString::fromStdString(course.steps[i].lesson_id);
  return out;
}

// The others, each with the lesson that comes first: the one whose rule is not met yet and behind which the course is closed.
QHash<QString, ClosedLesson> closed_lessons(const record::Course& course, const std::vector<record::StepStanding>& stands) {
  QHash<QString, ClosedLesson> out;
  const QSet<QString> open = open_lessons(course, stands);
  QString first, first_id;
  for (size_t i = 0; i < course.steps.size(); ++i) {
    const record::CourseStep& step = course.steps[i];
    const QString id = QString::fromStdString(step.lesson_id);
    if (!open.contains(id))
      out[id] = {NextWords::tr("Not open yet in the course “%1”: %2.").arg(QString::fromStdString(course.title), first), first_id};
    if (!first.isEmpty() || stands[i].rule.passed || step.is_open) continue;
    first_id = id;
    first = NextWords::tr("“%1” comes first (%2)").arg(title_of(step), step_words(step, stands[i]));
  }
  return out;
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
    next = title_of(step);
  }
  out.closed = closed_lessons(course, stands);
  out.words = NextWords::tr("%1: %2 of %3 lessons passed.").arg(QString::fromStdString(course.title)).arg(passed).arg(course.steps.size());
  if (!next.isEmpty()) out.words += QLatin1Char(' ') + NextWords::tr("Next: %1, %2.").arg(next, out.steps[out.lesson_id]);
  return out;
}

std::optional<CourseNext> course_next(std::span<const record::Course> courses, std::span<const record::AttemptRow> attempts) {
  std::optional<CourseNext> out;
  QHash<QString, ClosedLesson> closed;
  QSet<QString> open;
  for (const record::Course& course : courses) {
    if (course.steps.empty()) continue;
    open += open_lessons(course, record::standing(course, attempts));
    CourseNext next = course_next(course, attempts);
    closed.insert(next.closed);
    if (!out || out->lesson_id.isEmpty()) out = std::move(next);
  }
  if (!out) return out;
  for (const QString& id : open) closed.remove(id);
  out->closed = closed;
  return out;
}

}  // namespace swage::console
