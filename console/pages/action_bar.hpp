// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The bar below the picture of the Run page: what is done with the attempt that runs. The keys are the main window's. [main]
#pragma once

#include <QPushButton>
#include <QWidget>

#include "console/link/run_control.hpp"

namespace swage::console {

class ActionBar : public QWidget {
  Q_OBJECT
 public:
  /// `control`: takes what the buttons say; outlives the bar.
  explicit ActionBar(RunControl* control, QWidget* parent = nullptr);
  void set_running(bool running, bool paused);
  /// What the button that puts the work back says: a lesson's words; "" for the program's own.
  void set_reset(const QString& label, const QString& tip);
  /// Five buttons fit below a narrow picture when each has its key on a second line.
  void set_narrow(bool narrow);
  bool guide_on() const { return guide_->isChecked(); }
  void set_guide(bool on) { guide_->setChecked(on); }
  void set_guide_allowed(bool allowed) { guide_->setEnabled(allowed); }
  void click_guide() { guide_->click(); }  // nothing while it is not allowed

 Q_SIGNALS:
  /// An expert's instruments are to go along, or to leave.
  void guide_toggled(bool on);

 private:
  void place_keys();

  QPushButton *pause_, *reset_, *mark_, *stop_, *guide_;
  bool narrow_ = false;
};

}  // namespace swage::console
