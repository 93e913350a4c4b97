// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The Courses page: lessons in order, and the pass rule of each. Every edit is written at once and can be undone.
#pragma once

#include <QBoxLayout>
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QSpinBox>
#include <QStackedWidget>
#include <QTableWidget>
#include <QTimer>
#include <QWidget>
#include <functional>
#include <optional>

#include "console/link/school_desk.hpp"
#include "console/link/store_link.hpp"
#include "console/models/lessons_model.hpp"

namespace swage::console {

/// A metric of a lesson.
struct LessonMetric {
  QString id, unit;  // SI
  int32_t better = 0;
};
using LessonMetrics = std::function<QVector<LessonMetric>(const QString& lesson_id)>;

class CoursesPage : public QWidget {
  Q_OBJECT
 public:
  /// All outlive the page.
  CoursesPage(SchoolDesk* desk, StoreLink* link, LessonsModel* lessons, LessonMetrics metrics, QWidget* parent = nullptr);
  void refresh();
  const record::Course& course() const { return course_; }

 protected:
  /// Hides the problem, which is no longer news when the page is shown again.
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void show_problem(const QString& why);
  QWidget* make_courses();
  QWidget* make_steps();
  QWidget* make_step();
  QWidget* make_rule();
  QWidget* make_limits();
  QWidget* make_empty();
  QSpinBox* add_count(QFormLayout* form, const QString& label, const char* name, int most, uint32_t judge::PassRule::*field,
                      const QString& tip);
  QDoubleSpinBox* add_rate(QFormLayout* form, const QString& label, const char* name, double most,
                           double judge::PassRule::*field, const QString& tip);
  record::CourseStep* step();
  /// Applies `change` to the course and writes it.
  void edit(const QString& words, const std::function<void(record::Course&)>& change, int field = -1);
  void edit_step(const QString& words, const std::function<void(record::CourseStep&)>& change, int field = -1);
  void fill_lessons();
  QString fault_of(const record::CourseStep& step) const;
  void choose_course(int row);
  void show_course();
  void show_step();
  void show_limits();
  void fill_limits();
  void drop_wanted();
  void simulate();
  void add_lesson();
  void move_step(int by);
  void add_limit();
  void limit_edited(int row, int column);
  void suggest();
  std::vector<const record::AttemptRow*> experts();

  SchoolDesk* desk_;
  StoreLink* link_;
  LessonsModel* lessons_;
  LessonMetrics metrics_;
  std::vector<record::Course> courses_;
  record::Course course_;  // the selected course
  std::optional<judge::Limit> wanted_;  // a new limit until its number is typed; not written
  std::vector<record::AttemptRow> attempts_;  // of experts at the selected lesson
  std::string attempts_of_;
  QTimer simulate_timer_;
  bool filling_ = false;  // while true, widget signals are not edits

  QStackedWidget *stack_ = nullptr, *step_stack_ = nullptr;
  QLabel *empty_ = nullptr, *odds_ = nullptr, *rule_says_ = nullptr, *together_ = nullptr, *step_title_ = nullptr, *step_fault_ = nullptr, *problem_ = nullptr;
  QListWidget *list_ = nullptr, *steps_ = nullptr;
  QLineEdit* title_ = nullptr;
  QCheckBox *in_order_ = nullptr, *open_ = nullptr;
  QComboBox *lesson_ = nullptr, *kind_ = nullptr, *metric_ = nullptr;
  QTableWidget* limits_ = nullptr;
  QVector<std::pair<QSpinBox*, uint32_t judge::PassRule::*>> counts_;
  QVector<std::pair<QDoubleSpinBox*, double judge::PassRule::*>> rates_;
  QFormLayout* rule_form_ = nullptr;
  QBoxLayout* rule_row_ = nullptr;
};

}  // namespace swage::console
