// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QWidget>

#include "console/cues/ui_theme.hpp"
#include "console/models/attempts_model.hpp"

namespace swage::console {

/// One metric over the attempts: circle Practice, square Test, filled if passed; an arrow shows the better direction.
class MetricChart : public QWidget {
  Q_OBJECT
 public:
  explicit MetricChart(QWidget* parent = nullptr);
  void set_theme(const UiTheme& theme);
  void set_series(const MetricSeries& series);
  const MetricSeries& series() const { return series_; }
  QSize sizeHint() const override { return {600, 260}; }
  QSize minimumSizeHint() const override { return {260, 160}; }

  /// The step, 1, 2 or 5 times a power of ten, that divides [low, high] into about `n` parts.
  static double nice_step(double low, double high, int n);

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  QRectF area() const;
  QPointF place(int i) const;
  void paint_axes(QPainter& p) const;
  void paint_target(QPainter& p) const;
  void paint_experts(QPainter& p) const;
  void paint_who(QPainter& p) const;
  void paint_curve(QPainter& p) const;
  void paint_points(QPainter& p) const;
  void paint_key(QPainter& p) const;
  UiTheme theme_;
  MetricSeries series_;
  double low_ = 0, high_ = 1, step_ = 0.5;
};

}  // namespace swage::console
