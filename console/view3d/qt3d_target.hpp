// SPDX-License-Identifier: LGPL-3.0-or-later
//
// The frame graph: draws each view with several samples per pixel, resolves, blurs by depth of field if enabled, and captures the picture.
#pragma once

#include <QRectF>
#include <QSize>
#include <QSurface>
#include <Qt3DRender/QAbstractTexture>
#include <Qt3DRender/QBlitFramebuffer>
#include <Qt3DRender/QCamera>
#include <Qt3DRender/QFrameGraphNode>
#include <Qt3DRender/QLayer>
#include <Qt3DRender/QRenderCapture>
#include <Qt3DRender/QRenderSurfaceSelector>
#include <Qt3DRender/QRenderTarget>
#include <Qt3DRender/QRenderTargetSelector>
#include <Qt3DRender/QSubtreeEnabler>
#include <Qt3DRender/QViewport>
#include <vector>

#include "console/view3d/qt3d_lens.hpp"

namespace swage::console {

/// Owned by its parent node. Order in each view: parts on no layer, the floor, the shadows on it, ghosts.
class PictureTarget {
 public:
  PictureTarget(Qt3DCore::QNode* parent, QObject* surface, int samples, int most_views);
  Qt3DRender::QFrameGraphNode* root() { return surface_; }
  size_t most_views() const { return views_.size(); }
  Qt3DRender::QCamera* camera(size_t view) { return views_[view].camera; }
  /// Sets a view's rectangle in the picture, as shares from the top left.
  void show(size_t view, const QRectF& part);
  void hide(size_t view) { views_[view].awake->setEnabled(false); }
  Qt3DRender::QLayer* floor_layer() { return floor_layer_; }
  Qt3DRender::QLayer* shadow_layer() { return shadow_layer_; }
  Qt3DRender::QLayer* ghost_layer() { return ghost_layer_; }
  Qt3DRender::QRenderCapture* capture() { return capture_; }
  /// Sets the lens of the picture; `projection` is that of any view.
  void set_lens(const Lens& lens, const QMatrix4x4& projection);
  void resize(const QSize& pixels);

 private:
  struct ViewNodes {
    Qt3DRender::QSubtreeEnabler* awake;
    Qt3DRender::QViewport* port;
    Qt3DRender::QCamera* camera;
  };
  void add_view(Qt3DRender::QFrameGraphNode* parent);
  static void add_pass(const ViewNodes& view, const std::vector<Qt3DRender::QLayer*>& layers, bool accept);

  LensPasses lens_;
  Qt3DRender::QRenderSurfaceSelector* surface_;
  Qt3DRender::QRenderTarget* resolved_;        // the picture before the blur
  Qt3DRender::QRenderTargetSelector* read_;    // selects the target to capture
  std::vector<ViewNodes> views_;
  Qt3DRender::QLayer *floor_layer_, *shadow_layer_, *ghost_layer_;
  Qt3DRender::QRenderCapture* capture_;
  std::vector<Qt3DRender::QAbstractTexture*> textures_;
  std::vector<Qt3DRender::QBlitFramebuffer*> blits_;
};

}  // namespace swage::console
