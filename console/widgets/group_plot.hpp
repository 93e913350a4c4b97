// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QWidget>

#include "console/cues/ui_theme.hpp"
#include "console/models/group_figure.hpp"

namespace swage::console {

/// Lessons side by side, each with a column per person: a dot per attempt, filled if passed, and a bar at the mean.
class GroupPlot : public QWidget {
  Q_OBJECT
 public:
  explicit GroupPlot(QWidget* parent = nullptr);
  void set_theme(const UiTheme& theme);
  void set_figure(const GroupFigure& figure);
  const GroupFigure& figure() const { return figure_; }
  QSize sizeHint() const override { return {600, 300}; }
  QSize minimumSizeHint() const override { return {260, 180}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paint_axes(QPainter& p, const QRectF& area) const;
  void paint_cell(QPainter& p, const QRectF& area, int lesson, int person) const;
  void paint_key(QPainter& p, const QRectF& area) const;
  double y(const QRectF& area, double value) const;
  GroupFigure figure_;
  UiTheme theme_;
  double low_ = 0, high_ = 1, step_ = 0.5;
};

}  // namespace swage::console
