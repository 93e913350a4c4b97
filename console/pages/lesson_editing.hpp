// SPDX-License-Identifier: LGPL-3.0-or-later
//
// An instructor's own lessons, from the Run page: derived from the chosen one, edited, deleted, imported. [main]
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
  /// Parameters of a lesson that were changed during an attempt, and may be kept in a derived lesson.
  using LiveValues = std::function<QVector<LiveForm::Change>(const QString& lesson_path)>;
  void set_live_values(LiveValues values) { live_values_ = std::move(values); }
  /// Applies the window's colours to the picture of the edited lesson.
  void set_dress(std::function<void(SceneView&)> dress) { dress_ = std::move(dress); }

  /// Titles of the courses that contain a lesson with this id.
  void set_courses(std::function<QStringList(const QString& lesson_id)> courses) { courses_ = std::move(courses); }

  /// Derives a lesson from the chosen one. This and the functions below have no effect during an attempt.
  void make_variant();
  /// Edits title, task, goal, parts and values of one of the instructor's own lessons.
  void edit();
  /// Moves the lesson to the bin, after a question, unless other lessons are derived from it.
  void remove();
  /// Adds a lesson file to the own lessons and chooses it. Returns "" or the error.
  QString import_file(const QString& file);

 Q_SIGNALS:
  /// The chosen lesson changed, or cannot be built: its display must be updated.
  void changed();
  void failed(const QString& words);
  /// The chosen lesson was saved and is to be run.
  void try_it();

 private:
  /// Row of the chosen lesson; -1 while lessons may not be changed.
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
