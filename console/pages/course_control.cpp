// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/course_control.hpp"

#include <QWidget>

#include "console/models/said.hpp"
#include "console/pages/order_dialog.hpp"
#include "console/pages/setup_panel.hpp"

namespace swage::console {

CourseControl::CourseControl(const LessonsModel* lessons, SetupPanel* setup, QWidget* page)
    : QObject(page), lessons_(lessons), setup_(setup), page_(page) {
  // a name that is typed changes with each letter: its course is read once, when the keys have been handled
  later_.setSingleShot(true);
  later_.setInterval(0);
  connect(&later_, &QTimer::timeout, this, &CourseControl::refresh);
  connect(setup, &SetupPanel::person_chosen, this, [this] {
    stale_ = true;
    later_.start();
  });
  connect(setup, &SetupPanel::lesson_changed, this, &CourseControl::tell_closed);
}

void CourseControl::refresh() {
  later_.stop();
  stale_ = false;
  course_ = find_ ? find_(setup_->person()) : std::nullopt;
  setup_->set_course(course_ ? course_->words : QString(), row());  // it is fresh: row() reads nothing
  tell_closed();
}

QString CourseControl::id_of(const QString& lesson_path) const {
  const int row = lessons_->row_of(lesson_path);
  return row < 0 ? QString() : lessons_->at(row).id;
}

const std::optional<CourseNext>& CourseControl::course() {
  if (stale_) refresh();
  return course_;
}

int CourseControl::row() { return course() && !course_->lesson_id.isEmpty() ? lessons_->row_of(course_->lesson_id) : -1; }

QString CourseControl::standing(const QString& lesson_path) { return course() ? course_->steps.value(id_of(lesson_path)) : QString(); }

ClosedLesson CourseControl::closed(const QString& lesson_path) {
  return course() ? course_->closed.value(id_of(lesson_path)) : ClosedLesson{};
}

void CourseControl::tell_closed() { setup_->set_not_open(closed(setup_->lesson()).words); }

bool CourseControl::agree() {
  reason_.clear();
  const ClosedLesson why = closed(setup_->lesson());
  if (why.words.isEmpty()) return true;
  const bool test = setup_->mode() == QLatin1String("test");
  const QString subject = setup_->person() + QLatin1Char('\n') + id_of(setup_->lesson());
  if (!test && agreed_.contains(subject)) return true;
  const int first = lessons_->row_of(why.first);
  OrderDialog dialog(why.words, first < 0 ? QString() : said(lessons_->at(first).title), test, page_->window());
  dialog.exec();
  if (dialog.answer() == OrderDialog::Answer::kToTheFirst) {
    setup_->select_lesson(first);
    setup_->focus_start();
  }
  if (dialog.answer() != OrderDialog::Answer::kBegin) return false;
  if (!test) agreed_ += subject;
  reason_ = dialog.reason();
  return true;
}

}  // namespace swage::console
