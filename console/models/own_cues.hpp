// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The cues of all lesson plugins as a theme takes them: by their roles, called by the words of their plugins.
#pragma once

#include <QVector>
#include <vector>

#include "console/cues/cue_theme.hpp"
#include "host/plugin_info.hpp"

namespace swage::console {

/// One for each cue of each card. A cue is called as the plugin's file words.<language>.json calls its id, else by the id made
/// readable ("reach.there" -> "Reach there"). GUI thread.
QVector<OwnCue> own_cues(const std::vector<host::PluginInfo>& plugins);

}  // namespace swage::console
