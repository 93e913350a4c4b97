// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/qt3d_target.hpp"

#include <Qt3DRender/QBlitFramebuffer>
#include <Qt3DRender/QCameraSelector>
#include <Qt3DRender/QClearBuffers>
#include <Qt3DRender/QLayerFilter>
#include <Qt3DRender/QNoDraw>
#include <Qt3DRender/QRenderTarget>
#include <Qt3DRender/QRenderTargetOutput>
#include <Qt3DRender/QRenderTargetSelector>
#include <Qt3DRender/QTexture>

namespace swage::console {
namespace {

using namespace Qt3DRender;

// a colour and a depth texture to draw into
QRenderTarget* make_target(Qt3DCore::QNode* parent, int samples, std::vector<QAbstractTexture*>& textures) {
  auto* target = new QRenderTarget(parent);
  const auto attach = [&](QRenderTargetOutput::AttachmentPoint point,
                          QAbstractTexture::TextureFormat format) {
    auto* output = new QRenderTargetOutput(target);
    output->setAttachmentPoint(point);
    QAbstractTexture* texture = nullptr;
    if (samples > 1) {
      texture = new QTexture2DMultisample(output);
      texture->setSamples(samples);
    } else {
      texture = new QTexture2D(output);
    }
    texture->setFormat(format);
    texture->setGenerateMipMaps(false);
    output->setTexture(texture);
    target->addOutput(output);
    textures.push_back(texture);
  };
  attach(QRenderTargetOutput::Color0, QAbstractTexture::RGBA8_UNorm);
  attach(QRenderTargetOutput::Depth, QAbstractTexture::D24);
  return target;
}

}  // namespace

PictureTarget::PictureTarget(Qt3DCore::QNode* parent, QObject* surface, int samples, int most_views) {
  surface_ = new QRenderSurfaceSelector(parent);
  surface_->setSurface(surface);
  floor_layer_ = new QLayer(parent);
  shadow_layer_ = new QLayer(parent);
  ghost_layer_ = new QLayer(parent);

  auto* draw = new QRenderTargetSelector(surface_);
  QRenderTarget* drawn = make_target(draw, samples, textures_);
  draw->setTarget(drawn);
  auto* clear = new QClearBuffers(draw);
  clear->setBuffers(QClearBuffers::ColorDepthBuffer);
  clear->setClearColor(Qt::transparent);
  auto* nothing = new QNoDraw(clear);
  Q_UNUSED(nothing)
  for (int i = 0; i < most_views; ++i) add_view(draw);

  // one sample per pixel; the interpolation enum is swapped in the OpenGL renderer: Linear gives GL_NEAREST,
  // which depth needs
  QRenderTarget* resolved = drawn;
  if (samples > 1) {
    auto* blit = new QBlitFramebuffer(surface_);
    resolved = make_target(blit, 1, textures_);
    blit->setSource(drawn);
    blit->setDestination(resolved);
    blit->setSourceAttachmentPoint(QRenderTargetOutput::Color0);
    blit->setDestinationAttachmentPoint(QRenderTargetOutput::Color0);
    blit->setInterpolationMethod(QBlitFramebuffer::Linear);
    new QNoDraw(blit);
    blits_.push_back(blit);
  }

  // a branch that captures needs a leaf
  auto* read = new QRenderTargetSelector(surface_);
  read->setTarget(resolved);
  auto* leaf = new QNoDraw(read);
  capture_ = new QRenderCapture(leaf);
}

// everything, then the floor, then the shadows on it, then what is seen through
void PictureTarget::add_view(QFrameGraphNode* parent) {
  ViewNodes view{};
  view.awake = new QSubtreeEnabler(parent);
  view.port = new QViewport(view.awake);
  view.camera = new QCamera(surface_);
  add_pass(view, {floor_layer_, shadow_layer_, ghost_layer_}, false);
  add_pass(view, {floor_layer_}, true);
  add_pass(view, {shadow_layer_}, true);
  add_pass(view, {ghost_layer_}, true);
  views_.push_back(view);
}

void PictureTarget::add_pass(const ViewNodes& view, std::initializer_list<QLayer*> layers, bool accept) {
  auto* filter = new QLayerFilter(view.port);
  for (QLayer* layer : layers) filter->addLayer(layer);
  filter->setFilterMode(accept ? QLayerFilter::AcceptAnyMatchingLayers
                               : QLayerFilter::DiscardAnyMatchingLayers);
  auto* selector = new QCameraSelector(filter);
  selector->setCamera(view.camera);
}

void PictureTarget::show(size_t view, const QRectF& part) {
  views_[view].awake->setEnabled(true);
  views_[view].port->setNormalizedRect(part);
}

void PictureTarget::resize(const QSize& pixels) {
  surface_->setExternalRenderTargetSize(pixels);
  for (QAbstractTexture* t : textures_) t->setSize(pixels.width(), pixels.height());
  const QRectF all(QPointF(0, 0), QSizeF(pixels));
  for (QBlitFramebuffer* blit : blits_) {
    blit->setSourceRect(all);
    blit->setDestinationRect(all);
  }
}

}  // namespace swage::console
