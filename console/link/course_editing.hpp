// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The course that is edited, and the lesson chosen in it: every edit is written at once through the desk and can be undone. No widgets.
// GUI thread.
#pragma once

#include <QObject>
#include <QScopedValueRollback>
#include <QVector>
#include <functional>
#include <string>
#include <vector>

#include "console/link/school_desk.hpp"
#include "console/link/store_link.hpp"

namespace swage::console {

/// A metric of a lesson.
struct LessonMetric {
  QString id, unit;  // SI
  int32_t better = 0;
};
using LessonMetrics = std::function<QVector<LessonMetric>(const QString& lesson_id)>;

class CourseEditing : public QObject {
  Q_OBJECT
 public:
  /// Both outlive it.
  CourseEditing(SchoolDesk* desk, StoreLink* link, LessonMetrics metrics);

  const record::Course& course() const { return course_; }
  void set_course(const record::Course& course) { course_ = course; }
  void set_step(int at) { at_ = at; }
  int at() const { return at_; }
  /// The chosen lesson; nullptr for none.
  const record::CourseStep* step() const;

  /// Applies `change` to the course, or to its chosen lesson, and writes it. Successive edits of one `field` are undone together.
  void edit(const QString& words, const std::function<void(record::Course&)>& change, int field = -1);
  void edit_step(const QString& words, const std::function<void(record::CourseStep&)>& change, int field = -1);
  /// While what it returns exists, signals of widgets that are being filled are no edits.
  [[nodiscard]] QScopedValueRollback<bool> quiet() { return QScopedValueRollback<bool>(filling_, true); }
  bool filling() const { return filling_; }

  /// Of the chosen lesson.
  QVector<LessonMetric> metrics() const;
  /// Attempts of experts at the chosen lesson, read once after each change.
  std::vector<const record::AttemptRow*> experts();
  void forget_attempts() { attempts_of_.clear(); }

 Q_SIGNALS:
  /// An edit was begun: an earlier problem is no longer news.
  void edited();

 private:
  SchoolDesk* desk_;
  StoreLink* link_;
  LessonMetrics metrics_;
  record::Course course_;
  int at_ = -1;
  std::vector<record::AttemptRow> attempts_;
  std::string attempts_of_;
  bool filling_ = false;
};

}  // namespace swage::console
