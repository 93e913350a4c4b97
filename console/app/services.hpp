// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include "console/link/guide.hpp"
#include "console/link/player.hpp"
#include "console/link/run_control.hpp"
#include "console/link/school_desk.hpp"
#include "console/link/station_link.hpp"
#include "console/link/store_link.hpp"
#include "console/models/made_with.hpp"

namespace swage::console {

/// The window's ways into the framework; tests put doubles behind them.
struct Services {
  SessionOpener open_session;
  StoreOpener open_store;  // none: nothing is kept
  RecordingReader read_recording;
  PlayerOpener open_player;
  FileOpener open_file;  // an attempt out of a file
  FileReader read_file;
  SchoolOpener open_school = {};  // none: people and courses cannot be changed
  ExpertOpener open_expert = {};  // none: nobody guides
  ExportReader read_export = {};   // none: exports do not say what was measured with
  StationsOpener open_stations = {};  // none: there is only this station
};

}  // namespace swage::console
