// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/link/course_editing.hpp"

#include "console/models/metric_bars.hpp"

namespace swage::console {

CourseEditing::CourseEditing(SchoolDesk* desk, StoreLink* link, LessonMetrics metrics)
    : desk_(desk), link_(link), metrics_(std::move(metrics)) {}

const record::CourseStep* CourseEditing::step() const {
  return at_ >= 0 && static_cast<size_t>(at_) < course_.steps.size() ? &course_.steps[static_cast<size_t>(at_)] : nullptr;
}

void CourseEditing::edit(const QString& words, const std::function<void(record::Course&)>& change, int field) {
  if (filling_ || course_.id.empty()) return;
  record::Course after = course_;
  change(after);
  Q_EMIT edited();
  desk_->change_course(course_, after, words, field);
}

void CourseEditing::edit_step(const QString& words, const std::function<void(record::CourseStep&)>& change, int field) {
  if (!step()) return;
  const int at = at_;
  edit(words, [&](record::Course& c) { change(c.steps[static_cast<size_t>(at)]); }, field < 0 ? -1 : field + 1000 * at);
}

QVector<LessonMetric> CourseEditing::metrics() const {
  return step() ? metrics_(QString::fromStdString(step()->lesson_id)) : QVector<LessonMetric>();
}

std::vector<const record::AttemptRow*> CourseEditing::experts() {
  std::vector<std::string> ids;
  const record::CourseStep* s = step();
  record::School* school = desk_->school();
  if (!s || !school) return {};
  for (const record::Group& g : school->groups()) {
    if (!is_expert_group(QString::fromStdString(g.name))) continue;
    for (const record::Person& p : school->people())
      if (p.group_id == g.id) ids.push_back(p.id);
  }
  // read again only after a change
  if (attempts_of_ != s->lesson_id) {
    const std::shared_ptr<record::Store> store = link_->store();
    attempts_ = store ? read_expert_attempts(*store, ids, s->lesson_id) : std::vector<record::AttemptRow>();
    attempts_of_ = s->lesson_id;
  }
  return expert_attempts(attempts_, ids, s->lesson_id);
}

}  // namespace swage::console
