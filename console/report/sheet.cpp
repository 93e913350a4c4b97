// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/report/sheet.hpp"

#include <QCoreApplication>
#include <QPageSize>
#include <QPdfWriter>
#include <QSaveFile>

namespace swage::console {
namespace {

constexpr int kDpi = 96;  // widgets draw as on a screen
constexpr double kMargin_mm = 18, kLine_px = 20;

}  // namespace

void Sheet::text(const QString& words, double points, bool bold, const QColor& colour) {
  QFont font = p_.font();
  font.setPointSizeF(points);
  font.setBold(bold);
  p_.setFont(font);
  p_.setPen(colour);
  const QRectF box(page_.left(), y_, page_.width(), page_.bottom() - y_);
  QRectF used;
  p_.drawText(box, Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, words, &used);
  y_ += used.height() + 4;
}

void Sheet::widget(QWidget& w, double height) {
  w.resize(static_cast<int>(page_.width()), static_cast<int>(height));
  p_.save();
  p_.translate(page_.left(), y_);
  w.render(&p_, {}, {}, QWidget::DrawChildren);
  p_.restore();
  y_ += height + 8;
}

void Sheet::row(const QStringList& cells, const QVector<double>& shares, bool bold) {
  QFont font = p_.font();
  font.setPointSizeF(9);
  font.setBold(bold);
  p_.setFont(font);
  p_.setPen(Qt::black);
  double x = page_.left();
  for (int i = 0; i < cells.size(); ++i) {
    const double w = shares[i] * page_.width();
    p_.drawText(QRectF(x, y_, w - 6, kLine_px), Qt::AlignLeft | Qt::AlignVCenter,
                p_.fontMetrics().elidedText(cells[i], Qt::ElideRight, static_cast<int>(w - 6)));
    x += w;
  }
  y_ += kLine_px;
  p_.setPen(QPen(QColor(200, 200, 200), 0.5));
  p_.drawLine(QPointF(page_.left(), y_), QPointF(page_.right(), y_));
}

QString write_sheet(const QString& file, const QString& title, const std::function<void(Sheet&)>& draw) {
  const auto failed = [&](const QString& why) {
    return QCoreApplication::translate("report", "%1 cannot be written: %2.").arg(file, why);
  };
  QSaveFile out(file);
  if (!out.open(QIODevice::WriteOnly)) return failed(out.errorString());
  {
    QPdfWriter pdf(&out);
    pdf.setResolution(kDpi);
    pdf.setPageSize(QPageSize(QPageSize::A4));
    pdf.setPageMargins(QMarginsF(kMargin_mm, kMargin_mm, kMargin_mm, kMargin_mm), QPageLayout::Millimeter);
    pdf.setTitle(title);
    QPainter p(&pdf);
    Sheet sheet(p, QRectF(0, 0, pdf.width(), pdf.height()));
    draw(sheet);
  }
  return out.commit() ? QString() : failed(out.errorString());
}

}  // namespace swage::console
