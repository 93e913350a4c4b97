// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Left side of the Run page: person, lesson, mode, device, START. No field is mandatory.
#pragma once

#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QListView>
#include <QPushButton>
#include <QWidget>

#include "console/models/lessons_model.hpp"

namespace swage::console {

class SetupPanel : public QWidget {
  Q_OBJECT
 public:
  explicit SetupPanel(LessonsModel* lessons, QWidget* parent = nullptr);

  QString person() const;  // "Guest" when nobody is named
  void set_people(const QStringList& names, const QString& current);
  /// Accepts a name without a question although nobody has practised under it: given on the command line, or confirmed.
  void know_person(const QString& name) { known_ += name; }
  /// True when nobody has practised or been entered under the present name: it may be a typing error.
  bool person_is_new() const;
  /// Moves the focus to the name, with its text selected, or to START, else to the lessons.
  void focus_person();
  void focus_start();
  bool has_lessons() const;
  QString lesson() const;  // path, "" when there is none
  void select_lesson(int row);
  QString mode() const;  // "practice", "test", "demo"
  void set_mode(const QString& mode);
  QString device() const;  // for session::Options::device
  QString device_name() const { return device_->currentText(); }
  void set_device(const QString& device);
  /// The name of the person's own instrument; "" when there is none.
  void set_own_instrument(const QString& title);
  bool left_handed() const { return left_->isChecked(); }  // mirrors the lesson
  bool mirrored() const;                                   // by that switch or by its file
  void set_left_handed(bool on) { left_->setChecked(on); }
  QString summary() const;  // the lesson's task
  QString task() const;     // the task and the learning goal
  /// Sets the text of START for a running or paused attempt.
  void set_running(bool running, bool paused = false);
  /// False when the chosen lesson cannot be built: disables START.
  void set_startable(bool on);
  bool startable() const { return startable_; }
  /// True for a demonstration, which has no modes.
  void set_show(bool show);
  /// What the person's course asks next, and the row of that lesson, -1 for none; "" without a course.
  void set_course(const QString& words, int row);
  /// Why the turn of the chosen lesson has not come in the person's course; "" where it has.
  void set_not_open(const QString& words);
  bool has_next() const;
  void select_next();

 Q_SIGNALS:
  void start();
  void lesson_changed();
  void mode_changed();
  void person_chosen();
  void make_variant();
  void edit_lesson();
  void delete_lesson();

 private:
  QWidget* make_who();
  QWidget* make_lessons(LessonsModel* lessons);
  QHBoxLayout* make_own(QWidget* parent);
  QWidget* make_mode();
  void fill_devices();
  QString lesson_device() const;
  void update_start();
  void update_course();

  QComboBox *person_, *device_;
  QCheckBox* left_ = nullptr;
  QListView* lessons_;
  QLabel* no_lessons_;
  QButtonGroup* modes_;
  QPushButton *start_ = nullptr, *variant_ = nullptr, *edit_ = nullptr, *delete_ = nullptr;
  QStringList known_;
  QString wanted_device_, own_instrument_;  // wanted_device_: "" is the lesson's first choice
  bool running_ = false, paused_ = false, startable_ = true, show_ = false;
  QLabel *explain_ = nullptr, *course_ = nullptr, *not_open_ = nullptr;
  QPushButton* to_course_ = nullptr;
  int course_row_ = -1;
  void update_modes();
};

}  // namespace swage::console
