// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/pages/lesson_editing.hpp"

#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "console/models/live_params.hpp"
#include "console/models/variant.hpp"
#include "console/pages/variant_dialog.hpp"

namespace swage::console {

LessonEditing::LessonEditing(LessonsModel* lessons, SetupPanel* setup, RunControl* control, const AttemptOptions& options, QWidget* page)
    : QObject(page), lessons_(lessons), setup_(setup), control_(control), options_(options), page_(page) {}

int LessonEditing::row() const { return control_->running() ? -1 : lessons_->row_of(setup_->lesson()); }

// a lesson's card does not change while the program runs; a running session is not disturbed for it
const snapshot::SceneCard* LessonEditing::card_of(const QString& lesson_path) {
  const auto known = cards_.find(lesson_path);
  if (known != cards_.end()) return known->second.get();
  base::Problems problems;
  return (cards_[lesson_path] = control_->preview(options_.of(lesson_path), problems)).get();
}

void LessonEditing::make_variant() {
  if (row() < 0) return;
  const LessonEntry base = lessons_->at(row());
  const snapshot::SceneCard* card = card_of(base.path);
  if (!card) return Q_EMIT changed();  // says what is wrong with it
  VariantDialog dialog(
      base, lesson_params(base.path.toStdString(), *card, options_.catalogue()),
      [&](const auto& set) { return check(base.path, set); }, own_lessons_folder(), page_);
  dialog.preset(live_values_(base.path));
  if (dialog.exec() == QDialog::Accepted) setup_->select_lesson(lessons_->add_file(dialog.saved()));
}

void LessonEditing::edit() {
  if (row() < 0 || !is_own_lesson(setup_->lesson())) return;
  const LessonEntry lesson = lessons_->at(row());
  // a lesson that cannot be built has no values to show; its words can be changed
  const snapshot::SceneCard* card = card_of(lesson.path);
  const auto params = card ? lesson_params(lesson.path.toStdString(), *card, options_.catalogue()) : QVector<LiveParam>();
  VariantDialog dialog(
      lesson, params, [&](const auto& set) { return set.isEmpty() ? QString() : check(lesson.path, set); }, page_);
  if (card) dialog.preset(live_values_(lesson.path));
  if (dialog.exec() != QDialog::Accepted) return;
  lessons_->read_again(row());
  Q_EMIT changed();
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
    box.setInformativeText(tr("It stays: these lessons are based on it and could not run without it: %1.")
                               .arg(users.join(QStringLiteral(", "))));
    box.exec();
    return false;
  }
  box.setInformativeText(tr("The lesson goes into the bin. Attempts at it stay."));
  QPushButton* yes = box.addButton(tr("Delete"), QMessageBox::DestructiveRole);
  box.setDefaultButton(box.addButton(QMessageBox::Cancel));
  box.exec();
  return box.clickedButton() == yes;
}

QString LessonEditing::check(const QString& lesson_path, const QVector<std::pair<std::string, std::string>>& set) {
  session::Options o = options_.of(lesson_path);
  for (const auto& [what, value] : set) o.settings.push_back(what + "=" + value);
  base::Problems problems;
  if (control_->preview(o, problems)) return {};
  for (const base::Problem& p : problems)
    if (p.severity == base::Severity::kError) return QString::fromStdString(p.message);
  return tr("The lesson cannot be built with these values.");
}

}  // namespace swage::console
