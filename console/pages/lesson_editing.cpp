// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/lesson_editing.hpp"

#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "console/models/lesson_files.hpp"
#include "console/models/said.hpp"
#include "console/models/variant.hpp"

namespace swage::console {

LessonEditing::LessonEditing(LessonsModel* lessons, SetupPanel* setup, RunControl* control, const AttemptOptions& options, QWidget* page)
    : QObject(page), lessons_(lessons), setup_(setup), control_(control), options_(options), page_(page) {}

int LessonEditing::row() const { return control_->running() ? -1 : lessons_->row_of(setup_->lesson()); }

// scenes are built independently of a running session, and never stepped
VariantDialog::Services LessonEditing::services() {
  const auto build = [this](const QString& path, base::Problems& problems) { return control_->preview(options_.of(path), problems); };
  return {build, options_.catalogue(), lesson_drafts_folder(), dress_};
}

void LessonEditing::make_variant() {
  if (row() < 0) return;
  const LessonEntry base = lessons_->at(row());
  VariantDialog dialog(base, services(), own_lessons_folder(), page_);
  dialog.preset(live_values_(base.path));
  if (dialog.exec() != QDialog::Accepted) return;
  setup_->select_lesson(lessons_->add_file(dialog.saved()));
  if (dialog.to_try()) Q_EMIT try_it();
}

void LessonEditing::edit() {
  if (row() < 0 || !is_own_lesson(setup_->lesson())) return;
  const LessonEntry lesson = lessons_->at(row());
  VariantDialog dialog(lesson, services(), {}, page_);
  dialog.preset(live_values_(lesson.path));
  if (dialog.exec() != QDialog::Accepted) return;
  lessons_->read_again(row());
  Q_EMIT changed();
  if (dialog.to_try()) Q_EMIT try_it();
}

QString LessonEditing::import_file(const QString& file) {
  if (control_->running()) return tr("Lessons cannot be imported while one is running.");
  const LessonEntry entry = read_lesson(file);
  if (const int known = entry.id.isEmpty() ? -1 : lessons_->row_of(entry.id); known >= 0)
    return tr("The lesson \"%1\" is here already.").arg(said(lessons_->at(known).title));
  const ImportPlaces places{own_lessons_folder(), lesson_drafts_folder() + QStringLiteral("/import.json"), lesson_folders()};
  const Imported imported = import_lesson(file, places, options_.catalogue(), services().build);
  if (imported.problem.isEmpty()) setup_->select_lesson(lessons_->add_file(imported.path));
  return imported.problem;
}

void LessonEditing::remove() {
  if (row() < 0 || !is_own_lesson(setup_->lesson())) return;
  const int at = row();
  const LessonEntry lesson = lessons_->at(at);
  if (!asked_to_delete(lesson)) return;
  if (const QString problem = delete_lesson(lesson.path); !problem.isEmpty()) return Q_EMIT failed(problem);
  lessons_->remove(at);
  setup_->select_lesson(std::min(at, lessons_->rowCount() - 1));
}

bool LessonEditing::asked_to_delete(const LessonEntry& lesson) {
  QMessageBox box(page_);
  box.setObjectName(QStringLiteral("delete_question"));
  box.setWindowTitle(tr("Delete lesson"));
  box.setText(tr("\"%1\"").arg(lesson.title));
  const QStringList users = based_on_it(lesson.path);
  if (!users.isEmpty()) {
    box.setInformativeText(tr("It was not deleted: these lessons are based on it and could not run without it: %1.")
                               .arg(users.join(QStringLiteral(", "))));
    box.exec();
    return false;
  }
  QString words = tr("The lesson goes into the bin. Attempts at it stay.");
  const QStringList courses = courses_ ? courses_(lesson.id) : QStringList();
  if (!courses.isEmpty()) words += QLatin1Char(' ') + tr("It is part of these courses: %1.").arg(courses.join(QStringLiteral(", ")));
  box.setInformativeText(words);
  QPushButton* yes = box.addButton(tr("Delete"), QMessageBox::DestructiveRole);
  box.setDefaultButton(box.addButton(QMessageBox::Cancel));
  box.exec();
  return box.clickedButton() == yes;
}

}  // namespace swage::console
