// SPDX-License-Identifier: Apache-2.0
//
// A4 paper that is printed to memory.
#pragma once

#include <QBuffer>
#include <QPainter>
#include <QPdfWriter>

#include "console/report/sheet.hpp"

namespace swage::test {

/// Draws on a sheet, and returns what did not fit its place: "" where every word is whole. `pages`, if given, gets their number.
template <class Draw>
std::string cut_on_paper(const QString& title, const Draw& draw, int* pages = nullptr) {
  QBuffer out;
  if (!out.open(QIODevice::WriteOnly)) return "no paper";
  QPdfWriter pdf(&out);
  pdf.setResolution(96);
  pdf.setPageSize(QPageSize(QPageSize::A4));
  pdf.setPageMargins(QMarginsF(18, 18, 18, 18), QPageLayout::Millimeter);
  QPainter painter(&pdf);
  console::Sheet sheet(pdf, painter, QRectF(0, 0, pdf.width(), pdf.height()), title, 1);
  draw(sheet);
  if (pages) *pages = sheet.page();
  return sheet.cut().join("; ").toStdString();
}

}  // namespace swage::test
