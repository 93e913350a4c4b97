// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>

#include "session/session.hpp"

namespace swage::console {

/// What the program was asked for.
struct Launch {
  session::Options options;  // plugin folders, store, lesson, device, person, mode as given
  bool device_given = false, person_given = false, mode_given = false;
  bool start = false;
  bool draws_seed = true;      // a new one for every attempt; false: as given, or as the lesson says
  QString theme, cues, view;   // "" as remembered
  QString station;             // name under which others see this one; "" for that of the machine
  QString language;            // "en", "de"; "" that of the system
  QString trainee;             // layout of the trainee's view, shown from the start; "" for none
  QString page;                // Page::id: "run", "people"...
  QString review;              // attempt to open on the Review page, "latest" for the newest
  QString attempt_file;        // kept attempt to open on the Review page
  QString screenshot;          // file to write the picture of the window to, then quit
  double screenshot_at_s = 0;  // simulated time; without a run, seconds after the window is there
  QSize size;                  // of the window
  QStringList lesson_folders;
  QString settings_file;  // "" for the user's own
};

/// Reads the arguments. Prints help or what is wrong and ends the program where Qt's parser does so.
Launch read_command_line(const QStringList& arguments);

}  // namespace swage::console
