// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/widgets/trace_plot.hpp"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <tuple>

namespace swage::console {
namespace {

constexpr double kTraceLeft_px = 30, kTraceTop_px = 20, kTraceBottom_px = 16;  // room for numbers, title and times
// Longest time between two samples over which a line goes on: pictures come later than this only where the window stood still.
constexpr double kLongest_s = 2;

}  // namespace

TracePlot::TracePlot(const QString& title, const QString& unit, QWidget* parent)
    : QWidget(parent), title_(title), unit_(unit) {
  setAccessibleName(tr("%1, last 10 seconds").arg(title));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void TracePlot::set_theme(const UiTheme& theme, const char* colour_role) {
  theme_ = theme;
  colour_role_ = colour_role;
  update();
}

void TracePlot::set_range(double low, double high) {
  low_ = low;
  high_ = high;
  update();
}

void TracePlot::set_title(const QString& title) {
  title_ = title;
  setAccessibleName(title);
  update();
}

void TracePlot::set_limit(double value) {
  limit_ = value;
  has_limit_ = !std::isnan(value);
  update();
}

void TracePlot::clear() {
  samples_.clear();
  describe();
  update();
}

void TracePlot::add(double time_s, double value) {
  // a reset scene starts again
  if (!samples_.empty() && time_s < samples_.back().t) samples_.clear();
  if (!samples_.empty() && time_s == samples_.back().t) return;
  samples_.push_back({time_s, value});
  while (samples_.front().t < time_s - kWindow_s - 1) samples_.pop_front();
  if (samples_.size() % 60 == 0) describe();
  update();
}

void TracePlot::describe() {
  double most = -1;
  for (const Sample& s : samples_) most = std::max(most, std::isfinite(s.v) ? s.v : -1);
  setAccessibleDescription(most < 0 ? tr("nothing yet")
                                    : tr("highest %L1 %2").arg(most, 0, 'g', 3).arg(unit_));
}

std::vector<TracePlot::Column> TracePlot::columns(const std::deque<Sample>& samples, double from, double to,
                                                  int n) {
  std::vector<Column> out(static_cast<size_t>(std::max(n, 0)), {1, -1});
  if (n <= 0 || !(to > from)) return out;
  for (const Sample& s : samples) {
    const double place = (s.t - from) / (to - from) * n;
    if (place < 0 || place >= n) continue;
    Column& c = out[static_cast<size_t>(place)];
    if (!std::isfinite(s.v)) {
      c.silent = true;
      continue;
    }
    std::tie(c.low, c.high) = c.empty() ? std::pair{s.v, s.v} : std::pair{std::min(c.low, s.v), std::max(c.high, s.v)};
  }
  return out;
}

std::vector<std::pair<size_t, size_t>> TracePlot::lines(const std::vector<Column>& columns, size_t longest) {
  std::vector<std::pair<size_t, size_t>> out;
  bool ends = true;
  for (size_t i = 0; i < columns.size(); ++i) {
    if (columns[i].empty()) {
      ends |= columns[i].silent;
      continue;
    }
    if (!out.empty() && !ends && i - out.back().second <= longest)
      out.back().second = i;
    else
      out.emplace_back(i, i);
    ends = false;
  }
  return out;
}

void TracePlot::paintEvent(QPaintEvent*) {
  QPainter p(this);
  QFont small = font();
  small.setPointSizeF(font().pointSizeF() * 0.85);
  p.setFont(small);
  const QRectF area(kTraceLeft_px, kTraceTop_px, width() - kTraceLeft_px - 2, height() - kTraceTop_px - kTraceBottom_px);
  paint_axes(p, area);
  if (!samples_.empty()) paint_samples(p, area);
}

double TracePlot::y_of(double v, const QRectF& area) const {
  return area.bottom() - area.height() * std::clamp((v - low_) / (high_ - low_), 0.0, 1.0);
}

// title and unit, grid with its numbers, the limit
void TracePlot::paint_axes(QPainter& p, const QRectF& area) const {
  const auto line_at = [&](double v) { p.drawLine(QPointF(area.left(), y_of(v, area)), QPointF(area.right(), y_of(v, area))); };
  p.setPen(theme_["text"]);
  p.drawText(QRectF(0, 0, width(), 18), Qt::AlignLeft | Qt::AlignVCenter, title_);
  p.setPen(theme_["muted"]);
  p.drawText(QRectF(0, 0, width() - 2, 18), Qt::AlignRight | Qt::AlignVCenter, unit_);
  for (int i = 0; i <= 2; ++i) {
    const double v = low_ + (high_ - low_) * i / 2;
    p.setPen(QPen(theme_["grid"], 1));
    line_at(v);
    p.setPen(theme_["muted"]);
    p.drawText(QRectF(0, y_of(v, area) - 8, kTraceLeft_px - 5, 16), Qt::AlignRight | Qt::AlignVCenter,
               QLocale().toString(v, 'g', 3));
  }
  p.drawText(QRectF(area.left(), area.bottom() + 1, 60, 14), Qt::AlignLeft | Qt::AlignVCenter, tr("−10 s"));
  p.drawText(QRectF(area.right() - 60, area.bottom() + 1, 60, 14), Qt::AlignRight | Qt::AlignVCenter,
             tr("now"));
  if (has_limit_) {
    p.setPen(QPen(theme_["bad"], 1, Qt::DashLine));
    line_at(limit_);
  }
}

// one stroke per column from lowest to highest, joined to its neighbour
void TracePlot::paint_samples(QPainter& p, const QRectF& area) const {
  p.setRenderHint(QPainter::Antialiasing);
  const double to = std::max(samples_.back().t, kWindow_s), from = to - kWindow_s;
  const std::vector<Column> cols = columns(samples_, from, to, static_cast<int>(area.width()));
  const auto longest = static_cast<size_t>(kLongest_s / kWindow_s * static_cast<double>(cols.size()));
  for (const auto& [first, last] : lines(cols, longest)) {
    QPolygonF line;
    for (size_t i = first; i <= last; ++i) {
      if (cols[i].empty()) continue;
      const double x = area.left() + static_cast<double>(i) + 0.5;
      line << QPointF(x, y_of(cols[i].low, area));
      if (cols[i].high > cols[i].low) line << QPointF(x, y_of(cols[i].high, area));
      if (cols[i].high > high_) p.fillRect(QRectF(x - 1, area.top() - 3, 2, 3), theme_["bad"]);
    }
    p.setPen(QPen(theme_[colour_role_], 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (line.size() > 1) p.drawPolyline(line);
  }
}

}  // namespace swage::console
