// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Display options of the scene, and its colours.
#pragma once

#include "console/cues/cue_theme.hpp"
#include "console/cues/ui_theme.hpp"
#include "console/view3d/scene_state.hpp"

namespace swage::console {

struct Shown {
  UiTheme ui;
  CueTheme cues;
  bool cues_shown = true;  // false in a Test, and by choice
  bool forces = false;
  bool stress = false;  // colours a bending needle by its stress
};

/// The present cue of an object; "" for none, and where cues are hidden.
inline QString cue_of(const SceneState& scene, const Shown& shown, uint32_t object) {
  if (!shown.cues_shown || !scene.have_snapshot() || object >= scene.now().n_object) return {};
  const uint32_t cue = scene.now().object_cue[object];
  const auto& cues = scene.card().script.cues;
  return cue < cues.size() ? QString::fromStdString(cues[cue].id) : QString();
}

}  // namespace swage::console
