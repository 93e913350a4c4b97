// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Printed pages: texts, rows and widgets from top to bottom, on as many pages as they need.
#pragma once

#include <QPagedPaintDevice>
#include <QPainter>
#include <QStringList>
#include <QVector>
#include <QWidget>
#include <functional>

namespace swage::console {

/// Draws from the top of the first page downwards. A row that does not fit begins the next page, where a table's head is repeated.
class Sheet {
 public:
  /// `title`: text of each footer, usually the person's. `pages`: total number, 0 during the count.
  Sheet(QPagedPaintDevice& device, QPainter& painter, const QRectF& page, QString title, int pages);
  void text(const QString& words, double points, bool bold = false, const QColor& colour = Qt::black);
  void gap(double px) { y_ += px; }
  void widget(QWidget& w, double height);
  /// `shares`: of the width, one per cell. A bold row is a table's head. `below`: a line of its own under the cells, of their row; "" for none.
  void row(const QStringList& cells, const QVector<double>& shares, bool bold, const QString& below = {});
  /// Cells for which there was too little room.
  const QStringList& cut() const { return cut_; }
  /// Begins a new page unless `px` are free on this one: a heading stays with the content below it.
  void keep(double px);
  double room() const { return page_.bottom() - y_; }  // px, free on this page
  /// Share of the width that a table's cell with these words takes, with the space behind it.
  double share_of(const QString& words, bool bold) const;
  /// Draws the footer of the last page.
  void end() { footer(); }
  int page() const { return number_; }

 private:
  void turn();
  void footer();
  void draw_row(const QStringList& cells, const QVector<double>& shares, bool bold, const QString& below);
  void draw_cell(const QString& words, double x, double width);

  QPagedPaintDevice& device_;
  QPainter& p_;
  QRectF page_;  // without the footer
  QString title_;
  int pages_, number_ = 1;
  double y_;
  QStringList head_, cut_;
  QVector<double> head_shares_;
};

/// Writes A4 pages for printing in grey, each with a footer. `draw` is called twice: first to count the pages. Returns "" or the error.
QString write_sheet(const QString& file, const QString& title, const std::function<void(Sheet&)>& draw);

}  // namespace swage::console
