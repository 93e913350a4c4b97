// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The cues of all lesson plugins for a theme: with their roles, and texts from their plugins.
#pragma once

#include <QVector>
#include <vector>

#include "console/cues/cue_theme.hpp"
#include "host/plugin_info.hpp"

namespace swage::console {

/// One for each cue of each card. Its text is that of its id in the plugin's file words.<language>.json, else the id made
/// readable ("reach.there" -> "Reach there"). GUI thread.
QVector<OwnCue> own_cues(const std::vector<host::PluginInfo>& plugins);

}  // namespace swage::console
