// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the course of the person on the Run page asks: the lesson that is next, and the order of a course "one after the other". Out of its
// turn a lesson may be watched and practised, the latter after a question; its test begins only with an instructor's reason, which the
// attempt keeps. [main]
#pragma once

#include <QObject>
#include <QSet>
#include <QTimer>
#include <functional>
#include <optional>

#include "console/models/course_next.hpp"
#include "console/models/lessons_model.hpp"

namespace swage::console {

class SetupPanel;

/// What a person's course asks next, by name; no value without a course.
using CourseFinder = std::function<std::optional<CourseNext>(const QString& name)>;

class CourseControl : public QObject {
  Q_OBJECT
 public:
  /// All outlive it.
  CourseControl(const LessonsModel* lessons, SetupPanel* setup, QWidget* page);
  void set_finder(CourseFinder find) { find_ = std::move(find); }
  /// Reads the course of the person anew and shows what it asks.
  void refresh();
  /// Whether an attempt of the chosen lesson may begin in the chosen mode; asks where its turn has not come.
  bool agree();
  /// The instructor's reason for the attempt that was agreed on last; "" where it was in its turn, or practice.
  const QString& reason() const { return reason_; }

  /// Row of the lesson that the course asks for next; -1 without one.
  int row();
  /// How far the person is with a lesson; "" where it is of no course of theirs.
  QString standing(const QString& lesson_path);

 private:
  QString id_of(const QString& lesson_path) const;
  const std::optional<CourseNext>& course();  // of the person who is chosen now
  ClosedLesson closed(const QString& lesson_path);  // without words where the lesson may begin
  void tell_closed();

  const LessonsModel* lessons_;
  SetupPanel* setup_;
  QWidget* page_;
  CourseFinder find_;
  std::optional<CourseNext> course_;
  QTimer later_;
  bool stale_ = false;  // another person is chosen than the one whose course was read
  QSet<QString> agreed_;  // person and lesson, practised out of turn: asked once while the program runs
  QString reason_;
};

}  // namespace swage::console
