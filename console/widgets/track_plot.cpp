// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/widgets/track_plot.hpp"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "console/view3d/overlay.hpp"

namespace swage::console {
namespace {

constexpr double kRoom = 1.25;  // factor on the shown extent
constexpr double kCosine_px = 130, kTrackLeft_px = 30;  // height of the lower plot with its labels; left margin of its axis
constexpr double kLeastReach_mm = 0.03;  // smallest half extent: a perfect entry is a point

}  // namespace

TrackPlot::TrackPlot(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("track_plot"));
  setAccessibleName(tr("Entry penetration"));
}

void TrackPlot::set_theme(const UiTheme& theme) {
  theme_ = theme;
  update();
}

void TrackPlot::set_track(const std::optional<EntryTrack>& track) {
  track_ = track;
  cursor_s_ = 0;
  setAccessibleDescription(track ? tr("wound %1 % of the needle, mean cosine %L2")
                                       .arg(100 * track->wound, 0, 'f', 0)
                                       .arg(track->mean_cosine, 0, 'f', 2)
                                 : tr("nothing"));
  update();
}

void TrackPlot::set_cursor(double time_s) {
  if (time_s == cursor_s_) return;
  cursor_s_ = time_s;
  update();
}

double TrackPlot::reach_mm() const {
  double reach = std::max(kLeastReach_mm, track_->radius_mm * std::max(1.0, track_->wound));
  for (const QPolygonF& pass : track_->passes) {
    for (const QPointF& p : pass) reach = std::max(reach, std::hypot(p.x(), p.y()));
  }
  return reach;
}

void TrackPlot::paint_circles(QPainter& p, const QPointF& middle, double scale) const {
  const double r = scale * track_->radius_mm;
  if (r <= 0) return;
  p.setPen(QPen(theme_["good"], 2));
  p.setBrush(Qt::NoBrush);
  p.drawEllipse(middle, r, r);
  if (track_->wound > 1.005) {
    p.setPen(QPen(theme_["bad"], 1.5, Qt::DashLine));
    p.drawEllipse(middle, r * track_->wound, r * track_->wound);
  }
}

