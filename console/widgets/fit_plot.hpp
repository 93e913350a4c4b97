// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "console/cues/ui_theme.hpp"

namespace swage::console {

/// A straight line through measured points, and below it the residuals: filled dots were used in the fit, crosses were not.
class FitPlot : public QWidget {
  Q_OBJECT
 public:
  struct Point {
    double x = 0, y = 0, residual = 0;
    bool used = false;
  };
  explicit FitPlot(QWidget* parent = nullptr);
  void set_titles(const QString& x, const QString& y, const QString& residual);
  void set_theme(const UiTheme& theme);
  /// `allowed`: half the band of the residuals; `slope` in y over x, 0 without a fit.
  void set_points(std::vector<Point> points, double slope, double offset, double allowed);
  QSize sizeHint() const override { return {380, 260}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void draw_points(QPainter& painter, const QRectF& area, bool residuals) const;
  QRectF upper() const;
  QRectF lower() const;

  UiTheme theme_;
  QString x_, y_, r_;
  std::vector<Point> points_;
  double slope_ = 0, offset_ = 0, allowed_ = 1;
};

}  // namespace swage::console
