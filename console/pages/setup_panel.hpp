// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Left of the Run page: who, which lesson, which mode, which hand, START. Nothing of it has to be filled in.
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
  /// A name that is taken as it is, though nobody has practised under it: given at the command line, or agreed to.
  void know_person(const QString& name) { known_ += name; }
  /// Nobody has practised or been entered under the name that is there: it may be a slip of the keyboard.
  bool person_is_new() const;
  /// The keyboard goes to the name, all of it chosen, or to START, else to the lessons.
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
  /// What the person's own instrument is called; "" when there is none.
  void set_own_instrument(const QString& title);
  bool left_handed() const { return left_->isChecked(); }  // the lesson is mirrored
  bool mirrored() const;                                   // by that or by its file
  void set_left_handed(bool on) { left_->setChecked(on); }
  QString summary() const;  // what the lesson is about
  QString task() const;     // and what it is for
  /// What START says: an attempt runs, or waits.
  void set_running(bool running, bool paused = false);
  /// Whether the chosen lesson can be built; START is off where it cannot.
  void set_startable(bool on);
  bool startable() const { return startable_; }
  /// A demonstration has no modes.
  void set_show(bool show);
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

  QComboBox *person_, *device_;
  QCheckBox* left_ = nullptr;
  QListView* lessons_;
  QLabel* no_lessons_;
  QButtonGroup* modes_;
  QPushButton *start_ = nullptr, *variant_ = nullptr, *edit_ = nullptr, *delete_ = nullptr;
  QStringList known_;
  QString wanted_device_, own_instrument_;  // wanted: "" is what the lesson names first
  bool running_ = false, paused_ = false, startable_ = true, show_ = false;
  QLabel* explain_ = nullptr;
  void update_modes();
};

}  // namespace swage::console
