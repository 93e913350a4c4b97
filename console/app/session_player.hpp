// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <vector>

#include "console/link/guide.hpp"
#include "console/link/player.hpp"

namespace swage::console {

/// The real player: session::Playback.
std::unique_ptr<Player> open_session_player(const record::Recording& recording,
                                            const std::vector<std::string>& plugin_dirs,
                                            base::Problems& problems);

/// The scripted expert of a lesson: session::Rehearsal. It goes forward only.
std::unique_ptr<Player> open_session_expert(const session::Options& options, base::Problems& problems);

}  // namespace swage::console
