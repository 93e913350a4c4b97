// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <vector>

#include "console/link/player.hpp"

namespace swage::console {

/// The real player: session::Playback.
std::unique_ptr<Player> open_session_player(const record::Recording& recording,
                                            const std::vector<std::string>& plugin_dirs,
                                            base::Problems& problems);

}  // namespace swage::console
