// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/widgets/metric_chart.hpp"

#include <QHelpEvent>
#include <QLocale>
#include <QPainter>
#include <QToolTip>
#include <algorithm>
#include <cmath>

namespace swage::console {
namespace {

constexpr double kMark_px = 5;
constexpr double kBestScore = 100, kHighScores = 60, kBelow = 5;  // points: above 60 the axis begins 5 below the lowest

void paint_mark(QPainter& p, const QPointF& at, bool test, bool filled, const QColor& colour,
                const QColor& back) {
  p.setPen(QPen(colour, 1.8));
  p.setBrush(filled ? colour : back);
  const QRectF r(at.x() - kMark_px, at.y() - kMark_px, 2 * kMark_px, 2 * kMark_px);
  test ? p.drawRect(r.adjusted(0.7, 0.7, -0.7, -0.7)) : p.drawEllipse(r);
}

}  // namespace

MetricChart::MetricChart(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("metric_chart"));
  setAccessibleName(tr("Metric over attempts"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

void MetricChart::set_theme(const UiTheme& theme) {
  theme_ = theme;
  update();
}

double MetricChart::nice_step(double low, double high, int n) {
  const double raw = std::max((high - low) / std::max(n, 1), 1e-12);
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  for (const double m : {1.0, 2.0, 5.0}) {
    if (m * power >= raw * (1 - 1e-9)) return m * power;
  }
  return 10 * power;
}

void MetricChart::set_series(const MetricSeries& series) {
  series_ = series;
  // the axis includes zero, as most metrics are amounts; negative values extend it
  double low = 0, high = 0;
  for (const MetricPoint& p : series_.points) {
    low = std::min(low, p.value);
    high = std::max(high, p.value);
  }
  for (const std::optional<double>& target : {series_.target.low, series_.target.high}) {
    if (target) high = std::max(high, *target), low = std::min(low, *target);
  }
  if (series_.experts) low = std::min(low, series_.experts->first), high = std::max(high, series_.experts->second);
  if (high <= low) high = low + 1;
  // scores near the top would be squeezed into a line; points on a curve need no zero
  const auto least = std::min_element(series_.points.begin(), series_.points.end(),
                                      [](const MetricPoint& a, const MetricPoint& b) { return a.value < b.value; });
  if (series_.id == QLatin1String("score") && least != series_.points.end()) {
    double from = least->value;
    if (series_.experts) from = std::min(from, series_.experts->first);
    for (const std::optional<double>& target : {series_.target.low, series_.target.high})
      if (target) from = std::min(from, *target);
    high = std::max(high, kBestScore);
    if (from > kHighScores) low = from - kBelow;
  }
  step_ = nice_step(low, high, 4);
  low_ = std::floor(low / step_) * step_;
  high_ = std::ceil(high / step_) * step_;
  const auto n = series_.points.size();
  setAccessibleDescription(n == 0 ? tr("no attempts")
                                  : tr("%1, %2 attempts, first %L3, latest %L4 %5")
                                        .arg(series_.name)
                                        .arg(n)
                                        .arg(series_.points.first().value, 0, 'g', 3)
                                        .arg(series_.points.last().value, 0, 'g', 3)
                                        .arg(series_.unit));
  update();
}

QRectF MetricChart::area() const { return {52, 34, width() - 52 - 16.0, height() - 34 - 30.0}; }

QPointF MetricChart::place(int i) const {
  const QRectF a = area();
  const auto n = static_cast<double>(std::max<qsizetype>(series_.points.size(), 8));
  const double x = a.left() + a.width() * (i + 0.5) / n;
  return {x, a.bottom() - a.height() * (series_.points[i].value - low_) / (high_ - low_)};
}

void MetricChart::paint_axes(QPainter& p) const {
  const QRectF a = area();
  for (double v = low_; v <= high_ + 0.5 * step_; v += step_) {
    const double y = a.bottom() - a.height() * (v - low_) / (high_ - low_);
    p.setPen(QPen(theme_["grid"], 1));
    p.drawLine(QPointF(a.left(), y), QPointF(a.right(), y));
    p.setPen(theme_["muted"]);
    p.drawText(QRectF(0, y - 9, a.left() - 8, 18), Qt::AlignRight | Qt::AlignVCenter,
               QLocale().toString(std::abs(v) < 1e-9 * step_ ? 0 : v, 'g', 4));
  }
  // number every attempt if there is room, and separate the days
  const auto n = static_cast<int>(series_.points.size());
  const int every = std::max(1, static_cast<int>(std::ceil(n * 26.0 / std::max(a.width(), 1.0))));
  for (int i = 0; i < n; ++i) {
    const QPointF at = place(i);
    p.setPen(theme_["muted"]);
    if (i % every == 0)
      p.drawText(QRectF(at.x() - 20, a.bottom() + 3, 40, 16), Qt::AlignCenter, QString::number(i + 1));
    if (i == 0 || series_.points[i].day == series_.points[i - 1].day) continue;
    const double x = 0.5 * (at.x() + place(i - 1).x());
    p.setPen(QPen(theme_["muted"], 1, Qt::DotLine));
    p.drawLine(QPointF(x, a.top()), QPointF(x, a.bottom()));
  }
  p.setPen(theme_["muted"]);
  p.drawText(QRectF(a.left(), height() - 15, a.width(), 15), Qt::AlignRight | Qt::AlignBottom, tr("attempt"));
}

// the lesson's target: a dashed line with its value, labelled on the side of the allowed values, or a band between two limits
void MetricChart::paint_target(QPainter& p) const {
  const MetricTarget& target = series_.target;
  if (!target.high && !target.low) return;
  const QRectF a = area();
  const auto y = [&](double v) { return a.bottom() - a.height() * (v - low_) / (high_ - low_); };
  const auto number = [](double v) { return QLocale().toString(v, 'g', 3); };
  if (target.high && target.low) {
    QColor band = theme_["band"];
    band.setAlpha(130);
    p.fillRect(QRectF(QPointF(a.left(), y(*target.high)), QPointF(a.right(), y(*target.low))), band);
  }
  p.setPen(QPen(theme_["good"], 1.5, Qt::DashLine));
  for (const std::optional<double>& v : {target.low, target.high}) {
    if (v) p.drawLine(QPointF(a.left(), y(*v)), QPointF(a.right(), y(*v)));
  }
  const QString words = target.high && target.low
                            ? tr("target %1 to %2 %3").arg(number(*target.low), number(*target.high))
                        : target.high ? tr("target at most %1 %2").arg(number(*target.high))
                                      : tr("target at least %1 %2").arg(number(*target.low));
  p.drawText(QRectF(a.left(), y(target.high ? *target.high : *target.low) - 17, a.width() - 4, 16),
             Qt::AlignRight | Qt::AlignVCenter, words.arg(series_.unit).trimmed());
}

// hatched, to be distinct from the lesson's own band without colour; labelled at the left, the target at the right
void MetricChart::paint_experts(QPainter& p) const {
  if (!series_.experts) return;
  const QRectF a = area();
  const auto y = [&](double v) { return a.bottom() - a.height() * (v - low_) / (high_ - low_); };
  const QRectF band(QPointF(a.left(), y(series_.experts->second)), QPointF(a.right(), y(series_.experts->first)));
  QColor colour = theme_["plot_2"];
  colour.setAlpha(70);
  p.fillRect(band, QBrush(colour, Qt::BDiagPattern));
  p.setPen(QPen(colour, 1));
  p.drawLine(band.topLeft(), band.topRight());
  p.drawLine(band.bottomLeft(), band.bottomRight());
}

// after the points, on the card's colour: above the band, or below it where the top line of the chart would cross the label
void MetricChart::paint_who(QPainter& p) const {
  if (!series_.experts) return;
  const QRectF a = area();
  const auto y = [&](double v) { return a.bottom() - a.height() * (v - low_) / (high_ - low_); };
  const double top = y(series_.experts->second), bottom = y(series_.experts->first);
  const QRectF box(a.left() + 4, top - 17 >= a.top() ? top - 17 : bottom + 1, p.fontMetrics().horizontalAdvance(series_.who) + 4, 16);
  QColor back = theme_["card"];
  back.setAlpha(220);
  p.fillRect(box, back);
  p.setPen(theme_["plot_2"]);
  p.drawText(box, Qt::AlignCenter, series_.who);
}

void MetricChart::paint_curve(QPainter& p) const {
  QPolygonF line;
  const QRectF a = area();
  for (int i = 0; i < series_.curve.size(); ++i)
    line << QPointF(place(i).x(), a.bottom() - a.height() * (std::clamp(series_.curve[i], low_, high_) - low_) / (high_ - low_));
  p.setPen(QPen(theme_["text"], 2, Qt::DashLine));
  p.drawPolyline(line);
}

void MetricChart::paint_points(QPainter& p) const {
  QPolygonF line;
  for (int i = 0; i < series_.points.size(); ++i) line << place(i);
  QColor pale = theme_["plot"];
  pale.setAlpha(120);
  p.setPen(QPen(pale, 1.5));
  p.drawPolyline(line);
  for (int i = 0; i < series_.points.size(); ++i) {
    const MetricPoint& point = series_.points[i];
    paint_mark(p, line[i], point.test, point.met, theme_["plot"], theme_["card"]);
  }
}

void MetricChart::paint_key(QPainter& p) const {
  const QFontMetricsF metrics(font());
  p.setPen(theme_["text"]);
  QFont bold = font();
  bold.setBold(true);
  p.setFont(bold);
  const QString name =
      series_.unit.isEmpty() ? series_.name : QStringLiteral("%1, %2").arg(series_.name, series_.unit);
  p.drawText(QRectF(0, 0, width(), 22), Qt::AlignLeft | Qt::AlignVCenter, name);
  double x = QFontMetricsF(bold).horizontalAdvance(name) + 16;
  p.setFont(font());
  p.setPen(theme_["muted"]);
  p.drawText(QRectF(x, 0, 200, 22), Qt::AlignLeft | Qt::AlignVCenter, better_words(series_.better));
  const struct {
    QString text;
    bool test, filled;
  } key[] = {{tr("not passed"), false, false}, {tr("passed"), false, true}, {tr("Test"), true, true}};
  x = width() - 12;
  for (const auto& k : key) {
    const auto shows = [&](const MetricPoint& point) { return k.test ? point.test : point.met == k.filled; };
    if (std::none_of(series_.points.begin(), series_.points.end(), shows)) continue;
    x -= metrics.horizontalAdvance(k.text);
    p.setPen(theme_["muted"]);
    p.drawText(QRectF(x, 0, 120, 22), Qt::AlignLeft | Qt::AlignVCenter, k.text);
    x -= 12;
    paint_mark(p, {x, 11}, k.test, k.filled, theme_["plot"], theme_["card"]);
    x -= 20;
  }
}

void MetricChart::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  if (series_.points.isEmpty()) {
    p.setPen(theme_["muted"]);
    p.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, tr("No finished attempt has this number yet."));
    return;
  }
  paint_axes(p);
  paint_experts(p);
  paint_target(p);
  paint_points(p);
  paint_curve(p);
  paint_who(p);
  paint_key(p);
}

bool MetricChart::event(QEvent* event) {
  if (event->type() != QEvent::ToolTip) return QWidget::event(event);
  const auto* help = static_cast<QHelpEvent*>(event);
  for (int i = 0; i < series_.points.size(); ++i) {
    const QPointF d = place(i) - QPointF(help->pos());
    if (std::hypot(d.x(), d.y()) > 3 * kMark_px) continue;
    const MetricPoint& point = series_.points[i];
    QToolTip::showText(
        help->globalPos(),
        QStringLiteral("%1 %2\n%3").arg(QLocale().toString(point.value, 'g', 3), series_.unit, point.tip),
        this);
    return true;
  }
  if (help->pos().y() < area().top() && !series_.formula.isEmpty())
    QToolTip::showText(help->globalPos(), series_.formula, this);
  else
    QToolTip::hideText();
  return true;
}

}  // namespace swage::console
