// SPDX-License-Identifier: LGPL-3.0-or-later
//
// An instructor's own lessons, from the Run page: made from the chosen one, edited, deleted, imported. [main]
#pragma once

#include <QObject>
#include <QVector>
#include <functional>
#include <memory>

#include "console/link/run_control.hpp"
#include "console/models/lessons_model.hpp"
#include "console/pages/attempt_options.hpp"
#include "console/pages/variant_dialog.hpp"
#include "console/widgets/live_form.hpp"

class QWidget;

namespace swage::console {

class LessonEditing : public QObject {
  Q_OBJECT
 public:
  LessonEditing(LessonsModel* lessons, SetupPanel* setup, RunControl* control, const AttemptOptions& options, QWidget* page);
  /// Values of a lesson that were changed beside the picture, and may be kept.
  using LiveValues = std::function<QVector<LiveForm::Change>(const QString& lesson_path)>;
  void set_live_values(LiveValues values) { live_values_ = std::move(values); }
  /// Gives the picture of a lesson that is edited the window's colours.
  void set_dress(std::function<void(SceneView&)> dress) { dress_ = std::move(dress); }

  /// Titles of the courses that have a lesson of this id.
  void set_courses(std::function<QStringList(const QString& lesson_id)> courses) { courses_ = std::move(courses); }

  /// A lesson based on the chosen one. Each does nothing while an attempt runs.
  void make_variant();
  /// Title, task, goal, parts and values of a lesson of the instructor's own.
  void edit();
  /// Into the bin, when nothing is based on it, after a question.
  void remove();
  /// A lesson file from elsewhere among one's own, and chosen. Returns why not, or "".
  QString import_file(const QString& file);

 Q_SIGNALS:
  /// The chosen lesson is another than before, or cannot be built: it is to be looked at again.
  void changed();
  void failed(const QString& words);
  /// The chosen lesson, just saved, is to be practised.
  void try_it();

 private:
  /// Row of the chosen lesson; -1 where nothing may be changed now.
  int row() const;
  VariantDialog::Services services();
  bool asked_to_delete(const LessonEntry& lesson);

  LessonsModel* lessons_;
  SetupPanel* setup_;
  RunControl* control_;
  const AttemptOptions& options_;
  QWidget* page_;
  LiveValues live_values_;
  std::function<void(SceneView&)> dress_;
  std::function<QStringList(const QString&)> courses_;
};

}  // namespace swage::console
