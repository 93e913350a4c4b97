// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/widgets/group_plot.hpp"

#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "console/widgets/metric_chart.hpp"

namespace swage::console {
namespace {

constexpr double kDot_px = 4, kLeft_px = 56, kTop_px = 46, kBottom_px = 28, kKey_px = 18;
constexpr int kMostNamed = 6;      // largest number of people in the legend
constexpr double kBetween = 0.25;  // gap between lessons, as a share of a lesson's width

// Colours of Okabe and Ito, each with a shape, so that people can be told apart without colour and in grey print.
const QColor kColours[] = {QColor(0, 114, 178), QColor(230, 159, 0), QColor(0, 158, 115),
                           QColor(204, 121, 167), QColor(213, 94, 0), QColor(86, 180, 233)};

QPolygonF shape(int i, const QPointF& c) {
  const double r = kDot_px;
  switch (i % 5) {
    case 1:
      return {{c.x() - r, c.y() - r}, {c.x() + r, c.y() - r}, {c.x() + r, c.y() + r}, {c.x() - r, c.y() + r}};
    case 2:
      return {{c.x(), c.y() - 1.2 * r}, {c.x() + 1.2 * r, c.y() + r}, {c.x() - 1.2 * r, c.y() + r}};
    case 3:
      return {{c.x(), c.y() - 1.4 * r}, {c.x() + 1.4 * r, c.y()}, {c.x(), c.y() + 1.4 * r}, {c.x() - 1.4 * r, c.y()}};
    case 4:
      return {{c.x(), c.y() + 1.2 * r}, {c.x() + 1.2 * r, c.y() - r}, {c.x() - 1.2 * r, c.y() - r}};
    default:
      return {};  // an empty path: a circle
  }
}

void paint_dot(QPainter& p, int person, bool filled, const QPointF& at) {
  const QColor colour = kColours[static_cast<size_t>(person) % std::size(kColours)];
  p.setPen(QPen(colour, 1.5));
  p.setBrush(filled ? QBrush(colour) : QBrush(Qt::NoBrush));
  const QPolygonF outline = shape(person, at);
  outline.isEmpty() ? p.drawEllipse(at, kDot_px, kDot_px) : p.drawPolygon(outline);
}

}  // namespace

GroupPlot::GroupPlot(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("group_plot"));
  setAccessibleName(tr("A metric of several people"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void GroupPlot::set_theme(const UiTheme& theme) {
  theme_ = theme;
  update();
}

void GroupPlot::set_figure(const GroupFigure& figure) {
  figure_ = figure;
  step_ = MetricChart::nice_step(figure.low, figure.high, 4);
  low_ = std::floor(figure.low / step_) * step_;
  high_ = std::ceil(figure.high / step_) * step_;
  setAccessibleDescription(tr("%1, %2 attempts of %3 people in %4 lessons")
                               .arg(figure.metric)
                               .arg(figure.attempts)
                               .arg(figure.people.size())
                               .arg(figure.lessons.size()));
  update();
}

double GroupPlot::y(const QRectF& a, double value) const { return a.bottom() - a.height() * (value - low_) / (high_ - low_); }

void GroupPlot::paint_axes(QPainter& p, const QRectF& a) const {
  for (double v = low_; v <= high_ + 0.5 * step_; v += step_) {
    p.setPen(QPen(theme_["grid"], 1));
    p.drawLine(QPointF(a.left(), y(a, v)), QPointF(a.right(), y(a, v)));
    p.setPen(theme_["muted"]);
    p.drawText(QRectF(0, y(a, v) - 9, a.left() - 8, 18), Qt::AlignRight | Qt::AlignVCenter,
               QLocale().toString(std::abs(v) < 1e-9 * step_ ? 0 : v, 'g', 4));
  }
  p.setPen(theme_["text"]);
  p.drawText(QRectF(8, 2, width() - 16.0, 20), Qt::AlignLeft | Qt::AlignVCenter,
             figure_.unit.isEmpty() ? figure_.metric : QStringLiteral("%1, %2").arg(figure_.metric, figure_.unit));
  const double w = a.width() / static_cast<double>(figure_.lessons.size());
  for (int i = 0; i < figure_.lessons.size(); ++i) {
    const QRectF under(a.left() + i * w, a.bottom() + 5, w, kBottom_px - 6);
    p.setPen(theme_["text"]);
    p.drawText(under, Qt::AlignHCenter | Qt::AlignTop,
               p.fontMetrics().elidedText(figure_.lessons[i], Qt::ElideRight, static_cast<int>(w - 8)));
    if (i == 0) continue;
    p.setPen(QPen(theme_["grid"], 1));
    p.drawLine(QPointF(under.left(), a.top()), QPointF(under.left(), a.bottom()));
  }
}

void GroupPlot::paint_cell(QPainter& p, const QRectF& a, int lesson, int person) const {
  const GroupCell& cell = figure_.cell[lesson][person];
  if (cell.dots.isEmpty()) return;
  const double w = a.width() / static_cast<double>(figure_.lessons.size());
  const double room = (1 - kBetween) * w / static_cast<double>(figure_.people.size());
  const double middle = a.left() + lesson * w + 0.5 * kBetween * w + (person + 0.5) * room;
  const auto n = static_cast<double>(cell.dots.size());
  for (int i = 0; i < cell.dots.size(); ++i) {
    // spread from left to right in order of time, so that equal values do not cover each other
    const double x = middle + (n > 1 ? 0.7 * room * (i / (n - 1) - 0.5) : 0);
    paint_dot(p, person, cell.dots[i].passed, {x, y(a, cell.dots[i].value)});
  }
  p.setPen(QPen(theme_["text"], 2.5));
  const double half = std::clamp(0.4 * room, 4.0, 14.0), at = y(a, cell.mean);
  p.drawLine(QPointF(middle - half, at), QPointF(middle + half, at));
}

void GroupPlot::paint_key(QPainter& p, const QRectF& a) const {
  double x = a.left();
  const double top = 22;
  const auto say = [&](const QString& words) {
    p.setPen(theme_["text"]);
    p.drawText(QRectF(x, top, width() - x, kKey_px), Qt::AlignLeft | Qt::AlignVCenter, words);
    x += p.fontMetrics().horizontalAdvance(words) + 16;
  };
  if (figure_.people.size() <= kMostNamed) {
    for (int i = 0; i < figure_.people.size(); ++i) {
      paint_dot(p, i, true, {x + kDot_px, top + 0.5 * kKey_px});
      x += 2 * kDot_px + 6;
      say(figure_.people[i]);
    }
  } else {
    say(tr("%1 people, in the order of their names").arg(figure_.people.size()));
  }
  p.setPen(theme_["muted"]);
  p.drawText(QRectF(x, top, std::max(0.0, width() - x - 12), kKey_px), Qt::AlignRight | Qt::AlignVCenter,
             tr("filled: passed; bar: mean"));
}

void GroupPlot::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  if (figure_.attempts == 0) {
    p.setPen(theme_["muted"]);
    p.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("No judged attempt of the chosen people has this metric."));
    return;
  }
  const QRectF a(kLeft_px, kTop_px, width() - kLeft_px - 12, height() - kTop_px - kBottom_px);
  paint_axes(p, a);
  for (int i = 0; i < figure_.lessons.size(); ++i)
    for (int k = 0; k < figure_.people.size(); ++k) paint_cell(p, a, i, k);
  paint_key(p, a);
}

}  // namespace swage::console
