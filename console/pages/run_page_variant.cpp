// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/live_params.hpp"
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
  if (dialog.exec() == QDialog::Accepted) setup_->select_lesson(lessons_->add_file(dialog.saved()));
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
