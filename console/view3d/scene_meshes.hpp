// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The parts of the scene in the renderer: meshes, colours, poses. [main]
#pragma once

#include "console/view3d/renderer.hpp"
#include "console/view3d/shown.hpp"
#include "console/view3d/soft_meshes.hpp"

namespace swage::console {

class SceneMeshes {
 public:
  SceneMeshes(Renderer& renderer, const SceneState& scene, const Shown& shown)
      : renderer_(renderer), scene_(scene), shown_(shown), soft_(renderer) {}
  /// Rebuilds all parts of the card in their start poses. `mm_per_pixel`: of the first panel, for threads.
  void build(double mm_per_pixel);
  void colour();
  void place(double mm_per_pixel);
  /// Rebuilds the threads only: their thickness depends on the magnification.
  void place_threads(double mm_per_pixel);
  const SoftMeshes& soft() const { return soft_; }

 private:
  Surface surface_of(const ScenePart& part) const;
  void place_thread(size_t part, double mm_per_pixel);
  void lay_floor();

  Renderer& renderer_;
  const SceneState& scene_;
  const Shown& shown_;
  SoftMeshes soft_;
};

}  // namespace swage::console
