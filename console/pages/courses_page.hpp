// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The Courses page: lessons in order, and the pass rule of each. Every edit is written at once and can be undone (CourseEditing); the rule
// and the limits of the chosen lesson have panels of their own.
#pragma once

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QStackedWidget>
#include <QWidget>

#include "console/link/course_editing.hpp"
#include "console/models/lessons_model.hpp"
#include "console/pages/limits_panel.hpp"
#include "console/pages/rule_panel.hpp"

namespace swage::console {

class CoursesPage : public QWidget {
  Q_OBJECT
 public:
  /// All outlive the page.
  CoursesPage(SchoolDesk* desk, StoreLink* link, LessonsModel* lessons, LessonMetrics metrics, QWidget* parent = nullptr);
  void refresh();
  const record::Course& course() const { return editing_.course(); }

 protected:
  /// Hides the problem, which is no longer news when the page is shown again.
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show_problem(const QString& why);
  QWidget* make_courses();
  QWidget* make_steps();
  QLayout* make_step_buttons(QWidget* parent);
  QWidget* make_step();
  QWidget* make_empty();
  void fill_courses();
  void fill_lessons();
  void fill_steps();
  QString fault_of(const record::CourseStep& step) const;
  void new_course();
  void choose_course(int row);
  void show_course();
  void show_step();
  void add_lesson();
  void move_step(int by);
  void remove_step();

  SchoolDesk* desk_;
  LessonsModel* lessons_;
  CourseEditing editing_;
  std::vector<record::Course> courses_;

  QStackedWidget *stack_ = nullptr, *step_stack_ = nullptr;
  QLabel *empty_ = nullptr, *step_title_ = nullptr, *step_fault_ = nullptr, *problem_ = nullptr;
  QListWidget *list_ = nullptr, *steps_ = nullptr;
  QLineEdit* title_ = nullptr;
  QCheckBox *in_order_ = nullptr, *open_ = nullptr;
  QComboBox* lesson_ = nullptr;
  RulePanel* rule_ = nullptr;
  LimitsPanel* limits_ = nullptr;
};

}  // namespace swage::console
