// SPDX-License-Identifier: LGPL-3.0-or-later
#include <QMessageBox>
#include <QPushButton>
#include <algorithm>

#include "console/models/live_params.hpp"
#include "console/models/variant.hpp"
#include "console/pages/run_page.hpp"
#include "console/pages/variant_dialog.hpp"

namespace swage::console {

void RunPage::make_variant() {
  const int row = lessons_->row_of(setup_->lesson());
  if (control_->running() || row < 0) return;
  const LessonEntry base = lessons_->at(row);
  const snapshot::SceneCard* card = card_of(base.path);
  if (!card) return preview();  // says what is wrong with it
  VariantDialog dialog(
      base, lesson_params(base.path.toStdString(), *card, catalogue_),
      [&](const auto& set) { return check(base.path, set); }, own_lessons_folder(), this);
  if (shown_lesson_ == base.path) dialog.preset(now_->form()->changed_values());
  if (dialog.exec() == QDialog::Accepted) setup_->select_lesson(lessons_->add_file(dialog.saved()));
}

void RunPage::edit_lesson() {
  const int row = lessons_->row_of(setup_->lesson());
  if (control_->running() || row < 0 || !is_own_lesson(setup_->lesson())) return;
  const LessonEntry lesson = lessons_->at(row);
  // a lesson that cannot be built has no values to show; its words can be changed
  const snapshot::SceneCard* card = card_of(lesson.path);
  const auto params = card ? lesson_params(lesson.path.toStdString(), *card, catalogue_) : QVector<LiveParam>();
  VariantDialog dialog(
      lesson, params, [&](const auto& set) { return set.isEmpty() ? QString() : check(lesson.path, set); }, this);
  if (card && shown_lesson_ == lesson.path) dialog.preset(now_->form()->changed_values());
  if (dialog.exec() != QDialog::Accepted) return;
  lessons_->read_again(row);
  preview();
}

void RunPage::delete_lesson() {
  const int row = lessons_->row_of(setup_->lesson());
  if (control_->running() || row < 0 || !is_own_lesson(setup_->lesson())) return;
  const LessonEntry lesson = lessons_->at(row);
  QMessageBox box(this);
  box.setObjectName(QStringLiteral("delete_question"));
  box.setWindowTitle(tr("Delete lesson"));
  box.setText(tr("\"%1\"").arg(lesson.title));
  const QStringList users = based_on_it(lesson.path);
  if (!users.isEmpty()) {
    box.setInformativeText(tr("It stays: these lessons are based on it and could not run without it: %1.")
                               .arg(users.join(QStringLiteral(", "))));
    box.exec();
    return;
  }
  box.setInformativeText(tr("The lesson goes into the bin. Attempts at it stay."));
  QPushButton* yes = box.addButton(tr("Delete"), QMessageBox::DestructiveRole);
  box.setDefaultButton(box.addButton(QMessageBox::Cancel));
  box.exec();
  if (box.clickedButton() != yes) return;
  if (const QString problem = swage::console::delete_lesson(lesson.path); !problem.isEmpty()) {
    problem_->setText(problem);
    problem_->show();
    return;
  }
  lessons_->remove(row);
  setup_->select_lesson(std::min(row, lessons_->rowCount() - 1));
}

QString RunPage::check(const QString& lesson_path, const QVector<std::pair<std::string, std::string>>& set) {
  session::Options o = base_;
  o.lesson_path = lesson_path.toStdString();
  for (const auto& [what, value] : set) o.settings.push_back(what + "=" + value);
  base::Problems problems;
  if (control_->preview(o, problems)) return {};
  for (const base::Problem& p : problems)
    if (p.severity == base::Severity::kError) return QString::fromStdString(p.message);
  return tr("The lesson cannot be built with these values.");
}

}  // namespace swage::console
