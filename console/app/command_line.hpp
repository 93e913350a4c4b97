// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>

#include "session/session.hpp"

namespace swage::console {

/// What the command line asks for.
struct Launch {
  session::Options options;  // plugin folders, store, lesson, device, person and mode from the command line
  bool device_given = false, person_given = false, mode_given = false;
  bool start = false;
  bool draws_seed = true;      // a new seed for every attempt; false: the given seed or that of the lesson
  QString theme, cues, view;   // "": the remembered one
  float zoom = 0;              // notches of the wheel by which the view of a review is nearer
  QString station;             // name under which other stations see this one; "": name of the machine
  QString language;            // "en", "de"; "": language of the system
  QString trainee;             // layout of the trainee's view, shown from the start; "" for none
  QString page;                // Page::id: "run", "people"...
  QString review;              // attempt to open on the Review page, "latest" for the newest
  QString compare;             // id of the attempt beside it, "" for none
  QString attempt_file;        // kept attempt to open on the Review page
  QString screenshot;          // file to write the picture of the window to, then quit
  double screenshot_at_s = 0;  // simulated time, s; without an attempt, s since the window was shown
  QSize size;                  // of the window
  QStringList lesson_folders;
  QString settings_file;  // "": settings of the user
};

/// Reads the arguments. Prints the help or the error and exits where Qt's parser does so.
Launch read_command_line(const QStringList& arguments);

}  // namespace swage::console
