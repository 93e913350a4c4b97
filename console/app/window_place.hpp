// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Where a window stands, how large it is and how its splitters divide it; remembered between launches. No part of the window lies
// outside its screen. [main]
#pragma once

#include <QObject>
#include <QSize>
#include <QWidget>

#include "console/app/settings.hpp"

namespace swage::console {

class WindowPlace : public QObject {
  Q_OBJECT
 public:
  /// Both outlive it.
  WindowPlace(QWidget* window, Settings& settings);
  /// `given`: from the command line, taken as it is. An invalid size: as remembered, within the screen.
  void restore(const QSize& given);
  /// Once every splitter is there.
  void restore_splitters();
  void remember() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit_screen();

  QWidget* window_;
  Settings& settings_;
  bool fits_ = false;  // into its screen, frame and all, once it is seen
};

}  // namespace swage::console
