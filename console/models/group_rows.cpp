// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/group_rows.hpp"

#include <algorithm>

#include "console/models/attempts_model.hpp"
#include "record/progress.hpp"

namespace swage::console {
namespace {

bool is_of(const record::Course& course, const record::AttemptRow& attempt) {
  return std::any_of(course.steps.begin(), course.steps.end(), [&](const record::CourseStep& s) { return s.lesson_id == attempt.lesson_id; });
}

}  // namespace

GroupRow group_row(const record::Person& person, const std::vector<record::AttemptRow>& newest_first, const record::Course* course,
                   const QDateTime& now) {
  std::vector<const record::AttemptRow*> here;
  for (const record::AttemptRow& a : newest_first)
    if (!course || is_of(*course, a)) here.push_back(&a);
  const Standing stands = standing_of(here, now);
  GroupRow out;
  out.name = QString::fromStdString(person.name);
  out.code = QString::fromStdString(person.code);
  out.attempts = stands.attempts;
  out.passed = stands.passed;
  out.lessons_passed = stands.lessons_passed;
  out.last_utc = stands.last_utc;
  out.attention = attention(stands);
  if (out.attention > 0) out.flag = attention_words(stands);
  for (const record::AttemptRow* a : here) {
    if (!counts(*a) || !has_score(*a)) continue;
    out.last_score = a->score;
    break;
  }
  if (!course) return out;
  for (const record::StepStanding& step : record::standing(*course, newest_first)) out.passed_steps += step.rule.passed;
  out.lessons_passed = static_cast<int>(out.passed_steps.count(true));
  return out;
}

void sort_by_attention(QVector<GroupRow>& rows) {
  std::stable_sort(rows.begin(), rows.end(), [](const GroupRow& a, const GroupRow& b) {
    if (a.attention != b.attention) return a.attention > b.attention;
    return a.name.localeAwareCompare(b.name) < 0;
  });
}

}  // namespace swage::console
