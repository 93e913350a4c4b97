// SPDX-License-Identifier: Apache-2.0
//
// A window with OpenGL, and functions that count pixels.
#pragma once

#include <QWheelEvent>
#include <functional>

#include "window_fixture.hpp"

namespace swage::test {

using console::SceneView;

class Gl : public WindowTest {
 protected:
  void open_ready() {
    open();
    if (!page()->view()->gl().ok) GTEST_SKIP() << "no OpenGL: " << page()->view()->gl().why.toStdString();
    ASSERT_TRUE(eventually([&] { return page()->view()->ready(); }));
    settle();
  }
  // waits for a gliding camera, loading meshes, and pictures that are a few frames late
  void settle() {
    view()->redraw();
    ASSERT_TRUE(eventually([&] { return view()->resting(); }));
  }
  SceneView* view() { return page()->view(); }
  /// SWAGE_PICTURES names a folder to which each picture is written, for inspection.
  QImage picture() {
    const QImage image = view()->grab().toImage().convertToFormat(QImage::Format_RGB32);
    const QString folder = qEnvironmentVariable("SWAGE_PICTURES");
    const char* const test = testing::UnitTest::GetInstance()->current_test_info()->name();
    if (!folder.isEmpty()) image.save(QStringLiteral("%1/%2_%3.png").arg(folder, QString::fromLatin1(test)).arg(pictures_++, 2, 10, QLatin1Char('0')));
    return image;
  }

 private:
  int pictures_ = 0;
};

inline int count(const QImage& image, const std::function<bool(const QColor&)>& is) {
  int n = 0;
  for (int y = 0; y < image.height(); ++y) {
    for (int x = 0; x < image.width(); ++x) n += is(image.pixelColor(x, y));
  }
  return n;
}
inline bool red(const QColor& c) { return c.red() > 120 && c.red() > 2.2 * c.green() && c.red() > 2.2 * c.blue(); }
// the soft clipping keeps highlights below white
inline bool bright(const QColor& c) { return c.lightness() > 205; }
inline double changed(const QImage& a, const QImage& b) {
  int n = 0;
  for (int y = 0; y < a.height(); ++y) {
    for (int x = 0; x < a.width(); ++x)
      n += std::abs(a.pixelColor(x, y).lightness() - b.pixelColor(x, y).lightness()) > 12;
  }
  return n / double(a.width() * a.height());
}

}  // namespace swage::test
