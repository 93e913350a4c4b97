// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "console/link/guide.hpp"
#include "console/link/player.hpp"

namespace swage::console {

/// The player of the program: session::Playback. Tests use doubles. `pull_lesson`: path of the lesson in which its knots are pulled.
std::unique_ptr<Player> open_session_player(const record::Recording& recording, const std::vector<std::string>& plugin_dirs,
                                            const std::string& pull_lesson, base::Problems& problems);

/// The scripted expert of a lesson: session::Rehearsal. It only steps forward.
std::unique_ptr<Player> open_session_expert(const session::Options& options, base::Problems& problems);

}  // namespace swage::console
