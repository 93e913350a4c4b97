// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/own_cues.hpp"

#include "console/models/said.hpp"

namespace swage::console {
namespace {

// the plugin's own words first: two plugins may use one id
QString name_of(const host::CueInfo& cue, const host::PluginInfo& plugin) {
  const QString id = QString::fromStdString(cue.id), own = said(cue.id, plugin.bundle_dir);
  return own == id ? said_id(cue.id) : own;
}

}  // namespace

QVector<OwnCue> own_cues(const std::vector<host::PluginInfo>& plugins) {
  QVector<OwnCue> out;
  for (const host::PluginInfo& plugin : plugins)
    for (const host::CueInfo& cue : plugin.cues)
      out.append({QString::fromStdString(cue.id), name_of(cue, plugin), QString::fromLatin1(host::cue_role_text(cue.role)),
                  (cue.channels & SWAGE_CHANNEL_SOUND) != 0, (cue.channels & SWAGE_CHANNEL_FORCE) != 0});
  return out;
}

}  // namespace swage::console
