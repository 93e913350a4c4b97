// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Frame-sequential: the pictures of two eyes in the left and the right buffer of a driver that has them; it shows them in turn, in step with
// glasses that shut. Qt3D draws into neither before Qt 6.7, so the painted pictures are copied there. [main]
#pragma once

#include <QImage>
#include <QOpenGLContext>
#include <QWidget>
#include <QWindow>

namespace swage::console {

class QuadWindow : public QWindow {
  Q_OBJECT
 public:
  /// Mouse and keys over it are those of `under`.
  explicit QuadWindow(QWidget* under);
  ~QuadWindow() override;
  /// Of equal size, as large as the window. Whether both eyes were served: without two buffers the left alone is seen.
  bool show_eyes(const QImage& left, const QImage& right);
  /// What stands in the buffer that is drawn into next, for a test; null while the window is not exposed.
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
