// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How the Courses page displays a course, and how its widgets change it.
#include <QLocale>
#include <QStandardItemModel>
#include <algorithm>
#include <cmath>

#include "console/models/course_words.hpp"
#include "console/models/metric_bars.hpp"
#include "console/models/metric_titles.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "console/pages/courses_page.hpp"

namespace swage::console {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();

enum LimitColumn { kMetric, kLeast, kMost, kGate, kSource };

// A number that an instructor typed is shown as typed; one that was computed, with three digits.
QString shown(double value, const judge::Limit& limit, const QString& unit) {
  const int digits = limit.source == "instructor" ? 6 : 3;
  return std::isfinite(value) ? QLocale().toString(value * display_factor(unit), 'g', digits) : QString();
}

// "Time" alone would be read as a value in seconds
QString limit_title(const QString& id) {
  return id.startsWith(QLatin1String("points.")) ? CoursesPage::tr("Points lost: %1").arg(metric_title(id)) : metric_title(id);
}

}  // namespace

record::CourseStep* CoursesPage::step() {
  const int at = steps_->currentRow();
  return at >= 0 && static_cast<size_t>(at) < course_.steps.size() ? &course_.steps[static_cast<size_t>(at)] : nullptr;
}

void CoursesPage::edit(const QString& words, const std::function<void(record::Course&)>& change, int field) {
  if (filling_ || course_.id.empty()) return;
  record::Course after = course_;
  change(after);
  problem_->hide();
  desk_->change_course(course_, after, words, field);
}

void CoursesPage::edit_step(const QString& words, const std::function<void(record::CourseStep&)>& change, int field) {
  const int at = steps_->currentRow();
  if (!step()) return;
  edit(words, [&](record::Course& c) { change(c.steps[static_cast<size_t>(at)]); }, field < 0 ? -1 : field + 1000 * at);
}

// keeps the selection; a focused text field is not overwritten
void CoursesPage::refresh() {
  record::School* school = desk_->school();
  if (!school) {
    empty_->setText(desk_->problem());
    return stack_->setCurrentIndex(1);
  }
  courses_ = school->courses();
  std::erase_if(courses_, [](const record::Course& c) { return !c.archived_utc.empty(); });
  attempts_of_.clear();
  empty_->setText(tr("No course yet. A course is a row of lessons with a rule that says when each is passed."));
  stack_->setCurrentIndex(courses_.empty() ? 1 : 0);
  const bool before = std::exchange(filling_, true);
  std::vector<std::string> known;
  for (int i = 0; i < list_->count(); ++i) known.push_back(list_->item(i)->data(Qt::UserRole).toString().toStdString());
  list_->clear();
  int chosen = 0;
  for (const record::Course& c : courses_) {
    auto* item = new QListWidgetItem(QString::fromStdString(c.title), list_);
    item->setData(Qt::UserRole, QString::fromStdString(c.id));
    const bool fresh = course_.id.empty() && std::find(known.begin(), known.end(), c.id) == known.end();
    if (c.id == course_.id || fresh) chosen = list_->count() - 1;
  }
  fill_lessons();
  list_->setCurrentRow(chosen);
  filling_ = before;
  choose_course(list_->currentRow());
}

// A lesson with a faulty file is listed with its error, and cannot be selected.
void CoursesPage::fill_lessons() {
  const QString chosen = lesson_->currentData().toString();
  lesson_->clear();
  auto* items = qobject_cast<QStandardItemModel*>(lesson_->model());
  int first = -1, again = -1;
  for (int i = 0; i < lessons_->rowCount(); ++i) {
    const LessonEntry& lesson = lessons_->at(i);
    const bool faulty = !lesson.problem.isEmpty();
    lesson_->addItem((faulty ? tr("▲ faulty: ") : QString()) + said(lesson.title), lesson.id);
    if (faulty) {
      lesson_->setItemData(i, lesson.problem, Qt::ToolTipRole);
      if (items) items->item(i)->setEnabled(false);
      continue;
    }
    if (first < 0) first = i;
    if (again < 0 && lesson.id == chosen) again = i;
  }
  lesson_->setCurrentIndex(again >= 0 ? again : first);
}

void CoursesPage::choose_course(int row) {
  course_ = row >= 0 && static_cast<size_t>(row) < courses_.size() ? courses_[static_cast<size_t>(row)] : record::Course{};
  show_course();
}

void CoursesPage::show_course() {
  const bool before = std::exchange(filling_, true);
  const QString title = QString::fromStdString(course_.title);
  if (title_->text() != title) title_->setText(title);
  in_order_->setChecked(course_.in_order);
  const int at = steps_->currentRow();
  steps_->clear();
  int number = 0;
  for (const record::CourseStep& s : course_.steps) {
    const QString known = QString::fromStdString(s.lesson_id);
    const int row = lessons_->row_of(known);
    const QString fault = row < 0 ? tr("▲ not installed: ") : lessons_->at(row).problem.isEmpty() ? QString() : tr("▲ faulty: ");
    steps_->addItem(tr("%1  %3%2").arg(++number).arg(said(s.title.empty() ? s.lesson_id : s.title), fault));
  }
  steps_->setCurrentRow(std::clamp(at, course_.steps.empty() ? -1 : 0, static_cast<int>(course_.steps.size()) - 1));
  filling_ = before;
  show_step();
}

