// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The bar below the picture of the Run page: actions on the running attempt. Their keys are the main window's. [main]
#pragma once

#include <QPushButton>
#include <QWidget>

#include "console/link/run_control.hpp"

namespace swage::console {

class ActionBar : public QWidget {
  Q_OBJECT
 public:
  /// `control`: receives the commands of the buttons; outlives the bar.
  explicit ActionBar(RunControl* control, QWidget* parent = nullptr);
  void set_running(bool running, bool paused);
  /// Label and tip of the reset button, given by a lesson; "" for the program's own.
  void set_reset(const QString& label, const QString& tip);
  /// True: each button shows its key on a second line, so that five buttons fit below a narrow picture.
  void set_narrow(bool narrow);
  bool guide_on() const { return guide_->isChecked(); }
  void set_guide(bool on) { guide_->setChecked(on); }
  void set_guide_allowed(bool allowed) { guide_->setEnabled(allowed); }
  void click_guide() { guide_->click(); }  // has no effect while the button is disabled

 Q_SIGNALS:
  /// The expert's ghost is switched on or off.
  void guide_toggled(bool on);

 private:
  void place_keys();

  QPushButton *pause_, *reset_, *mark_, *stop_, *guide_;
  bool narrow_ = false;
};

}  // namespace swage::console
