// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/report/sheet.hpp"

#include <QBuffer>
#include <QCoreApplication>
#include <QPageSize>
#include <QPdfWriter>
#include <QSaveFile>
#include <cmath>

namespace swage::console {
namespace {

constexpr int kDpi = 96;  // resolution at which widgets draw as on a screen
constexpr double kMargin_mm = 18, kLine_px = 20;
constexpr double kRow_pt = 9;                      // size of a table's text
constexpr double kGap_px = 6, kBetween_px = 14;  // least and usual space behind a cell
constexpr double kBelow_px = 4;  // by which a line below the cells stands nearer to them than a row of its own
constexpr double kFooter_px = 26;  // space below every page's text: a line and text of 8 points
const QColor kFooterGrey(80, 80, 80);

class SheetWords {
  Q_DECLARE_TR_FUNCTIONS(sheet)
};

/// Draws all pages; returns their number.
int draw_pages(QIODevice& out, const QString& title, int pages, const std::function<void(Sheet&)>& draw) {
  QPdfWriter pdf(&out);
  pdf.setResolution(kDpi);
  pdf.setPageSize(QPageSize(QPageSize::A4));
  pdf.setPageMargins(QMarginsF(kMargin_mm, kMargin_mm, kMargin_mm, kMargin_mm), QPageLayout::Millimeter);
  pdf.setTitle(title);
  QPainter p(&pdf);
  Sheet sheet(pdf, p, QRectF(0, 0, pdf.width(), pdf.height()), title, pages);
  draw(sheet);
  sheet.end();
  return sheet.page();
}

}  // namespace

Sheet::Sheet(QPagedPaintDevice& device, QPainter& painter, const QRectF& page, QString title, int pages)
    : device_(device), p_(painter), page_(page.adjusted(0, 0, 0, -kFooter_px)), title_(std::move(title)), pages_(pages), y_(page.top()) {}

void Sheet::footer() {
  QFont font = p_.font();
  font.setPointSizeF(8);
  font.setBold(false);
  p_.setFont(font);
  const double top = page_.bottom() + 6;
  p_.setPen(QPen(QColor(200, 200, 200), 0.5));
  p_.drawLine(QPointF(page_.left(), top), QPointF(page_.right(), top));
  p_.setPen(kFooterGrey);
  const QRectF line(page_.left(), top + 2, page_.width(), kFooter_px - 8);
  const QString left = SheetWords::tr("Swage %1. For teaching, not for certification.").arg(QCoreApplication::applicationVersion());
  const QString number = SheetWords::tr("page %1 of %2").arg(number_).arg(std::max(pages_, number_));
  const QFontMetrics metrics = p_.fontMetrics();
  const double room = line.width() - metrics.horizontalAdvance(left) - metrics.horizontalAdvance(number) - 40;
  const QString right = metrics.elidedText(title_, Qt::ElideRight, static_cast<int>(room)) + QStringLiteral("  ·  ") + number;
  p_.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, left);
  p_.drawText(line, Qt::AlignRight | Qt::AlignVCenter, right);
}

void Sheet::turn() {
  footer();
  device_.newPage();
  ++number_;
  y_ = page_.top();
}

void Sheet::keep(double px) {
  if (y_ > page_.top() && page_.bottom() - y_ < px) turn();
}

void Sheet::text(const QString& words, double points, bool bold, const QColor& colour) {
  head_.clear();
  QFont font = p_.font();
  font.setPointSizeF(points);
  font.setBold(bold);
  const auto box = [&] { return QRectF(page_.left(), y_, page_.width(), page_.height()); };
  const QFontMetricsF metrics(font, &device_);
  keep(metrics.boundingRect(box(), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, words).height());
  p_.setFont(font);
  p_.setPen(colour);
  QRectF used;
  p_.drawText(box(), Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap, words, &used);
  y_ += used.height() + 4;
}

void Sheet::widget(QWidget& w, double height) {
  head_.clear();
  keep(height);
  w.resize(static_cast<int>(page_.width()), static_cast<int>(height));
  p_.save();
  p_.translate(page_.left(), y_);
  w.render(&p_, {}, {}, QWidget::DrawChildren);
  p_.restore();
  y_ += height + 8;
}

void Sheet::draw_cell(const QString& words, double x, double width) {
  const QString text = p_.fontMetrics().elidedText(words, Qt::ElideRight, static_cast<int>(width - kGap_px));
  if (text != words) cut_ += words;
  p_.drawText(QRectF(x, y_, width - kGap_px, kLine_px), Qt::AlignLeft | Qt::AlignVCenter, text);
}

void Sheet::draw_row(const QStringList& cells, const QVector<double>& shares, bool bold, const QString& below) {
  QFont font = p_.font();
  font.setPointSizeF(kRow_pt);
  font.setBold(bold);
  p_.setFont(font);
  p_.setPen(Qt::black);
  double x = page_.left();
  for (int i = 0; i < cells.size(); ++i) {
    const double w = shares[i] * page_.width();
    draw_cell(cells[i], x, w);
    x += w;
  }
  y_ += kLine_px;
  if (!below.isEmpty()) {
    y_ -= kBelow_px;
    draw_cell(below, page_.left() + kBetween_px, page_.width() - kBetween_px);
    y_ += kLine_px;
  }
  p_.setPen(QPen(QColor(200, 200, 200), 0.5));
  p_.drawLine(QPointF(page_.left(), y_), QPointF(page_.right(), y_));
}

double Sheet::share_of(const QString& words, bool bold) const {
  QFont font = p_.font();
  font.setPointSizeF(kRow_pt);
  font.setBold(bold);
  return (std::ceil(QFontMetricsF(font, &device_).horizontalAdvance(words)) + kBetween_px) / page_.width();
}

void Sheet::row(const QStringList& cells, const QVector<double>& shares, bool bold, const QString& below) {
  const int before = number_;
  keep(bold || !below.isEmpty() ? 2 * kLine_px : kLine_px);  // a table's head needs a row below it on the page
  if (bold) head_ = cells, head_shares_ = shares;
  if (!bold && number_ != before && !head_.isEmpty()) draw_row(head_, head_shares_, true, {});
  draw_row(cells, shares, bold, below);
}

QString write_sheet(const QString& file, const QString& title, const std::function<void(Sheet&)>& draw) {
  const auto failed = [&](const QString& why) {
    return QCoreApplication::translate("report", "%1 cannot be written: %2.").arg(file, why);
  };
  QSaveFile out(file);
  if (!out.open(QIODevice::WriteOnly)) return failed(out.errorString());
  QBuffer counted;
  counted.open(QIODevice::WriteOnly);
  const int pages = draw_pages(counted, title, 0, draw);
  draw_pages(out, title, pages, draw);
  return out.commit() ? QString() : failed(out.errorString());
}

}  // namespace swage::console
