// SPDX-License-Identifier: LGPL-3.0-or-later
//
// When the instructor's window is shown. During a test it opens on a screen that the trainee does not see; where there is no such screen it
// asks first, and then the record and the result tell that the readings were open. If it comes onto the trainee's screen in another way, as
// when it is dragged there, it is closed, and they tell the same. [main]
#pragma once

#include <QAbstractItemModel>
#include <QObject>

#include "console/pages/attempt_presenter.hpp"
#include "console/pages/instructor_window.hpp"

namespace swage::console {

class InstructorControl : public QObject {
  Q_OBJECT
 public:
  struct Parts {
    RunControl* control;
    AttemptPresenter* presenter;
    ViewBar* bar;
    QAbstractItemModel* events;  // of the page's list
    QWidget* page;
  };
  /// All outlive it.
  explicit InstructorControl(const Parts& parts);
  void show(bool on);
  bool shown() const { return window_ && window_->isVisible(); }
  /// Before an attempt starts: in a test, a window that the trainee would see is closed.
  void begin();
  /// Whether the trainee's screen showed the readings of the last test.
  bool were_open() const { return were_open_; }
  /// Who does what: "Ben Okoye · Insertion · Test".
  void set_subject(const QString& words);

 private:
  bool in_test() const { return parts_.presenter->is_test() && parts_.control->running(); }
  QScreen* trainees_screen() const;
  bool go_elsewhere();
  bool ask();
  void watch();
  void tell_open();

  Parts parts_;
  InstructorWindow* window_ = nullptr;
  QString subject_;
  bool were_open_ = false, agreed_ = false;  // in this attempt
};

}  // namespace swage::console
