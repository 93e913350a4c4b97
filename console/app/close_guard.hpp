// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What becomes of an attempt that runs when the window is closed: who is asked, and what the next start says. [main]
#pragma once

#include <QObject>
#include <QWidget>

#include "console/app/settings.hpp"
#include "console/pages/run_page.hpp"

namespace swage::console {

class CloseGuard : public QObject {
  Q_OBJECT
 public:
  /// `window`: parent of the question. All outlive it.
  CloseGuard(RunPage* run, Settings& settings, QWidget* window);
  /// Whether the program may be left by its key: asks in every attempt.
  bool agrees_to_quit();
  /// Whether the window may be closed: a test is not lost unasked. Of practice the next start says what became of it.
  bool agrees_to_close();
  /// Ends the attempt, for good.
  void end_attempt();
  /// Says what became of the last attempt, where the window was closed during it.
  void tell_stopped();

 private:
  bool ask();

  RunPage* run_;
  Settings& settings_;
  QWidget* window_;
};

}  // namespace swage::console
