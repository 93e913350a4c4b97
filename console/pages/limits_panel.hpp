// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The limits of a course's lesson, besides its own verdict: a table whose numbers are typed, or taken from experts.
#pragma once

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QTableWidget>
#include <QWidget>
#include <optional>

#include "console/link/course_editing.hpp"

namespace swage::console {

class LimitsPanel : public QWidget {
  Q_OBJECT
 public:
  /// `editing` outlives the panel.
  LimitsPanel(CourseEditing* editing, QWidget* parent);
  /// Shows the limits of the chosen lesson.
  void refresh();
  /// On a narrow screen the list of metrics stands above the buttons.
  void set_narrow(bool narrow);

 Q_SIGNALS:
  /// Why nothing was changed.
  void refused(const QString& why);

 private:
  void make_table(QWidget* parent);
  QLayout* make_buttons(QWidget* parent);
  void fill();
  void drop_wanted();
  void add_limit();
  void remove_limit();
  void edit_cell(int row, int column);
  void suggest();

  CourseEditing* editing_;
  std::optional<judge::Limit> wanted_;  // a new limit until its number is typed; not written
  QTableWidget* table_ = nullptr;
  QLabel* together_ = nullptr;
  QComboBox* metric_ = nullptr;
  QBoxLayout* row_ = nullptr;
};

}  // namespace swage::console
