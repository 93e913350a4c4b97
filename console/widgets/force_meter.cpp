// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/widgets/force_meter.hpp"

#include <QAccessible>
#include <QAccessibleEvent>
#include <QLocale>
#include <QPainter>
#include <algorithm>
#include <cmath>

#include "console/models/words.hpp"

namespace swage::console {

ForceMeter::ForceMeter(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("force_meter"));
  setAccessibleName(tr("Jaw force"));
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
  set_value({});
}

void ForceMeter::set_theme(const UiTheme& theme) {
  theme_ = theme;
  update();
}

void ForceMeter::set_range(double most, double low, double limit) {
  most_ = std::max(most, 1e-6);
  low_ = low;
  limit_ = limit;
  update();
}

void ForceMeter::set_value(std::optional<double> newtons, bool held) {
  const bool lost = held_ != held;
  held_ = held;
  value_ = held ? newtons : std::nullopt;
  const QString text = value_ ? quantity_text(*value_, QStringLiteral("N")) : nothing();
  if (text == shown_ && !lost) return;
  shown_ = text;
  const QString band = tr("%1, good from %2 to %3").arg(text, quantity_text(low_, QStringLiteral("N")), quantity_text(limit_, QStringLiteral("N")));
  setAccessibleDescription(judges() ? band : text);
  update();
}

bool ForceMeter::judges() const { return std::isfinite(limit_); }

QString ForceMeter::nothing() const { return held_ ? tr("no contact") : tr("no grasp"); }

void ForceMeter::paintEvent(QPaintEvent*) {
  QPainter p(this);
  p.setRenderHint(QPainter::Antialiasing);
  paint_number(p);
  const QRectF bar(0.5, 40.5, width() - 1, 14);
  paint_bar(p, bar);
  paint_scale(p, bar);
}

double ForceMeter::x_of(double newtons, const QRectF& bar) const {
  return bar.left() + bar.width() * std::clamp(newtons / most_, 0.0, 1.0);
}

// Paints the number and its meaning.
void ForceMeter::paint_number(QPainter& p) const {
  QFont big = font();
  big.setPointSizeF(font().pointSizeF() * 1.9);
  big.setBold(true);
  p.setFont(big);
  p.setPen(value_ ? theme_["text"] : theme_["disabled"]);
  p.drawText(QRectF(0, 0, width(), 34), Qt::AlignLeft | Qt::AlignVCenter,
             value_ ? shown_ : QStringLiteral("–"));
  p.setFont(font());
  const bool low = value_ && *value_ < low_, over = value_ && *value_ > limit_;
  const QString word = !value_ ? nothing() : !judges() ? QString() : over ? tr("! too much") : low ? tr("light") : tr("good");
  p.setPen(!value_ || low ? theme_["muted"] : over ? theme_["bad"] : theme_["good"]);
  p.drawText(QRectF(0, 0, width(), 34), Qt::AlignRight | Qt::AlignVCenter, word);
}

// good band, filled part, limit
void ForceMeter::paint_bar(QPainter& p, const QRectF& bar) const {
  const auto x = [&](double n) { return x_of(n, bar); };
  p.setPen(QPen(theme_["border"], 1));
  p.setBrush(theme_["raised"]);
  p.drawRoundedRect(bar, 4, 4);
  p.setPen(Qt::NoPen);
  if (judges()) p.fillRect(QRectF(x(low_), bar.top() + 1, x(limit_) - x(low_), bar.height() - 2), theme_["band"]);
  if (value_ && *value_ > 0) {
    p.setBrush(*value_ > limit_ ? theme_["bad"] : theme_["plot"]);
    p.drawRoundedRect(QRectF(bar.left(), bar.top() + 4, x(*value_) - bar.left(), bar.height() - 8), 3, 3);
  }
  p.setPen(QPen(theme_["bad"], 2));
  if (judges()) p.drawLine(QPointF(x(limit_), bar.top() - 3), QPointF(x(limit_), bar.bottom() + 3));
}

void ForceMeter::paint_scale(QPainter& p, const QRectF& bar) const {
  const auto x = [&](double n) { return x_of(n, bar); };
  QFont small = font();
  small.setPointSizeF(font().pointSizeF() * 0.85);
  p.setFont(small);
  p.setPen(theme_["muted"]);
  for (const double tick : {0.0, low_, limit_, most_}) {
    // a tick label that would overlap its neighbour is left out
    if (!judges() && (tick == low_ || tick == limit_) && tick != 0) continue;
    if (tick == low_ && x(low_) - x(0) < 24) continue;
    const QRectF where(x(tick) - 30, bar.bottom() + 4, 60, 16);
    const Qt::Alignment side = tick <= 0 ? Qt::AlignLeft : tick >= most_ ? Qt::AlignRight : Qt::AlignHCenter;
    const QRectF in = tick <= 0 ? where.translated(30, 0) : tick >= most_ ? where.translated(-30, 0) : where;
    p.drawText(in, static_cast<int>(side | Qt::AlignTop), QLocale().toString(tick, 'g', 2));
  }
}

}  // namespace swage::console
