// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What the Lessons page asks for, done: a lesson is practised, made, edited, deleted, imported, exported. The Run page, which knows the
// plugins and whether an attempt runs, does it. [main]
#pragma once

#include <QObject>

#include "console/app/window_pages.hpp"

namespace swage::console {

class LessonRequests : public QObject {
  Q_OBJECT
 public:
  /// All outlive it.
  LessonRequests(const WindowPages* pages, const SharedModels& models);
  /// Chooses a lesson on the Run page, by its file or its id.
  void select(const QString& lesson);

 private:
  void connect_own();
  void connect_files();
  void show_again();

  const WindowPages* pages_;
  SharedModels models_;
};

}  // namespace swage::console
