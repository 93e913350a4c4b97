// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/widgets/timeline.hpp"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QLocale>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

#include "console/widgets/metric_chart.hpp"

namespace swage::console {
namespace {

constexpr double kTimelineLeft_px = 56, kRight_px = 12, kEvents_px = 30, kAxis_px = 20, kGap_px = 16;
constexpr double kFine_s = 1e-3, kStep_s = 1e-2, kCoarse_s = 1;
constexpr double kLabel_px = 14;  // height of a number on an axis
constexpr double kNear_px = 5;    // distance of the pointer within which it selects an event

}  // namespace

Timeline::Timeline(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("timeline"));
  setAccessibleName(tr("Timeline of the attempt"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void Timeline::set_theme(const UiTheme& theme) {
  theme_ = theme;
  update();
}

void Timeline::set_review(const Review* review, const record::Recording* recording) {
  review_ = review;
  recording_ = recording;
  set_other(nullptr, nullptr, 0);
  shown_.clear();
  cursor_s_ = 0;
  describe();
  update();
}

void Timeline::set_other(const Review* review, const record::Recording* recording, double later_s) {
  drawn_.clear();
  other_ = review;
  other_recording_ = recording;
  later_s_ = later_s;
  update();
}

// the other attempt's trace of the same signal: of the same instance, else of any
const Trace* Timeline::in_other(const Trace& trace) const {
  if (!other_) return nullptr;
  const judge::Name& wanted = recording_->info.script.signals[trace.index];
  const Trace* found = nullptr;
  for (const Trace& t : other_->traces) {
    const judge::Name& name = other_recording_->info.script.signals[t.index];
    if (name.id != wanted.id || name.unit != wanted.unit) continue;
    if (name.owner == wanted.owner) return &t;
    if (!found) found = &t;
  }
  return found;
}

// the trace with an axis that covers both attempts
Trace Timeline::common(const Trace& trace) const {
  const Trace* other = in_other(trace);
  return other ? on_one_scale(trace, *other) : trace;
}

void Timeline::set_shown(const QVector<int>& traces) {
  shown_ = traces;
  describe();
  update();
}

void Timeline::set_technical(bool shown) {
  technical_ = shown;
  update();
}

void Timeline::set_cursor(double time_s) {
  const double t = review_ ? std::clamp(time_s, 0.0, review_->length_s) : 0;
  if (t == cursor_s_) return;
  cursor_s_ = t;
  describe();
  update();
}

void Timeline::describe() {
  if (!review_) return setAccessibleDescription(tr("nothing is open"));
  QStringList words = {tr("%L1 s of %L2 s").arg(cursor_s_, 0, 'f', 2).arg(review_->length_s, 0, 'f', 2)};
  const auto step = static_cast<size_t>(std::max(0.0, cursor_s_ / review_->dt_s - 1));
  for (const int i : shown_) {
    const Trace& t = review_->traces[i];
    words +=
        QStringLiteral("%1 %L2 %3").arg(t.name).arg(value_at(t, *recording_, step), 0, 'g', 3).arg(t.unit);
  }
  setAccessibleDescription(words.join(QStringLiteral(", ")));
}

QRectF Timeline::area() const {
  return {kTimelineLeft_px, kEvents_px, width() - kTimelineLeft_px - kRight_px, height() - kEvents_px - kAxis_px};
}

QRectF Timeline::plot(int i) const {
  const QRectF a = area();
  const double h = a.height() / std::max<double>(1, static_cast<double>(shown_.size()));
  return {a.left(), a.top() + i * h + kGap_px, a.width(), h - kGap_px};
}

void Timeline::set_loop(double from_s, double to_s) {
  loop_from_s_ = from_s;
  loop_to_s_ = to_s;
  update();
}

double Timeline::x_of(double time_s) const {
  const QRectF a = area();
  return a.left() + a.width() * (review_ && review_->length_s > 0 ? time_s / review_->length_s : 0);
}

void Timeline::go(double time_s) {
  if (!review_) return;
  // rounded to whole steps: only recorded states are shown
  set_cursor(std::round(time_s / review_->dt_s) * review_->dt_s);
  Q_EMIT moved(cursor_s_);
}

void Timeline::go_to_moment(int direction) {
  double best = direction < 0 ? 0 : review_->length_s;
  for (const Moment& m : review_->moments) {
    if (m.technical && !technical_) continue;
    if (direction < 0 && m.time_s < cursor_s_ - 1e-9) best = std::max(best, m.time_s);
    if (direction > 0 && m.time_s > cursor_s_ + 1e-9) best = std::min(best, m.time_s);
  }
  go(best);
}

void Timeline::mousePressEvent(QMouseEvent* event) {
  setFocus();
  mouseMoveEvent(event);
}

void Timeline::mouseMoveEvent(QMouseEvent* event) {
  if (!review_ || !(event->buttons() & Qt::LeftButton)) return;
  if (const Moment* m = event->type() == QEvent::MouseButtonPress ? moment_at(event->position()) : nullptr)
    return go(m->time_s);
  const QRectF a = area();
  go((event->position().x() - a.left()) / a.width() * review_->length_s);
}

void Timeline::keyPressEvent(QKeyEvent* event) {
  if (!review_) return QWidget::keyPressEvent(event);
  const double step = event->modifiers() & Qt::ShiftModifier     ? kFine_s
                      : event->modifiers() & Qt::ControlModifier ? kCoarse_s
                                                                 : kStep_s;
  switch (event->key()) {
    case Qt::Key_Left:
      return go(cursor_s_ - step);
    case Qt::Key_Right:
      return go(cursor_s_ + step);
    case Qt::Key_Home:
      return go(0);
    case Qt::Key_End:
      return go(review_->length_s);
    case Qt::Key_Comma:
      return go_to_moment(-1);
    case Qt::Key_Period:
      return go_to_moment(+1);
    default:
      QWidget::keyPressEvent(event);
  }
}

const Moment* Timeline::moment_at(const QPointF& pos) const {
  if (!review_ || pos.y() > kEvents_px) return nullptr;
  const Moment* best = nullptr;
  double nearest = kNear_px;
  for (const Moment& m : review_->moments) {
    if (m.technical && !technical_) continue;
    const double d = std::abs(x_of(m.time_s) - pos.x());
    if (d < nearest) nearest = d, best = &m;
  }
  return best;
}

bool Timeline::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  if (const Moment* m = moment_at(help->pos())) {
    QToolTip::showText(help->globalPos(),
                       tr("%L1 s: %2").arg(m->time_s, 0, 'f', 2).arg(m->what) +
                           (m->means.isEmpty() ? QString() : QStringLiteral("\n") + m->means),
                       this);
  } else {
    QToolTip::hideText();
  }
  return true;
}

void Timeline::paint_axis(QPainter& p) const {
  const QRectF a = area();
  const double step =
      MetricChart::nice_step(0, review_->length_s, std::max(2, static_cast<int>(a.width() / 110)));
  for (double t = 0; t <= review_->length_s + 1e-9; t += step) {
    p.setPen(QPen(theme_["grid"], 1));
    p.drawLine(QPointF(x_of(t), a.top()), QPointF(x_of(t), a.bottom()));
    p.setPen(theme_["muted"]);
    p.drawText(QRectF(x_of(t) - 40, a.bottom() + 3, 80, kAxis_px - 3), Qt::AlignHCenter | Qt::AlignTop,
               tr("%1 s").arg(QLocale().toString(t, 'g', 4)));
  }
}

// a flag for each event; a diamond for a person's note. Labels only where there is room.
void Timeline::paint_moments(QPainter& p) const {
  const QFontMetricsF metrics(p.font());
  double free_from = 0;
  for (const Moment& m : review_->moments) {
    if (m.technical && !technical_) continue;
    const double x = x_of(m.time_s);
    const QColor colour = m.by_person ? theme_["plot_2"] : m.technical ? theme_["muted"] : theme_["accent"];
    QColor pale = colour;
    pale.setAlpha(90);
    p.setPen(QPen(pale, 1));
    p.drawLine(QPointF(x, kEvents_px - 4), QPointF(x, area().bottom()));
    p.setPen(Qt::NoPen);
    p.setBrush(colour);
    const double y = kEvents_px - 8;
    if (m.by_person)
      p.drawPolygon(QPolygonF({{x, y - 5}, {x + 5, y}, {x, y + 5}, {x - 5, y}}));
    else
      p.drawPolygon(QPolygonF({{x - 4, y - 4}, {x + 4, y - 4}, {x, y + 4}}));
    const double w = metrics.horizontalAdvance(m.what);
    double left = std::clamp(x - 0.5 * w, 2.0, std::max(2.0, width() - w - 2));
    if (left < free_from) continue;
    free_from = left + w + 10;
    p.setPen(theme_["text"]);
    p.drawText(QRectF(left, 0, w + 2, 16), Qt::AlignLeft | Qt::AlignVCenter, m.what);
  }
}

void Timeline::paint_other_moments(QPainter& p) const {
  if (!other_) return;
  const double y = area().bottom() - 5;
  p.setPen(QPen(theme_["text"], 1.2));
  p.setBrush(Qt::NoBrush);
  for (const Moment& m : other_->moments) {
    const double x = x_of_other(m.time_s);
    if ((m.technical && !technical_) || x < area().left() || x > area().right()) continue;
    p.drawPolygon(QPolygonF({{x - 4, y + 4}, {x + 4, y + 4}, {x, y - 4}}));
  }
}

void Timeline::paint_scale(QPainter& p, const Trace& t, const QRectF& a) const {
  const auto y = [&](double v) {
    return a.bottom() - a.height() * std::clamp((v - t.low) / (t.high - t.low), 0.0, 1.0);
  };
  // both ends first: a number that would overlap another is left out
  const bool through_zero = t.low < 0 && t.high > 0;
  double told_px[3];
  int told = 0;
  for (const double v : {t.high, t.low, through_zero ? 0 : 0.5 * (t.low + t.high)}) {
    p.setPen(QPen(theme_["grid"], 1));
    p.drawLine(QPointF(a.left(), y(v)), QPointF(a.right(), y(v)));
    p.setPen(theme_["muted"]);
    if (std::any_of(told_px, told_px + told,
                    [&](double other) { return std::abs(other - y(v)) < kLabel_px; }))
      continue;
    told_px[told++] = y(v);
    p.drawText(QRectF(0, y(v) - 8, kTimelineLeft_px - 6, 16), Qt::AlignRight | Qt::AlignVCenter,
               QLocale().toString(v, 'g', 3));
  }
}

// minimum and maximum per column, so that no peak is lost in a long attempt
const Timeline::Spans& Timeline::spans(const Trace& t, const record::Recording& recording, double shift_s, size_t columns) const {
  const auto known = std::find_if(drawn_.begin(), drawn_.end(), [&](const Drawn& d) {
    return d.recording == &recording && d.index == t.index && d.columns == columns && d.shift_s == shift_s;
  });
  if (known != drawn_.end()) return known->spans;
  std::erase_if(drawn_, [&](const Drawn& d) { return d.columns != columns; });  // the window was resized
  const size_t n = recording.step.size(), width = recording.info.script.signals.size();
  Spans out(columns, {INFINITY, -INFINITY});
  const double per_s = static_cast<double>(columns) / review_->length_s;
  for (size_t i = 0; i < n; ++i) {
    const float v = recording.signal[i * width + t.index];
    const double at = (static_cast<double>(recording.step[i]) * recording.info.dt - shift_s) * per_s;
    if (!std::isfinite(v) || at < 0 || at > static_cast<double>(columns)) continue;
    auto& s = out[std::min(columns - 1, static_cast<size_t>(at))];
    s = {std::min(s.first, v), std::max(s.second, v)};
  }
  drawn_.push_back({&recording, t.index, columns, shift_s, std::move(out)});
  return drawn_.back().spans;
}

void Timeline::paint_line(QPainter& p, const Trace& t, const record::Recording& recording, double shift_s, const QRectF& a,
                          const QPen& pen) const {
  const auto y = [&](double v) {
    return a.bottom() - a.height() * std::clamp((v - t.low) / (t.high - t.low), 0.0, 1.0);
  };
  const auto columns = static_cast<size_t>(std::max(1.0, a.width()));
  const Spans& span = spans(t, recording, shift_s, columns);
  p.setPen(pen);
  QPolygonF line;
  for (size_t c = 0; c < columns; ++c) {
    if (span[c].first > span[c].second) continue;
    const double x = a.left() + static_cast<double>(c) + 0.5;
    line << QPointF(x, y(t.factor * static_cast<double>(span[c].first)));
    if (span[c].second > span[c].first) line << QPointF(x, y(t.factor * static_cast<double>(span[c].second)));
  }
  p.drawPolyline(line);
}

void Timeline::paint_loop(QPainter& p) const {
  if (loop_to_s_ <= loop_from_s_) return;
  const QRectF loop(QPointF(x_of(loop_from_s_), 16), QPointF(x_of(loop_to_s_), area().bottom()));
  p.fillRect(loop, theme_["raised"]);
  p.setPen(QPen(theme_["accent"], 1, Qt::DashLine));
  p.drawLine(loop.topLeft(), loop.bottomLeft());
  p.drawLine(loop.topRight(), loop.bottomRight());
}

// the n-th of those that are shown: scale, line, the other attempt's line, name and value at the cursor
void Timeline::paint_trace(QPainter& p, int i) const {
  const char* const colours[] = {"plot", "plot_2"};
  const Trace t = common(review_->traces[shown_[i]]);
  const QRectF a = plot(i);
  paint_scale(p, t, a);
  if (const Trace* other = in_other(t)) {
    Trace same = *other;
    same.low = t.low, same.high = t.high;
    paint_line(p, same, *other_recording_, later_s_, a, QPen(theme_["text"], 1.2, Qt::DotLine));
  }
  paint_line(p, t, *recording_, 0, a, QPen(theme_[colours[i % 2]], 1.5, Qt::SolidLine, Qt::FlatCap, Qt::BevelJoin));
  const auto step = static_cast<size_t>(std::max(0.0, cursor_s_ / review_->dt_s - 1));
  double now = value_at(t, *recording_, step);
  if (std::abs(now) < 1e-3 * std::max(t.high, -t.low)) now = 0;  // less than is seen
  p.setPen(theme_["text"]);
  const QString name = t.unit.isEmpty() ? t.name : QStringLiteral("%1, %2").arg(t.name, t.unit);
  p.drawText(QRectF(a.left() + 2, a.top() - kGap_px, a.width(), kGap_px), Qt::AlignLeft | Qt::AlignVCenter,
             name);
  p.drawText(QRectF(a.left(), a.top() - kGap_px, a.width() - 2, kGap_px), Qt::AlignRight | Qt::AlignVCenter,
             std::isfinite(now) && has_cursor_ ? QStringLiteral("%1 %2").arg(QLocale().toString(now, 'g', 3), t.unit)
                                : QString());
}

void Timeline::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  QFont small = font();
  small.setPointSizeF(font().pointSizeF() * 0.88);
  p.setFont(small);
  if (!review_ || review_->length_s <= 0) {
    p.setPen(theme_["muted"]);
    p.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("Nothing was recorded of this attempt."));
    return;
  }
  paint_loop(p);
  paint_axis(p);
  for (int i = 0; i < shown_.size(); ++i) paint_trace(p, i);
  paint_moments(p);
  paint_other_moments(p);
  p.setPen(QPen(theme_["text"], 1.5));
  if (has_cursor_) p.drawLine(QPointF(x_of(cursor_s_), 16), QPointF(x_of(cursor_s_), area().bottom()));
  if (hasFocus()) {
    p.setPen(QPen(theme_["accent"], 1.5));
    p.setBrush(Qt::NoBrush);
    p.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 5, 5);
  }
}

}  // namespace swage::console
