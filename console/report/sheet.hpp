// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Printed pages: texts, rows and widgets below each other, on as many pages as they need.
#pragma once

#include <QPagedPaintDevice>
#include <QPainter>
#include <QStringList>
#include <QVector>
#include <QWidget>
#include <functional>

namespace swage::console {

/// Draws from the top of the first page down. What does not fit any more begins the next page; a table's head is repeated there.
class Sheet {
 public:
  /// `title`: whose pages they are, in each footer. `pages`: how many there will be, 0 while that is being counted.
  Sheet(QPagedPaintDevice& device, QPainter& painter, const QRectF& page, QString title, int pages);
  void text(const QString& words, double points, bool bold = false, const QColor& colour = Qt::black);
  void gap(double px) { y_ += px; }
  void widget(QWidget& w, double height);
  /// `shares` of the width, one per cell. A bold row is a table's head.
  void row(const QStringList& cells, const QVector<double>& shares, bool bold);
  /// A new page unless that many px are still free on this one: a heading stays with what it is of.
  void keep(double px);
  /// The footer of the last page.
  void end() { footer(); }
  int page() const { return number_; }

 private:
  void turn();
  void footer();
  void draw_row(const QStringList& cells, const QVector<double>& shares, bool bold);

  QPagedPaintDevice& device_;
  QPainter& p_;
  QRectF page_;  // without the footer
  QString title_;
  int pages_, number_ = 1;
  double y_;
  QStringList head_;
  QVector<double> head_shares_;
};

/// Writes A4 pages that print in grey, each with a footer. `draw` is called twice: once to count the pages. "" or what went wrong.
QString write_sheet(const QString& file, const QString& title, const std::function<void(Sheet&)>& draw);

}  // namespace swage::console
