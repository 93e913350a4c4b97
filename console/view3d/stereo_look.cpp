// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/stereo_look.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace swage::console {
namespace {

constexpr std::pair<StereoLayout, const char*> kNames[] = {
    {StereoLayout::kSideBySide, "side"},      {StereoLayout::kOverUnder, "over"},      {StereoLayout::kLines, "lines"},
    {StereoLayout::kChecker, "checker"},      {StereoLayout::kAnaglyph, "anaglyph"},   {StereoLayout::kAnaglyphGrey, "grey"},
    {StereoLayout::kAnaglyphLeast, "least"}, {StereoLayout::kOneEye, "one"},          {StereoLayout::kLeftEye, "left"},
    {StereoLayout::kRightEye, "right"},       {StereoLayout::kShutter, "shutter"}};

// Red-cyan by least squares, of sRGB values: rows red, green, blue of the picture, columns those of an eye's
constexpr float kLeastLeft[3][3] = {{0.437F, 0.449F, 0.164F}, {-0.062F, -0.062F, -0.024F}, {-0.048F, -0.050F, -0.017F}};
constexpr float kLeastRight[3][3] = {{-0.011F, -0.032F, -0.007F}, {0.377F, 0.761F, 0.009F}, {-0.026F, -0.093F, 1.234F}};

QRgb least(QRgb l, QRgb r) {
  const float a[3] = {static_cast<float>(qRed(l)), static_cast<float>(qGreen(l)), static_cast<float>(qBlue(l))};
  const float b[3] = {static_cast<float>(qRed(r)), static_cast<float>(qGreen(r)), static_cast<float>(qBlue(r))};
  int out[3];
  for (int i = 0; i < 3; ++i) {
    float sum = 0;
    for (int k = 0; k < 3; ++k) sum += kLeastLeft[i][k] * a[k] + kLeastRight[i][k] * b[k];
    out[i] = std::clamp(static_cast<int>(std::lround(sum)), 0, 255);
  }
  return qRgb(out[0], out[1], out[2]);
}

QRgb both(StereoLayout layout, QRgb left, QRgb right, int x, int y) {
  switch (layout) {
    case StereoLayout::kLines:
      return (y & 1) == 0 ? left : right;
    case StereoLayout::kChecker:
      return ((x + y) & 1) == 0 ? left : right;
    case StereoLayout::kAnaglyphGrey:
      return qRgb(qGray(left), qGray(right), qGray(right));
    case StereoLayout::kAnaglyphLeast:
      return least(left, right);
    case StereoLayout::kShutter:
      return left;
    default:
      return qRgb(qRed(left), qGreen(right), qBlue(right));
  }
}

}  // namespace

QString layout_name(StereoLayout layout) {
  for (const auto& [one, name] : kNames)
    if (one == layout) return QString::fromLatin1(name);
  return QStringLiteral("side");
}

StereoLayout layout_of(const QString& name) {
  const auto* at = std::find_if(kStereoLayouts.begin(), kStereoLayouts.end(),
                                [&](StereoLayout l) { return layout_name(l) == name; });
  return at != kStereoLayouts.end() ? *at : StereoLayout::kSideBySide;
}

QString mirror_name(Mirror mirror) {
  if (mirror == Mirror::kNone) return {};
  return mirror == Mirror::kLeftRight ? QStringLiteral("left_right") : QStringLiteral("up_down");
}

Mirror mirror_of(const QString& name) {
  for (const Mirror mirror : {Mirror::kLeftRight, Mirror::kUpDown})
    if (mirror_name(mirror) == name) return mirror;
  return Mirror::kNone;
}

bool flat(StereoLayout layout) {
  return layout == StereoLayout::kOneEye || layout == StereoLayout::kLeftEye || layout == StereoLayout::kRightEye;
}

bool overlaid(StereoLayout layout) {
  return !flat(layout) && layout != StereoLayout::kSideBySide && layout != StereoLayout::kOverUnder;
}

std::array<QRectF, 2> places(StereoLayout layout, const QSizeF& screen) {
  const double w = screen.width(), h = screen.height();
  const QRectF all(0, 0, w, h);
  if (layout == StereoLayout::kSideBySide) return {QRectF(0, 0, 0.5 * w, h), QRectF(0.5 * w, 0, 0.5 * w, h)};
  if (layout == StereoLayout::kOverUnder) return {QRectF(0, 0, w, 0.5 * h), QRectF(0, 0.5 * h, w, 0.5 * h)};
  if (layout == StereoLayout::kRightEye) return {QRectF(), all};
  return {all, overlaid(layout) ? all : QRectF()};
}

QImage overlay_eyes(StereoLayout layout, const QImage& left, const QImage& right, const QPoint& origin) {
  QImage out = right.convertToFormat(QImage::Format_RGB32);
  const QImage other = left.convertToFormat(QImage::Format_RGB32);
  for (int y = 0; y < std::min(out.height(), other.height()); ++y) {
    auto* to = reinterpret_cast<QRgb*>(out.scanLine(y));
    const auto* from = reinterpret_cast<const QRgb*>(other.constScanLine(y));
    for (int x = 0; x < std::min(out.width(), other.width()); ++x)
      to[x] = both(layout, from[x], to[x], x + origin.x(), y + origin.y());
  }
  return out;
}

}  // namespace swage::console
