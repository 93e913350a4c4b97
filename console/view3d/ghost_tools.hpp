// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Translucent instruments of another attempt or of an expert, drawn in the trainee's scene. [main]
#pragma once

#include <QString>
#include <span>
#include <utility>
#include <vector>

#include "console/cues/ui_theme.hpp"
#include "console/view3d/overlay.hpp"
#include "console/view3d/renderer.hpp"
#include "console/view3d/scene_parts.hpp"

namespace swage::console {

/// Tips of an instrument and the words beside them.
struct GhostTips {
  QString words;
  std::vector<Spot> tips;
};

/// Instruments of a card, the trainee's first. `name`: whose they are; of several instruments each has its own name after it: "Expert: Forceps".
std::vector<GhostTips> ghost_tips(const snapshot::SceneCard& card, const SceneParts& parts, const QString& name);

class GhostTools {
 public:
  /// Nothing is drawn without a renderer.
  explicit GhostTools(Renderer* renderer) : renderer_(renderer) {}
  /// Adds the tools of a card, hidden until show(); these parts are the renderer's last, so that they can be removed first.
  void set(const snapshot::SceneCard& card, const QString& name, const UiTheme& ui);
  /// Removes the parts from the renderer.
  void drop();
  /// To be called when the renderer was cleared.
  void forget();
  void colour(const UiTheme& ui);
  /// Sets the poses; empty: hides the tools. Returns whether the picture changed.
  bool show(std::span<const swage_pose> X_WB);
  bool shown() const { return there_ && shown_; }
  /// Draws the words at the tips of each instrument.
  void paint(Overlay& overlay, const Eye& eye, const QSizeF& size) const;

 private:
  Renderer* renderer_;
  bool there_ = false, shown_ = false;
  std::vector<std::pair<int, uint32_t>> part_;  // index of the part in the renderer, and its body
  std::vector<GhostTips> tips_;
  std::vector<swage_pose> X_WB_;
};

}  // namespace swage::console
