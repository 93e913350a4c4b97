// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The materials of the view: solid parts in studio light, ghosts, the floor with its scale grid, and shadows on it.
#pragma once

#include <Qt3DCore/QNode>
#include <Qt3DRender/QMaterial>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderPass>

#include "console/view3d/renderer.hpp"

namespace swage::console {

/// A material's only technique: OpenGL 3.3 core, one pass.
Qt3DRender::QRenderPass* add_technique(Qt3DRender::QMaterial* material, const char* vertex, const char* fragment);
Qt3DRender::QParameter* add_parameter(Qt3DRender::QMaterial* material, const char* name);

class SolidMaterial : public Qt3DRender::QMaterial {
 public:
  explicit SolidMaterial(Qt3DCore::QNode* parent);
  void set(const Surface& surface);
  void set(const ClearSight& sight);
  void set(const MediumLook& look);

 private:
  Qt3DRender::QParameter *clear_centre_, *clear_size_, *veil_, *film_;
  Qt3DRender::QParameter *colour_, *metal_, *gloss_, *finish_;
};

/// Translucent, brighter at its outline; drawn over the objects behind it, without depth writes.
class GhostMaterial : public Qt3DRender::QMaterial {
 public:
  explicit GhostMaterial(Qt3DCore::QNode* parent);
  void set(const Surface& surface);

 private:
  Qt3DRender::QParameter* colour_;
};

class FloorMaterial : public Qt3DRender::QMaterial {
 public:
  explicit FloorMaterial(Qt3DCore::QNode* parent);
  void set(const Floor& floor);

 private:
  Qt3DRender::QParameter *colour_, *line_, *centre_, *half_, *radius_, *grid_, *fill_;
};

/// Shared by all parts; draw with kShadowLayers instances.
class ShadowMaterial : public Qt3DRender::QMaterial {
 public:
  explicit ShadowMaterial(Qt3DCore::QNode* parent);
  void set(const Floor& floor);

 private:
  Qt3DRender::QParameter *centre_, *half_, *radius_, *floor_z_, *strength_, *reach_;
};
inline constexpr int kShadowLayers = 8;

}  // namespace swage::console
