// SPDX-License-Identifier: LGPL-3.0-or-later
//
// What objects have drawn on them (swage.visual/1) in the renderer: dented surfaces, the wounds in them, lines, discs, tubes. [main]
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
  /// Adds the parts of the wounds after those of the scene; all surfaces are at rest.
  void add();
  void colour(const UiTheme& ui);
  /// As the last snapshot has them. `mm_per_pixel`: of the first panel, for lines.
  void place(const SceneState& scene, double mm_per_pixel);
  /// The greatest wound in the scene; there() is false when there is none.
  const WoundPlace& wound() const { return wound_; }
  /// The object that has it.
  uint32_t wounded_object() const { return wounded_object_; }

 private:
  enum Depth : size_t { kLip, kFlesh, kDepth, kInk };
  Renderer& renderer_;
  std::set<int> dented_;  // parts with a displaced surface
  WoundPlace wound_;
  uint32_t wounded_object_ = 0;
  bool drawn_ = false;
  std::array<int, 4> part_{-1, -1, -1, -1};  // by Depth
};

}  // namespace swage::console
