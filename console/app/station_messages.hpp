// SPDX-License-Identifier: LGPL-3.0-or-later
//
// This station among those of a school: what it says of itself, and what instructors say to it, below the pages and in the trainee's
// window. [main]
#pragma once

#include <QObject>

#include "console/app/lesson_requests.hpp"
#include "console/app/trainee_place.hpp"
#include "console/app/window_pages.hpp"
#include "console/widgets/message_strip.hpp"

namespace swage::console {

class StationMessages : public QObject {
  Q_OBJECT
 public:
  /// All outlive it, and so does what is asked of the link.
  StationMessages(const WindowPages* pages, const SharedModels& models, LessonRequests* lessons, MessageStrip* strip,
                  TraineePlace* trainee);
  /// `name`: under which others see this station; "" for that of the machine.
  void start(StationsOpener opener, const QString& name);

 private:
  void show();
  void answer(const record::StationMessage& message, bool accepted);
  void show_to_trainee();

  const WindowPages* pages_;
  SharedModels models_;
  LessonRequests* lessons_;
  MessageStrip* strip_;
  TraineePlace* trainee_;
};

}  // namespace swage::console
