// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/lesson_requests.hpp"

#include "console/models/lesson_files.hpp"

namespace swage::console {

LessonRequests::LessonRequests(const WindowPages* pages, const SharedModels& models) : pages_(pages), models_(models) {
  RunPage* run = pages->run();
  LessonsPage* lessons = pages->lessons();
  lessons->set_checker([run](const QString& path) { return run->fault_of(path); });
  connect(run->control(), &RunControl::state_changed, this, [run, lessons] { lessons->set_running(run->control()->running()); });
  connect(lessons, &LessonsPage::run, this, [this, run](const QString& path, const QString& mode) {
    select(path);
    run->setup()->set_mode(mode);
    pages_->all()->go(QStringLiteral("run"));
  });
  connect_own();
  connect_files();
}

void LessonRequests::select(const QString& lesson) {
  if (const int row = models_.lessons->row_of(lesson); row >= 0) pages_->run()->setup()->select_lesson(row);
}

// The lesson that is chosen on the Run page now, as it is now.
void LessonRequests::show_again() {
  pages_->lessons()->select(pages_->run()->setup()->lesson());
  pages_->lessons()->show_lesson();
}

// The Run page makes, edits and deletes what is chosen there.
void LessonRequests::connect_own() {
  LessonsPage* lessons = pages_->lessons();
  const auto with_chosen = [this](void (RunPage::*call)()) {
    return [this, call](const QString& path) {
      select(path);
      const int before = models_.lessons->rowCount();
      (pages_->run()->*call)();
      show_again();
      if (models_.lessons->rowCount() > before) pages_->lessons()->tell(tr("Saved as a lesson of your own."));
    };
  };
  connect(lessons, &LessonsPage::make_variant, this, with_chosen(&RunPage::make_variant));
  connect(lessons, &LessonsPage::edit_lesson, this, with_chosen(&RunPage::edit_lesson));
  connect(lessons, &LessonsPage::delete_lesson, this, with_chosen(&RunPage::delete_lesson));
  pages_->run()->editing()->set_courses([desk = models_.desk](const QString& lesson_id) { return desk->courses_with(lesson_id); });
}

void LessonRequests::connect_files() {
  LessonsPage* lessons = pages_->lessons();
  const auto tell = [lessons](const QString& problem, const QString& good) {
    lessons->tell(problem.isEmpty() ? good : tr("▲ %1").arg(problem));
  };
  connect(lessons, &LessonsPage::import_lesson, this, [this, tell](const QString& file) {
    const QString problem = pages_->run()->editing()->import_file(file);
    show_again();
    tell(problem, tr("The lesson was imported."));
  });
  connect(lessons, &LessonsPage::export_lesson, this, [tell](const QString& path, const QString& file) {
    tell(console::export_lesson(path, file), tr("Saved to: %1").arg(file));
  });
}

}  // namespace swage::console
