// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What of the Run page is remembered between launches: who sat here, at which lesson, for which hand, with which sound and help. [main]
#pragma once

#include "console/app/command_line.hpp"
#include "console/app/settings.hpp"
#include "console/app/window_pages.hpp"

namespace swage::console {

class RunMemory {
 public:
  /// All outlive it.
  RunMemory(const WindowPages* pages, LessonsModel* lessons, Settings& settings);
  /// What the launch gives goes before what is remembered.
  void restore(const Launch& launch);
  void remember() const;

 private:
  bool on(const char* key, const char* otherwise = "false") const;
  void restore_person(const Launch& launch);
  void select_lesson(const Launch& launch);

  const WindowPages* pages_;
  LessonsModel* lessons_;
  Settings& settings_;
};

}  // namespace swage::console
