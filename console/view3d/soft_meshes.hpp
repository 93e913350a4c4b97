// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Soft things in the renderer: their surface where it is dented, and the wounds in it. [main]
#pragma once

#include <array>
#include <set>

#include "console/cues/ui_theme.hpp"
#include "console/view3d/renderer.hpp"
#include "console/view3d/scene_state.hpp"
#include "console/view3d/wound_surface.hpp"

namespace swage::console {

class SoftMeshes {
 public:
  explicit SoftMeshes(Renderer& renderer) : renderer_(renderer) {}
  /// Parts of its own, after those of the scene; nothing is dented yet.
  void add();
  void colour(const UiTheme& ui);
  /// As the last snapshot has them.
  void place(const SceneState& scene);
  /// The greatest in the scene; none when there is none.
  const WoundPlace& wound() const { return wound_; }
  /// In which object it is.
  uint32_t wounded_object() const { return wounded_object_; }

 private:
  enum Depth : size_t { kLip, kFlesh, kDepth };
  Renderer& renderer_;
  std::set<int> dented_;  // parts that are not as they were at rest
  WoundPlace wound_;
  uint32_t wounded_object_ = 0;
  bool drawn_ = false;
  std::array<int, 3> part_{-1, -1, -1};  // by Depth
};

}  // namespace swage::console