// Why a lesson of the course cannot be done at this station; "" where it can.
QString CoursesPage::fault_of(const record::CourseStep& s) const {
  const int row = lessons_->row_of(QString::fromStdString(s.lesson_id));
  if (row < 0) return tr("▲ This lesson is not installed here: nobody can do it at this station.");
  const QString& problem = lessons_->at(row).problem;
  return problem.isEmpty() ? QString() : tr("▲ The file of this lesson is faulty: nobody can do it. %1").arg(problem);
}

void CoursesPage::show_step() {
  const record::CourseStep* s = step();
  step_stack_->setCurrentIndex(s ? 0 : 1);
  if (!s) return;
  const bool before = std::exchange(filling_, true);
  step_title_->setText(said(s->title.empty() ? s->lesson_id : s->title));
  step_fault_->setText(fault_of(*s));
  step_fault_->setVisible(!step_fault_->text().isEmpty());
  open_->setChecked(s->is_open);
  const bool streak = s->rule.kind == judge::PassRule::Kind::kStreak;
  kind_->setCurrentIndex(streak ? 0 : 1);
  for (const auto& [box, field] : counts_) {
    box->setValue(static_cast<int>(s->rule.*field));
    const bool of_streak = field == &judge::PassRule::in_a_row || field == &judge::PassRule::later_day;
    box->setVisible(!of_streak || streak);
    rule_form_->labelForField(box)->setVisible(!of_streak || streak);
  }
  for (const auto& [box, field] : rates_) {
    box->setValue(s->rule.*field);
    box->setVisible(!streak);
    rule_form_->labelForField(box)->setVisible(!streak);
  }
  rule_says_->setText(rule_words(s->rule));
  show_limits();
  filling_ = before;
  simulate_timer_.start();
}

// with the limit whose number is being typed as the last row
void CoursesPage::fill_limits() {
  const record::CourseStep* s = step();
  if (!s) return;
  const bool before = std::exchange(filling_, true);
  std::vector<judge::Limit> all = s->limits;
  if (wanted_) all.push_back(*wanted_);
  limits_->setRowCount(static_cast<int>(all.size()));
  for (int i = 0; i < limits_->rowCount(); ++i) {
    const judge::Limit& l = all[static_cast<size_t>(i)];
    const QString id = QString::fromStdString(l.metric), unit = metric_unit(id, QString::fromStdString(l.unit));
    const QString suffix = display_unit(unit);
    const QString cells[] = {suffix.isEmpty() ? limit_title(id) : tr("%1, %2").arg(limit_title(id), suffix), shown(l.least, l, unit),
                             shown(l.most, l, unit), QString(), QString::fromStdString(l.source)};
    for (int c = 0; c < limits_->columnCount(); ++c) {
      auto* item = new QTableWidgetItem(cells[c]);
      item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
      if (c == kLeast || c == kMost) item->setFlags(item->flags() | Qt::ItemIsEditable);
      if (c == kGate) item->setFlags(item->flags() | Qt::ItemIsUserCheckable), item->setCheckState(l.is_gate ? Qt::Checked : Qt::Unchecked);
      limits_->setItem(i, c, item);
    }
  }
  filling_ = before;
}

void CoursesPage::show_limits() {
  const record::CourseStep* s = step();
  const int row = limits_->currentRow(), column = limits_->currentColumn();
  wanted_.reset();
  fill_limits();
  if (row >= 0) limits_->setCurrentCell(std::min(row, limits_->rowCount() - 1), column);
  metric_->clear();
  for (const LessonMetric& m : metrics_(QString::fromStdString(s->lesson_id))) {
    const auto same = [&](const judge::Limit& l) { return l.metric == m.id.toStdString(); };
    if (std::none_of(s->limits.begin(), s->limits.end(), same)) metric_->addItem(limit_title(m.id), m.id);
  }
  together_->setText(s->limits.empty() ? tr("No limits: the lesson's own verdict is all that is asked.")
                                       : together_words(s->limits, experts()));
}

void CoursesPage::simulate() {
  const record::CourseStep* s = step();
  if (!s) return;
  const QStringList odds = rule_odds(s->rule);
  odds_->setText(odds.isEmpty() ? QString() : QStringLiteral("• ") + odds.join(QStringLiteral("\n• ")));
}

