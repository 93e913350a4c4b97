// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/widgets/band_bars.hpp"

#include <QPainter>

namespace swage::console {
namespace {

constexpr double kBandRow_px = 40, kBandBar_px = 10, kBandHead_px = 20;

}  // namespace

BandBars::BandBars(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("band_bars"));
  setAccessibleName(tr("Latest values against the experts"));
}

void BandBars::set_theme(const UiTheme& theme) {
  theme_ = theme;
  update();
}

void BandBars::set_bars(const QVector<MetricBar>& bars, const QString& empty) {
  bars_ = bars;
  empty_ = empty;
  QStringList words;
  for (const MetricBar& b : bars) words += tr("%1 %2, experts %3").arg(b.name, b.value, b.band);
  setToolTip(tr("Green, and in brackets: the middle 80 % of the experts. Ring: the latest attempt, filled within the band or better. A bar "
                "spans the experts' band and all of this person's attempts."));
  setAccessibleDescription(words.isEmpty() ? empty : words.join(QStringLiteral("; ")));
  updateGeometry();
  update();
}

double BandBars::row_px() { return kBandRow_px; }

QSize BandBars::sizeHint() const {
  return {320, static_cast<int>(kBandHead_px + kBandRow_px * std::max(2.0, static_cast<double>(bars_.size())))};
}

void BandBars::paint(QPainter& p, const QRectF& area, const UiTheme& theme) const {
  p.setPen(theme["muted"]);
  p.drawText(QRectF(area.left(), area.top(), area.width(), kBandHead_px), Qt::AlignLeft | Qt::AlignVCenter, tr("← better"));
  p.drawText(QRectF(area.left(), area.top(), area.width(), kBandHead_px), Qt::AlignRight | Qt::AlignVCenter,
             tr("bar: all own attempts"));
  for (int i = 0; i < bars_.size(); ++i) {
    const MetricBar& b = bars_[i];
    const QRectF row(area.left(), area.top() + kBandHead_px + i * kBandRow_px, area.width(), kBandRow_px);
    const QRectF bar(row.left(), row.top() + 20, row.width(), kBandBar_px);
    const QString experts = QStringLiteral("  (%1)").arg(b.band);
    const double band_px = p.fontMetrics().horizontalAdvance(experts);
    const double value_px = p.fontMetrics().horizontalAdvance(b.value) + band_px + 8;
    p.setPen(theme["text"]);
    p.drawText(QRectF(row.left(), row.top(), row.width() - value_px, 18), Qt::AlignLeft | Qt::AlignVCenter,
               p.fontMetrics().elidedText(b.name, Qt::ElideRight, static_cast<int>(row.width() - value_px)));
    p.drawText(QRectF(row.left(), row.top(), row.width() - band_px, 18), Qt::AlignRight | Qt::AlignVCenter, b.value);
    p.setPen(theme["good"]);
    p.drawText(QRectF(row.left(), row.top(), row.width(), 18), Qt::AlignRight | Qt::AlignVCenter, experts);
    p.setPen(QPen(theme["border"], 1));
    p.setBrush(theme["raised"]);
    p.drawRoundedRect(bar, 3, 3);
    p.setBrush(theme["band"]);
    p.setPen(QPen(theme["good"], 1));
    p.drawRect(QRectF(bar.left() + b.low * bar.width(), bar.top(), std::max(2.0, (b.high - b.low) * bar.width()), kBandBar_px));
    p.setPen(QPen(theme["plot"], 2));
    p.setBrush(b.inside ? theme["plot"] : theme["card"]);
    p.drawEllipse(QPointF(bar.left() + b.latest * bar.width(), bar.center().y()), 6, 6);
  }
}

void BandBars::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  if (!bars_.isEmpty()) return paint(p, rect().adjusted(8, 0, -8, 0), theme_);
  p.setPen(theme_["muted"]);
  p.drawText(rect(), Qt::AlignCenter | Qt::TextWordWrap, empty_);
}

}  // namespace swage::console
