// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace swage::console {

class MainWindow;

/// Waits for the given moment, writes a screenshot of the window and ends the program: for documentation.
class Screenshot : public QObject {
  Q_OBJECT
 public:
  /// `at_s`: simulated time of the running attempt, or of the one under review, s; without an attempt, s since the window was shown.
  Screenshot(MainWindow* window, const QString& file, double at_s, bool of_run);

 private:
  void look();
  MainWindow* window_;
  QString file_;
  double at_s_;
  bool of_run_;
  QTimer timer_;
  QElapsedTimer since_;
  int settled_ = 0;
};

}  // namespace swage::console
