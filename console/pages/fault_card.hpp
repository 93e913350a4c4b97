// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Over the picture of the Run page: why a lesson cannot run, or that its record is not kept as asked, and the way on where there is
// one. Takes no room while it says nothing. [main]
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
  /// Why the lesson does not run. Where only the record is missing, an attempt without one is offered.
  void show_problems(const base::Problems& problems);
  /// An attempt that is kept elsewhere than asked says so while it runs.
  void show_record_warning(const base::Problems& problems);
  /// As long as an attempt runs that is not kept, with the reason of the last refusal.
  void say_unrecorded();
  /// The words go; what is offered stays.
  void hide_words();
  void clear();

 Q_SIGNALS:
  /// The offer is taken: the lesson is to run, and nothing of it is kept.
  void run_unrecorded();

 private:
  void set_offered(bool offered);
  void take_room();

  QLabel* words_;
  QPushButton* unrecorded_;
  QString refused_;  // why the store refused
};

}  // namespace swage::console