// The torn area is that swept by the needle's circle: all of it pale, up to the cursor strong, and at the cursor the needle itself.
// Colours are opaque, so that an area swept twice is not darker.
void TrackPlot::paint_torn(QPainter& p, const QPointF& middle, double scale) const {
  const double r = scale * track_->radius_mm;
  if (r <= 0) return;
  const QColor done_colour = theme_["wound_flesh"];
  const auto sweep = [&](const QPolygonF& way, const QColor& colour) {
    if (way.isEmpty()) return;
    p.setPen(QPen(colour, 2 * r, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    way.size() > 1 ? p.drawPolyline(way) : p.drawPoint(way.first());
  };
  QVector<QPolygonF> done(track_->passes.size());
  for (int k = 0; k < track_->passes.size(); ++k) {
    QPolygonF all;
    for (int i = 0; i < track_->passes[k].size(); ++i) {
      const QPointF at = track_->passes[k][i];
      all << QPointF(middle.x() + scale * at.x(), middle.y() - scale * at.y());
      if (track_->time_s[k][i] <= cursor_s_) done[k] << all.last();
    }
    sweep(all, theme_["wound_lip"]);
  }
  QPointF needle;
  bool there = false;
  for (const QPolygonF& way : done) {
    sweep(way, done_colour);
    if (!way.isEmpty()) needle = way.last(), there = true;
  }
  if (!there) return;
  p.setPen(QPen(theme_["text"], 1));
  p.setBrush(theme_["steel"]);
  p.drawEllipse(needle, r, r);
  p.setBrush(Qt::NoBrush);
}

void TrackPlot::paint_track(QPainter& p, const QPointF& middle, double scale) const {
  QColor pale = theme_["plot"];
  pale.setAlpha(90);
  for (int k = 0; k < track_->passes.size(); ++k) {
    QPolygonF all, done;
    for (int i = 0; i < track_->passes[k].size(); ++i) {
      const QPointF at = track_->passes[k][i];
      all << QPointF(middle.x() + scale * at.x(), middle.y() - scale * at.y());
      if (track_->time_s[k][i] <= cursor_s_) done << all.last();
    }
    p.setPen(QPen(pale, 1.5));
    p.drawPolyline(all);
    p.setPen(QPen(theme_["plot"], 2));
    p.drawPolyline(done);
    if (!done.isEmpty()) {
      p.setBrush(theme_["plot"]);
      p.drawEllipse(done.last(), 4, 4);
      p.setBrush(Qt::NoBrush);
    }
  }
  p.setPen(QPen(theme_["text"], 1.5));
  p.drawLine(middle + QPointF(-5, 0), middle + QPointF(5, 0));
  p.drawLine(middle + QPointF(0, -5), middle + QPointF(0, 5));
}

// the thesis's axis: 0 is perpendicular to the surface, 1 along it
void TrackPlot::paint_cosine(QPainter& p, const QRectF& a) const {
  const double from = track_->cosine.first().first().x(), to = track_->cosine.last().last().x();
  const double span = std::max(to - from, 1e-3);
  const auto at = [&](const QPointF& q) {
    return QPointF(a.left() + a.width() * (q.x() - from) / span,
                   a.bottom() - a.height() * std::clamp(q.y(), 0.0, 1.0));
  };
  const double left = a.left() - kTrackLeft_px;
  for (const double v : {0.0, 0.5, 1.0}) {
    const double y = at({from, v}).y();
    p.setPen(QPen(theme_["grid"], 1));
    p.drawLine(QPointF(a.left(), y), QPointF(a.right(), y));
    p.setPen(theme_["muted"]);
    p.drawText(QRectF(left, y - 8, kTrackLeft_px - 6, 16), Qt::AlignRight | Qt::AlignVCenter, QLocale().toString(v));
  }
  p.drawText(QRectF(a.left(), a.bottom() + 2, a.width(), 16), Qt::AlignLeft, tr("%L1 s").arg(from, 0, 'f', 1));
  p.drawText(QRectF(a.left(), a.bottom() + 2, a.width(), 16), Qt::AlignRight, tr("%L1 s").arg(to, 0, 'f', 1));
  QColor pale = theme_["plot"];
  pale.setAlpha(90);
  for (const QPolygonF& stay : track_->cosine) {
    QPolygonF all, done;
    for (const QPointF& q : stay) {
      all << at(q);
      if (q.x() <= cursor_s_) done << all.last();
    }
    p.setPen(QPen(pale, 1.5));
    p.drawPolyline(all);
    p.setPen(QPen(theme_["plot"], 2));
    p.drawPolyline(done);
  }
}

// Two texts at the top of a plot, one below the other, wrapped within the width; returns their lower end.
double TrackPlot::paint_words(QPainter& p, const QRectF& room, const QString& first, const QString& second) const {
  QRectF used;
  p.setPen(theme_["text"]);
  p.drawText(room, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, first, &used);
  p.setPen(theme_["muted"]);
  p.drawText(room.adjusted(0, used.height() + 2, 0, 0), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, second, &used);
  return used.bottom();
}

void TrackPlot::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  if (!track_) {
    p.setPen(theme_["muted"]);
    p.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("The needle did not go in."));
    return;
  }
  // side by side if there is room, else one above the other
  const bool both = !track_->cosine.isEmpty(), beside = both && width() > 1.4 * height();
  const double right = beside ? 0.5 * width() : width(), bottom = height() - (both && !beside ? kCosine_px : 0);
  const QString wound = track_->radius_mm > 0 ? tr("wound %1 %, torn: red; 100 %: green").arg(100 * track_->wound, 0, 'f', 0)
                                              : tr("the cross is the first puncture");
  const double cosine_left = beside ? right + 6 : 6.0, cosine_top = beside ? 0.0 : bottom;
  double text_px = paint_words(p, {2, 0, right - 10, height() * 1.0}, tr("Entry penetration, seen onto the surface"), wound);
  double cosine_text = cosine_top;
  if (both)
    cosine_text = paint_words(p, {cosine_left, cosine_top, width() - cosine_left - 8, height() * 1.0}, tr("Cosine of the penetration angle"),
                              tr("mean %L1").arg(track_->mean_cosine, 0, 'f', 2));
  text_px = 4 + (beside ? std::max(text_px, cosine_text) : text_px);
  const double size = std::min<double>(right, bottom - text_px);
  const QPointF middle(0.5 * right, text_px + 0.5 * (bottom - text_px));
  const double scale = 0.5 * size / (kRoom * reach_mm());
  paint_torn(p, middle, scale);
  paint_circles(p, middle, scale);
  paint_track(p, middle, scale);
  const double bar = nice_scale_mm(1 / scale, 0.3 * width());
  p.setPen(QPen(theme_["text"], 2));
  p.drawLine(QPointF(8, bottom - 8), QPointF(8 + bar * scale, bottom - 8));
  p.drawText(QRectF(8, bottom - 28, 100, 18), Qt::AlignLeft | Qt::AlignVCenter, length_text(bar));
  const double left = cosine_left + kTrackLeft_px, top = beside ? text_px + 4 : cosine_text + 10;
  if (both) paint_cosine(p, {left, top, width() - left - 10.0, height() - top - 20.0});
}

}  // namespace swage::console
