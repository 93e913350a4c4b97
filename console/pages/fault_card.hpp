// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Shown above the picture of the Run page: why a lesson cannot run, or that its record is not stored as requested, and a remedy if there
// is one. Takes no room without a message. [main]
#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

#include "base/problem.hpp"

namespace swage::console {

class FaultCard : public QWidget {
  Q_OBJECT
 public:
  explicit FaultCard(QWidget* parent = nullptr);
  void say(const QString& words);
  /// Shows why the lesson does not run. If only the record fails, an attempt without one is offered.
  void show_problems(const base::Problems& problems);
  /// Shows, during the attempt, that it is stored elsewhere than requested.
  void show_record_warning(const base::Problems& problems);
  /// Shows, during an attempt that is not stored, the reason of the last refusal.
  void say_unrecorded();
  /// Hides the text; the offer stays.
  void hide_words();
  void clear();

 Q_SIGNALS:
  /// The offer was accepted: run the lesson without storing it.
  void run_unrecorded();

 private:
  void set_offered(bool offered);
  void take_room();

  QLabel* words_;
  QPushButton* unrecorded_;
  QString refused_;  // the store's error
};

}  // namespace swage::console
