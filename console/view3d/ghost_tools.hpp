// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Somebody else's instruments in the scene, seen through: an expert's beside a trainee's, or those of another attempt. [main]
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

class GhostTools {
 public:
  /// Nothing is drawn without a renderer.
  explicit GhostTools(Renderer* renderer) : renderer_(renderer) {}
  /// The tools of a card, not seen before show(); the parts are added last and leave first.
  void set(const snapshot::SceneCard& card, const QString& name, const UiTheme& ui);
  /// Takes them out of the renderer.
  void drop();
  /// The renderer has been cleared of them.
  void forget();
  void colour(const UiTheme& ui);
  /// Where they are; none: they are not shown. Whether the picture changed.
  bool show(std::span<const swage_pose> X_WB);
  bool shown() const { return there_ && shown_; }
  /// The name at the tips of each.
  void paint(Overlay& overlay, const Eye& eye, const QSizeF& size) const;

 private:
  Renderer* renderer_;
  bool there_ = false, shown_ = false;
  QString name_;
  std::vector<std::pair<int, uint32_t>> part_;  // of the renderer, and its body
  std::vector<std::vector<Spot>> tips_;         // of each instrument
  std::vector<swage_pose> X_WB_;
};

}  // namespace swage::console
