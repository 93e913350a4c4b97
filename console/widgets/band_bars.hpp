// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QWidget>

#include "console/cues/ui_theme.hpp"
#include "console/models/metric_bars.hpp"

namespace swage::console {

/// One bar per metric: the experts' band, and a mark at the latest value, filled if inside the band or better. Left is better.
class BandBars : public QWidget {
  Q_OBJECT
 public:
  explicit BandBars(QWidget* parent = nullptr);
  void set_theme(const UiTheme& theme);
  void set_bars(const QVector<MetricBar>& bars, const QString& empty);
  const QVector<MetricBar>& bars() const { return bars_; }
  QSize sizeHint() const override;
  static double row_px();  // height of one bar
  QSize minimumSizeHint() const override { return {220, sizeHint().height()}; }
  /// Draws into any rectangle, of the screen or of a printed page.
  void paint(QPainter& p, const QRectF& area, const UiTheme& theme) const;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  UiTheme theme_;
  QVector<MetricBar> bars_;
  QString empty_;
};

}  // namespace swage::console
