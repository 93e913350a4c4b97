// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Depth of field as a pass over the finished picture: a quarter-size copy of the pixels out of focus is blurred, and mixed in by each
// pixel's distance from focus. Three reads per pixel instead of the ten of a disc of nine taps at full size. [main]
#pragma once

#include <QSize>
#include <Qt3DCore/QEntity>
#include <Qt3DRender/QAbstractTexture>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QFrameGraphNode>
#include <Qt3DRender/QLayer>
#include <Qt3DRender/QParameter>
#include <Qt3DRender/QRenderTarget>
#include <Qt3DRender/QSubtreeEnabler>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "console/view3d/renderer.hpp"

namespace swage::console {

class LensPasses {
 public:
  /// Makes the layers of the passes, on which no part of the scene lies. To be created first: the scene's passes exclude these layers.
  explicit LensPasses(Qt3DCore::QNode* parent);
  const std::vector<Qt3DRender::QLayer*>& layers() const { return layers_; }
  /// Reads the finished picture and its depth; adds passes below `graph` and entities below `root`. Any camera will do.
  void build(Qt3DRender::QFrameGraphNode* graph, Qt3DCore::QNode* root, Qt3DRender::QAbstractTexture* colour, Qt3DRender::QAbstractTexture* depth,
             Qt3DRender::QCamera* camera);
  /// The target with the result.
  Qt3DRender::QRenderTarget* result() const { return result_; }
  /// `projection`: of the eyes of the picture, which all have the same near and far plane.
  void set(const Lens& lens, const QMatrix4x4& projection);
  void resize(const QSize& pixels);

 private:
  struct Pass {
    Qt3DRender::QRenderTarget* target;
    Qt3DRender::QAbstractTexture* texture;
  };
  Pass add_pass(Qt3DCore::QNode* root, Qt3DRender::QCamera* camera, size_t layer, const std::string& fragment,
                const std::vector<std::pair<const char*, Qt3DRender::QAbstractTexture*>>& reads);

  std::vector<Qt3DRender::QLayer*> layers_;
  Qt3DRender::QSubtreeEnabler* awake_ = nullptr;
  Qt3DRender::QRenderTarget* result_ = nullptr;
  std::array<Qt3DRender::QAbstractTexture*, 3> texture_{};  // small, blurred, result
  std::vector<Qt3DRender::QParameter*> lens_, texel_;       // of all passes
};

}  // namespace swage::console
