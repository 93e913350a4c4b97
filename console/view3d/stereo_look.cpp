// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/stereo_look.hpp"

#include <algorithm>

namespace swage::console {

QString layout_name(StereoLayout layout) {
  switch (layout) {
    case StereoLayout::kOverUnder:
      return QStringLiteral("over");
    case StereoLayout::kAnaglyph:
      return QStringLiteral("anaglyph");
    case StereoLayout::kOneEye:
      return QStringLiteral("one");
    case StereoLayout::kSideBySide:
      break;
  }
  return QStringLiteral("side");
}

StereoLayout layout_of(const QString& name) {
  const auto* at = std::find_if(kStereoLayouts.begin(), kStereoLayouts.end(),
                                [&](StereoLayout l) { return layout_name(l) == name; });
  return at != kStereoLayouts.end() ? *at : StereoLayout::kSideBySide;
}

std::array<QRectF, 2> places(StereoLayout layout, const QSizeF& screen) {
  const double w = screen.width(), h = screen.height();
  switch (layout) {
    case StereoLayout::kSideBySide:
      return {QRectF(0, 0, 0.5 * w, h), QRectF(0.5 * w, 0, 0.5 * w, h)};
    case StereoLayout::kOverUnder:
      return {QRectF(0, 0, w, 0.5 * h), QRectF(0, 0.5 * h, w, 0.5 * h)};
    case StereoLayout::kAnaglyph:
      return {QRectF(0, 0, w, h), QRectF(0, 0, w, h)};
    case StereoLayout::kOneEye:
      break;
  }
  return {QRectF(0, 0, w, h), QRectF()};
}

QImage red_cyan(const QImage& left, const QImage& right) {
  constexpr QRgb kRed = 0x00ff0000;
  QImage out = right.convertToFormat(QImage::Format_RGB32);
  const QImage red = left.convertToFormat(QImage::Format_RGB32);
  for (int y = 0; y < std::min(out.height(), red.height()); ++y) {
    auto* to = reinterpret_cast<QRgb*>(out.scanLine(y));
    const auto* from = reinterpret_cast<const QRgb*>(red.constScanLine(y));
    for (int x = 0; x < std::min(out.width(), red.width()); ++x) to[x] = (to[x] & ~kRed) | (from[x] & kRed);
  }
  return out;
}

}  // namespace swage::console
