// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Frame-sequential stereo: the pictures of the eyes go to the left and right buffer of a quad-buffered driver, which shows them in turn, in
// step with shutter glasses. Qt3D draws into neither before Qt 6.7, so the painted pictures are copied there. [main]
#pragma once

#include <QImage>
#include <QOpenGLContext>
#include <QWidget>
#include <QWindow>

namespace swage::console {

class QuadWindow : public QWindow {
  Q_OBJECT
 public:
  /// Forwards mouse and key events over it to `under`.
  explicit QuadWindow(QWidget* under);
  ~QuadWindow() override;
  /// The pictures have the size of the window. Returns whether both eyes are shown: without two buffers only the left one is.
  bool show_eyes(const QImage& left, const QImage& right);
  /// Content of the back buffer, for a test; null while the window is not exposed.
  QImage read_back();

 protected:
  bool event(QEvent* event) override;

 private:
  bool begin();
  void copy(const QImage& eye, unsigned buffer);

  QWidget* under_;
  QOpenGLContext context_;
  bool two_ = false;       // buffers
  unsigned texture_ = 0, frame_ = 0;
  QSize texture_px_;
};

}  // namespace swage::console
