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
#include <Qt3DRender/QTextureWrapMode>

namespace swage::console {
namespace {

using namespace Qt3DRender;

// A colour and a depth texture as render target; both are appended to `textures`.
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
      texture->setWrapMode(QTextureWrapMode(QTextureWrapMode::ClampToEdge));
      if (format == QAbstractTexture::RGBA8_UNorm) texture->setMinificationFilter(QAbstractTexture::Linear);
      if (format == QAbstractTexture::RGBA8_UNorm) texture->setMagnificationFilter(QAbstractTexture::Linear);
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

PictureTarget::PictureTarget(Qt3DCore::QNode* parent, QObject* surface, int samples, int most_views) : lens_(parent) {
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

  // One sample per pixel, of colour and depth. The OpenGL renderer exchanges the interpolation enums: Linear gives GL_NEAREST,
  // which depth needs
  resolved_ = drawn;
  if (samples > 1) {
    auto* blit = new QBlitFramebuffer(surface_);
    resolved_ = make_target(blit, 1, textures_);
    blit->setSource(drawn);
    blit->setDestination(resolved_);
    blit->setSourceAttachmentPoint(QRenderTargetOutput::Color0);
    blit->setDestinationAttachmentPoint(QRenderTargetOutput::Color0);
    blit->setInterpolationMethod(QBlitFramebuffer::Linear);
    new QNoDraw(blit);
    blits_.push_back(blit);
  }

  lens_.build(surface_, parent, textures_.end()[-2], textures_.back(), views_.front().camera);

  // a branch that captures needs a leaf node
  read_ = new QRenderTargetSelector(surface_);
  read_->setTarget(resolved_);
  auto* leaf = new QNoDraw(read_);
  capture_ = new QRenderCapture(leaf);
}

// draws solid parts, then the floor, then the shadows on it, then translucent parts
void PictureTarget::add_view(QFrameGraphNode* parent) {
  ViewNodes view{};
  view.awake = new QSubtreeEnabler(parent);
  view.port = new QViewport(view.awake);
  view.camera = new QCamera(surface_);
  std::vector<QLayer*> others = lens_.layers();
  others.insert(others.end(), {floor_layer_, shadow_layer_, ghost_layer_});
  add_pass(view, others, false);
  add_pass(view, {floor_layer_}, true);
  add_pass(view, {shadow_layer_}, true);
  add_pass(view, {ghost_layer_}, true);
  views_.push_back(view);
}

void PictureTarget::add_pass(const ViewNodes& view, const std::vector<QLayer*>& layers, bool accept) {
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

void PictureTarget::set_lens(const Lens& lens, const QMatrix4x4& projection) {
  lens_.set(lens, projection);
  QRenderTarget* wanted = lens.on ? lens_.result() : resolved_;
  if (read_->target() != wanted) read_->setTarget(wanted);
}

void PictureTarget::resize(const QSize& pixels) {
  surface_->setExternalRenderTargetSize(pixels);
  for (QAbstractTexture* t : textures_) t->setSize(pixels.width(), pixels.height());
  lens_.resize(pixels);
  const QRectF all(QPointF(0, 0), QSizeF(pixels));
  for (QBlitFramebuffer* blit : blits_) {
    blit->setSourceRect(all);
    blit->setDestinationRect(all);
  }
}

}  // namespace swage::console
