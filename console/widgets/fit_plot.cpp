// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/widgets/fit_plot.hpp"

#include <QPainter>
#include <algorithm>
#include <cmath>

namespace swage::console {
namespace {

constexpr double kLeft_px = 46, kText_px = 18, kDot_px = 4, kShare = 0.62;  // kShare: of the height, for the fitted line
constexpr double kMargin = 1.6;  // range of the residual axis over the band: larger residuals are drawn at the edge

struct Range {
  double low = 1e300, high = -1e300;
  void add(double v) { low = std::min(low, v), high = std::max(high, v); }
  double share(double v) const { return high > low ? (v - low) / (high - low) : 0.5; }
};

}  // namespace

FitPlot::FitPlot(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("fit_plot"));
  setMinimumSize(260, 200);
}

void FitPlot::set_titles(const QString& x, const QString& y, const QString& residual) { x_ = x, y_ = y, r_ = residual; }

void FitPlot::set_theme(const UiTheme& theme) {
  theme_ = theme;
  update();
}

void FitPlot::set_points(std::vector<Point> points, double slope, double offset, double allowed) {
  points_ = std::move(points);
  slope_ = slope, offset_ = offset, allowed_ = allowed;
  const auto used = std::count_if(points_.begin(), points_.end(), [](const Point& p) { return p.used; });
  setAccessibleDescription(tr("%1 points, %2 of them in the fit").arg(points_.size()).arg(used));
  update();
}

QRectF FitPlot::upper() const { return {kLeft_px, 8, width() - kLeft_px - 10, kShare * height() - kText_px}; }
QRectF FitPlot::lower() const {
  const double top = kShare * height() + 10;
  return {kLeft_px, top, width() - kLeft_px - 10, height() - top - kText_px};
}

void FitPlot::draw_points(QPainter& p, const QRectF& area, bool residuals) const {
  Range x, y;
  for (const Point& point : points_) x.add(point.x), y.add(point.y);
  const auto at = [&](double px, double py) {
    const double v = residuals ? 0.5 + 0.5 * std::clamp(py / (kMargin * allowed_), -1.0, 1.0) : y.share(py);
    return QPointF(area.left() + x.share(px) * area.width(), area.bottom() - v * area.height());
  };
  if (!residuals && slope_ != 0) {
    p.setPen(QPen(theme_["accent"], 2));
    p.drawLine(at(x.low, slope_ * x.low + offset_), at(x.high, slope_ * x.high + offset_));
  }
  for (const Point& point : points_) {
    const QPointF c = at(point.x, residuals ? point.residual : point.y);
    const bool plain = point.used || slope_ == 0;
    p.setPen(QPen(plain ? theme_["text"] : theme_["warn"], 2));
    p.setBrush(plain ? QBrush(theme_["text"]) : Qt::NoBrush);
    if (plain) {
      p.drawEllipse(c, kDot_px - 1, kDot_px - 1);
    } else {
      p.drawLine(c + QPointF(-kDot_px, -kDot_px), c + QPointF(kDot_px, kDot_px));
      p.drawLine(c + QPointF(-kDot_px, kDot_px), c + QPointF(kDot_px, -kDot_px));
    }
  }
}

void FitPlot::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  const QRectF up = upper(), low = lower();
  p.setPen(theme_["border"]);
  p.drawRect(up);
  p.drawRect(low);
  const double band = low.height() / (2 * kMargin);
  p.fillRect(QRectF(low.left(), low.center().y() - band, low.width(), 2 * band), theme_["band"]);
  p.drawLine(QPointF(low.left(), low.center().y()), QPointF(low.right(), low.center().y()));
  p.setPen(theme_["muted"]);
  p.drawText(QRectF(up.left(), up.bottom(), up.width(), kText_px), Qt::AlignRight | Qt::AlignVCenter, x_);
  p.drawText(QRectF(0, up.top(), kLeft_px - 4, kText_px), Qt::AlignRight, y_);
  p.drawText(QRectF(low.left() + 4, low.bottom(), low.width(), kText_px), Qt::AlignLeft | Qt::AlignVCenter, r_);
  p.drawText(QRectF(0, low.center().y() - band - 9, kLeft_px - 4, 18), Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("+%1").arg(allowed_, 0, 'g', 3));
  p.drawText(QRectF(0, low.center().y() + band - 9, kLeft_px - 4, 18), Qt::AlignRight | Qt::AlignVCenter, QStringLiteral("-%1").arg(allowed_, 0, 'g', 3));
  if (points_.size() < 2) return;
  draw_points(p, up, false);
  if (slope_ != 0) draw_points(p, low, true);
}

}  // namespace swage::console
