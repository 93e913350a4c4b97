// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The pass rule of a course's lesson: its numbers, what it says, and what it does to trainees of several skills.
#pragma once

#include <QBoxLayout>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QSpinBox>
#include <QTimer>
#include <QWidget>

#include "console/link/course_editing.hpp"

namespace swage::console {

class RulePanel : public QWidget {
  Q_OBJECT
 public:
  /// `editing` outlives the panel.
  RulePanel(CourseEditing* editing, QWidget* parent);
  /// Shows the rule of the chosen lesson.
  void refresh();
  /// On a narrow screen what the rule says stands below its numbers, as beside them it would be a strip of a few letters.
  void set_narrow(bool narrow);

 private:
  void add_count(const QString& label, const char* name, int most, uint32_t judge::PassRule::*field, const QString& tip);
  void add_rate(const QString& label, const char* name, double most, double judge::PassRule::*field, const QString& tip);
  void add_numbers();
  QLayout* make_says(QWidget* parent);
  void simulate();

  CourseEditing* editing_;
  QTimer simulate_timer_;
  QBoxLayout* row_;
  QFormLayout* form_;
  QComboBox* kind_;
  QLabel *says_ = nullptr, *odds_ = nullptr;
  QVector<std::pair<QSpinBox*, uint32_t judge::PassRule::*>> counts_;
  QVector<std::pair<QDoubleSpinBox*, double judge::PassRule::*>> rates_;
};

}  // namespace swage::console
