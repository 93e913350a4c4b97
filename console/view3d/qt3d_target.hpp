// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The frame graph: draw with several samples per pixel, resolve, hand the picture over.
#pragma once

#include <QSize>
#include <QSurface>
#include <Qt3DRender/QAbstractTexture>
#include <Qt3DRender/QBlitFramebuffer>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QFrameGraphNode>
#include <Qt3DRender/QLayer>
#include <Qt3DRender/QRenderCapture>
#include <Qt3DRender/QRenderSurfaceSelector>
#include <vector>

namespace swage::console {

/// Owned by its parent node. First what is on no layer, then the floor, then the shadows on it.
class PictureTarget {
 public:
  PictureTarget(Qt3DCore::QNode* parent, QObject* surface, int samples);
  Qt3DRender::QFrameGraphNode* root() { return surface_; }
  Qt3DRender::QCamera* camera() { return camera_; }
  Qt3DRender::QLayer* floor_layer() { return floor_layer_; }
  Qt3DRender::QLayer* shadow_layer() { return shadow_layer_; }
  Qt3DRender::QRenderCapture* capture() { return capture_; }
  void resize(const QSize& pixels);

 private:
  void add_pass(Qt3DRender::QFrameGraphNode* parent, std::initializer_list<Qt3DRender::QLayer*> layers,
                bool accept);

  Qt3DRender::QRenderSurfaceSelector* surface_;
  Qt3DRender::QCamera* camera_;
  Qt3DRender::QLayer *floor_layer_, *shadow_layer_;
  Qt3DRender::QRenderCapture* capture_;
  std::vector<Qt3DRender::QAbstractTexture*> textures_;
  std::vector<Qt3DRender::QBlitFramebuffer*> blits_;
};

}  // namespace swage::console