void CoursesPage::add_lesson() {
  const int row = lessons_->row_of(lesson_->currentData().toString()), at = steps_->currentRow() + 1;
  if (row < 0) return;
  if (!lessons_->at(row).problem.isEmpty()) {
    return show_problem(lessons_->at(row).problem);
  }
  record::CourseStep fresh;
  fresh.lesson_id = lessons_->at(row).id.toStdString();
  fresh.title = lessons_->at(row).title.toStdString();
  edit(tr("Add a lesson"), [&](record::Course& c) { c.steps.insert(c.steps.begin() + at, fresh); });
  steps_->setCurrentRow(at);
  if (title_->hasFocus()) steps_->setFocus();  // a focused text field would handle Ctrl+Z itself
  for (int next = lesson_->currentIndex() + 1; next < lesson_->count(); ++next) {
    if (!lessons_->at(next).problem.isEmpty()) continue;
    return lesson_->setCurrentIndex(next);  // the next lesson that can be added
  }
}

void CoursesPage::move_step(int by) {
  const int at = steps_->currentRow(), to = at + by;
  if (at < 0 || to < 0 || to >= steps_->count()) return;
  edit(tr("Order"), [&](record::Course& c) { std::swap(c.steps[static_cast<size_t>(at)], c.steps[static_cast<size_t>(to)]); });
  steps_->setCurrentRow(to);
}

void CoursesPage::add_limit() {
  const record::CourseStep* s = step();
  if (!s) return;
  judge::Limit fresh;
  fresh.metric = metric_->currentData().toString().toStdString();
  int32_t better = 0;
  for (const LessonMetric& m : metrics_(QString::fromStdString(s->lesson_id)))
    if (m.id.toStdString() == fresh.metric) fresh.unit = m.unit.toStdString(), better = m.better;
  if (fresh.metric.empty()) {
    problem_->setText(tr("▲ The metrics of this lesson are not known here: is it installed?"));
    return problem_->show();
  }
  const bool known = suggest_limit(fresh, experts(), better);
  const LimitColumn column = better == SWAGE_BETTER_HIGHER ? kLeast : kMost;
  if (known) {
    edit_step(tr("Add a limit"), [&](record::CourseStep& c) { c.limits.push_back(fresh); });
    return limits_->setCurrentCell(limits_->rowCount() - 1, column);
  }
  wanted_ = fresh;
  fill_limits();
  limits_->setCurrentCell(limits_->rowCount() - 1, column);
  limits_->editItem(limits_->currentItem());
}

// A limit whose number was not typed is dropped: none was written.
void CoursesPage::drop_wanted() {
  if (!wanted_) return;
  wanted_.reset();
  fill_limits();
}

void CoursesPage::limit_edited(int row, int column) {
  if (filling_ || !step()) return;
  const QString text = limits_->item(row, column)->text().trimmed();
  const bool is_new = static_cast<size_t>(row) == step()->limits.size();
  if (is_new && (!wanted_ || text.isEmpty())) return;
  const judge::Limit now = is_new ? *wanted_ : step()->limits[static_cast<size_t>(row)];
  const QString unit = metric_unit(QString::fromStdString(now.metric), QString::fromStdString(now.unit));
  bool ok = false;
  double value = QLocale().toDouble(text, &ok);
  if (!ok) value = text.toDouble(&ok);
  if (column != kGate && !text.isEmpty() && !ok) {
    show_problem(is_new ? tr("\"%1\" is no number; no limit is added.").arg(text)
                        : tr("\"%1\" is no number; the limit stays as it was.").arg(text));
    return show_step();
  }
  const bool gate = limits_->item(row, kGate)->checkState() == Qt::Checked;
  wanted_.reset();
  edit_step(is_new ? tr("Add a limit") : tr("Limit"), [&](record::CourseStep& s) {
    if (is_new) s.limits.push_back(now);
    judge::Limit& l = s.limits[static_cast<size_t>(row)];
    const double si = value / display_factor(unit);
    if (column == kLeast) l.least = text.isEmpty() ? -kInfinite : si;
    if (column == kMost) l.most = text.isEmpty() ? kInfinite : si;
    if (column == kGate) l.is_gate = gate;
    if (column != kGate) l.source = "instructor";
  });
}

void CoursesPage::suggest() {
  const record::CourseStep* s = step();
  if (!s) return;
  const auto metrics = metrics_(QString::fromStdString(s->lesson_id));
  const auto them = experts();
  if (them.empty() || s->limits.empty())
    return show_problem(s->limits.empty() ? tr("There is no limit yet to take from the experts: add one first.")
                                          : tr("No attempts of experts at this lesson: no limit is changed. Experts are the people of "
                                               "the group \"Experts\"."));
  edit_step(tr("Limits from experts"), [&](record::CourseStep& c) {
    for (judge::Limit& l : c.limits)
      for (const LessonMetric& m : metrics)
        if (m.id.toStdString() == l.metric) suggest_limit(l, them, m.better);
  });
}

std::vector<const record::AttemptRow*> CoursesPage::experts() {
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
