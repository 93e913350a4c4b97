// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/quad_window.hpp"

#include <QCoreApplication>
#include <QEvent>
#include <QOpenGLExtraFunctions>
#include <utility>

namespace swage::console {
namespace {

// values of desktop OpenGL, which the headers of OpenGL ES lack
constexpr GLenum kStereo = 0x0C33, kBackLeft = 0x0402, kBackRight = 0x0403;

}  // namespace

QuadWindow::QuadWindow(QWidget* under) : under_(under) {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setStereo(true);
  setSurfaceType(QSurface::OpenGLSurface);
  setFormat(format);
  context_.setFormat(format);
  context_.create();
}

QuadWindow::~QuadWindow() {
  if (texture_ == 0 || !context_.makeCurrent(this)) return;
  QOpenGLExtraFunctions* gl = context_.extraFunctions();
  gl->glDeleteFramebuffers(1, &frame_);
  gl->glDeleteTextures(1, &texture_);
  context_.doneCurrent();
}

bool QuadWindow::begin() {
  if (!isExposed() || !context_.isValid() || !context_.makeCurrent(this)) return false;
  if (texture_ != 0) return true;
  QOpenGLExtraFunctions* gl = context_.extraFunctions();
  GLboolean stereo = GL_FALSE;
  gl->glGetBooleanv(kStereo, &stereo);
  two_ = stereo == GL_TRUE;
  gl->glGenTextures(1, &texture_);
  gl->glGenFramebuffers(1, &frame_);
  return true;
}

bool QuadWindow::show_eyes(const QImage& left, const QImage& right) {
  if (!begin()) return false;
  copy(left, kBackLeft);
  if (two_) copy(right, kBackRight);
  context_.swapBuffers(this);
  context_.doneCurrent();
  return two_;
}

// Copies the picture to a texture and blits it to the buffer; the first line of an image is its top, in OpenGL its bottom.
void QuadWindow::copy(const QImage& eye, unsigned buffer) {
  QOpenGLExtraFunctions* gl = context_.extraFunctions();
  const QImage rgba = eye.convertToFormat(QImage::Format_RGBA8888);
  gl->glBindTexture(GL_TEXTURE_2D, texture_);
  if (std::exchange(texture_px_, rgba.size()) != rgba.size()) {
    gl->glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, rgba.width(), rgba.height(), 0, GL_RGBA, GL_UNSIGNED_BYTE, nullptr);
    gl->glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  }
  gl->glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, rgba.width(), rgba.height(), GL_RGBA, GL_UNSIGNED_BYTE, rgba.constBits());
  gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, frame_);
  gl->glFramebufferTexture2D(GL_READ_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture_, 0);
  gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, context_.defaultFramebufferObject());
  gl->glDrawBuffers(1, &buffer);
  const QSize out = (QSizeF(size()) * devicePixelRatio()).toSize();
  gl->glBlitFramebuffer(0, 0, rgba.width(), rgba.height(), 0, out.height(), out.width(), 0, GL_COLOR_BUFFER_BIT, GL_NEAREST);
}

QImage QuadWindow::read_back() {
  if (!begin()) return {};
  QOpenGLExtraFunctions* gl = context_.extraFunctions();
  const QSize out = (QSizeF(size()) * devicePixelRatio()).toSize();
  QImage image(out, QImage::Format_RGBA8888);
  gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, context_.defaultFramebufferObject());
  gl->glReadBuffer(kBackLeft);
  gl->glReadPixels(0, 0, out.width(), out.height(), GL_RGBA, GL_UNSIGNED_BYTE, image.bits());
  context_.doneCurrent();
  return image.mirrored().convertToFormat(QImage::Format_RGB32);
}

// The window covers the widget exactly: positions are equal in both.
bool QuadWindow::event(QEvent* event) {
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
    case QEvent::MouseButtonDblClick:
    case QEvent::MouseMove:
    case QEvent::Wheel:
    case QEvent::KeyPress:
    case QEvent::KeyRelease:
      QCoreApplication::sendEvent(under_, event);
      return true;
    default:
      return QWindow::event(event);
  }
}

}  // namespace swage::console
