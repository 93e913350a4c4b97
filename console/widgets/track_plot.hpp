// SPDX-License-Identifier: LGPL-3.0-or-later
#pragma once

#include <QWidget>

#include "console/cues/ui_theme.hpp"
#include "console/models/insertion.hpp"

namespace swage::console {

/// Entry penetration: the torn region and the track of the needle in the plane of the surface, the needle's circle at the first puncture,
/// and the circle that the wound's edge reached; below it the cosine of the penetration angle over time. Up to the cursor strong,
/// after it pale.
class TrackPlot : public QWidget {
  Q_OBJECT
 public:
  explicit TrackPlot(QWidget* parent = nullptr);
  void set_theme(const UiTheme& theme);
  void set_track(const std::optional<EntryTrack>& track);
  void set_cursor(double time_s);
  QSize sizeHint() const override { return {260, 260}; }
  QSize minimumSizeHint() const override { return {160, 160}; }

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  void paint_torn(QPainter& p, const QPointF& middle, double px_per_mm) const;
  void paint_circles(QPainter& p, const QPointF& middle, double px_per_mm) const;
  void paint_track(QPainter& p, const QPointF& middle, double px_per_mm) const;
  double paint_words(QPainter& p, const QRectF& room, const QString& first, const QString& second) const;
  void paint_cosine(QPainter& p, const QRectF& area) const;
  double reach_mm() const;
  std::optional<EntryTrack> track_;
  UiTheme theme_;
  double cursor_s_ = 0;
};

}  // namespace swage::console
