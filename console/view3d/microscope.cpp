// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/view3d/microscope.hpp"

#include <QPainterPath>
#include <QRadialGradient>
#include <algorithm>
#include <cmath>

namespace swage::console {
namespace {

constexpr float kBare_mm = 250;  // viewing distance of the bare eye to which magnification refers
const float kNotch = std::pow(kMostZoom / kLeastZoom, 0.1F);

}  // namespace

float zoomed(float zoom, int notches) {
  return std::clamp(zoom * std::pow(kNotch, static_cast<float>(notches)), kLeastZoom, kMostZoom);
}

float scale_on_screen(const Microscope& scope, float distance_mm) { return scope.zoom * distance_mm / kBare_mm; }

void paint_field(QPainter& p, const QSizeF& size) {
  const QPointF middle(0.5 * size.width(), 0.5 * size.height());
  const double radius = kFieldRadius * std::min(size.width(), size.height());
  p.save();
  p.setRenderHint(QPainter::Antialiasing);
  p.setPen(Qt::NoPen);
  // the working light is even over the middle half and falls to 0.6 at the rim
  QRadialGradient light(middle, radius);
  light.setColorAt(0, QColor(0, 0, 0, 0));
  light.setColorAt(0.5, QColor(0, 0, 0, 6));
  light.setColorAt(0.85, QColor(0, 0, 0, 60));
  light.setColorAt(1, QColor(0, 0, 0, 105));
  p.setBrush(light);
  p.drawEllipse(middle, radius, radius);
  QPainterPath around;
  around.addRect(QRectF(QPointF(), size));
  around.addEllipse(middle, radius, radius);  // odd-even fill: everything outside the ellipse
  p.setBrush(QColor(4, 4, 5));
  p.drawPath(around);
  p.restore();
}

}  // namespace swage::console
