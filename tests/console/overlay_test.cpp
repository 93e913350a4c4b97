// SPDX-License-Identifier: Apache-2.0
//
// Texts over the picture that need more than one line.
#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>

#include "console/view3d/overlay.hpp"

namespace swage::console {
namespace {

/// Height of what is drawn for a clock in a picture of this width, px; nothing is drawn beside the picture.
int clock_height(int width_px, const QString& text) {
  QImage picture(width_px, 240, QImage::Format_RGB32);
  picture.fill(Qt::black);
  QPainter painter(&picture);
  const UiTheme ui = UiTheme::stock(QStringLiteral("light"));
  Overlay(painter, picture.rect(), ui).clock(text);
  painter.end();
  int rows = 0;
  for (int y = 0; y < picture.height(); ++y) {
    bool drawn = false;
    for (int x = 0; x < width_px; ++x) drawn |= qGray(picture.pixel(x, y)) > 40;
    rows += drawn;
  }
  return rows;
}

TEST(Clock, TakesAsManyLinesAsTheStepInFrontOfItNeeds) {
  const QString text = QStringLiteral("Bring its point to the mark, perpendicular to the tissue.  00:08");
  const int one = clock_height(1200, text), several = clock_height(300, text);
  EXPECT_GT(one, 10);
  EXPECT_GT(several, one + 4) << "two lines of smaller letters";
  EXPECT_LT(several, 120) << "the picture is still seen";
  EXPECT_EQ(clock_height(300, QStringLiteral("00:08")), clock_height(1200, QStringLiteral("00:08")));
}

}  // namespace
}  // namespace swage::console
