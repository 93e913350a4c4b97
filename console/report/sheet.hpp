// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A printed page: texts, rows and widgets below each other.
#pragma once

#include <QPainter>
#include <QStringList>
#include <QVector>
#include <QWidget>
#include <functional>

namespace swage::console {

/// Draws from the top of the page down.
class Sheet {
 public:
  Sheet(QPainter& painter, const QRectF& page) : p_(painter), page_(page), y_(page.top()) {}
  void text(const QString& words, double points, bool bold = false, const QColor& colour = Qt::black);
  void gap(double px) { y_ += px; }
  void widget(QWidget& w, double height);
  /// `shares` of the width, one per cell.
  void row(const QStringList& cells, const QVector<double>& shares, bool bold);
  double left() const { return page_.bottom() - y_; }  // px that are still free

 private:
  QPainter& p_;
  QRectF page_;
  double y_;
};

/// Writes one A4 page that prints in grey. "" or what went wrong.
QString write_sheet(const QString& file, const QString& title, const std::function<void(Sheet&)>& draw);

}  // namespace swage::console
