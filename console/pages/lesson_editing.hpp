// SPDX-License-Identifier: LGPL-3.0-or-later
//
// An instructor's own lessons, from the Run page: made from the chosen one, edited, deleted. [main]
#pragma once

#include <QObject>
#include <QVector>
#include <functional>
#include <map>
#include <memory>
#include <utility>

#include "console/link/run_control.hpp"
#include "console/models/lessons_model.hpp"
#include "console/pages/attempt_options.hpp"
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

  /// A lesson based on the chosen one. Each does nothing while an attempt runs.
  void make_variant();
  /// Title, task, goal and values of a lesson of the instructor's own.
  void edit();
  /// Into the bin, when nothing is based on it, after a question.
  void remove();

 Q_SIGNALS:
  /// The chosen lesson is another than before, or cannot be built: it is to be looked at again.
  void changed();
  void failed(const QString& words);

 private:
  /// Row of the chosen lesson; -1 where nothing may be changed now.
  int row() const;
  const snapshot::SceneCard* card_of(const QString& lesson_path);
  QString check(const QString& lesson_path, const QVector<std::pair<std::string, std::string>>& set);  // "" when it can be practised
  bool asked_to_delete(const LessonEntry& lesson);

  LessonsModel* lessons_;
  SetupPanel* setup_;
  RunControl* control_;
  const AttemptOptions& options_;
  QWidget* page_;
  LiveValues live_values_;
  std::map<QString, std::unique_ptr<snapshot::SceneCard>> cards_;  // by lesson file, as far as one was opened
};

}  // namespace swage::console
