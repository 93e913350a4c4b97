// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/report/person_report.hpp"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSaveFile>

#include "console/models/words.hpp"
#include "console/widgets/band_bars.hpp"
#include "console/widgets/metric_chart.hpp"

namespace swage::console {
namespace {

constexpr int kDpi = 96;             // widgets draw as on a screen
constexpr double kMargin_mm = 18, kLine_px = 20;
constexpr int kMostAttempts = 12, kMostBars = 7;  // what one page holds

QString tr(const char* text) { return QCoreApplication::translate("report", text); }

/// Draws from the top of the page down.
class Sheet {
 public:
  Sheet(QPainter& painter, const QRectF& page) : p_(painter), page_(page), y_(page.top()) {}
  void text(const QString& words, double points, bool bold = false, const QColor& colour = Qt::black) {
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
  void gap(double px) { y_ += px; }
  void widget(QWidget& w, double height) {
    w.resize(static_cast<int>(page_.width()), static_cast<int>(height));
    p_.save();
    p_.translate(page_.left(), y_);
    w.render(&p_, {}, {}, QWidget::DrawChildren);
    p_.restore();
    y_ += height + 8;
  }
  void row(const QStringList& cells, const QVector<double>& shares, bool bold) {
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

 private:
  QPainter& p_;
  QRectF page_;
  double y_;
};

void add_attempts(Sheet& sheet, const PersonReport& r) {
  AttemptsModel model;
  model.set_attempts({r.attempts.begin(), r.attempts.end()});
  const QVector<int> columns = {AttemptsModel::kWhen, AttemptsModel::kMode, AttemptsModel::kVerdict, AttemptsModel::kScore,
                                AttemptsModel::kTime, AttemptsModel::kReason};
  const QVector<double> shares = {0.22, 0.12, 0.14, 0.08, 0.08, 0.36};
  QStringList heads;
  for (const int c : columns) heads += model.headerData(c, Qt::Horizontal, Qt::DisplayRole).toString();
  sheet.row(heads, shares, true);
  for (int i = 0; i < std::min(model.rowCount(), kMostAttempts); ++i) {
    QStringList cells;
    for (const int c : columns) cells += model.index(i, c).data().toString();
    sheet.row(cells, shares, false);
  }
}

void draw(Sheet& sheet, const PersonReport& r) {
  const UiTheme theme = UiTheme::stock(QStringLiteral("light"));
  sheet.text(r.name.isEmpty() ? r.code : tr("%1 (%2)").arg(r.name, r.code), 18, true);
  sheet.text(tr("%1, %2").arg(r.lesson, QLocale().toString(QDate::currentDate(), QLocale::LongFormat)), 10, false, QColor(80, 80, 80));
  QString stands = tr("%1 of %2 attempts passed.").arg(r.standing.passed).arg(r.standing.attempts);
  if (const QString words = attention_words(r.standing); !words.isEmpty()) stands += tr(" Now: %1.").arg(words);
  sheet.text(stands, 11);
  sheet.gap(8);
  MetricChart chart;
  chart.set_theme(theme);
  chart.set_series(r.series);
  sheet.widget(chart, 250);
  sheet.text(r.series.fit, 9, false, QColor(80, 80, 80));
  if (!r.bars.isEmpty()) {
    sheet.gap(8);
    sheet.text(tr("Latest attempt, experts' band"), 11, true);
    BandBars bars;
    bars.set_theme(theme);
    bars.set_bars(r.bars.mid(0, kMostBars), {});
    sheet.widget(bars, bars.sizeHint().height());
  }
  sheet.gap(8);
  add_attempts(sheet, r);
  sheet.gap(12);
  sheet.text(tr("Instructor's note: ______________________________________________"), 10);
  sheet.gap(6);
  sheet.text(tr("Swage %1. For teaching, not for certification.").arg(QCoreApplication::applicationVersion()), 8, false, QColor(80, 80, 80));
}

}  // namespace

QString write_report(const PersonReport& report, const QString& file) {
  QSaveFile out(file);
  if (!out.open(QIODevice::WriteOnly)) return tr("%1 cannot be written: %2.").arg(file, out.errorString());
  {
    QPdfWriter pdf(&out);
    pdf.setResolution(kDpi);
    pdf.setPageSize(QPageSize(QPageSize::A4));
    pdf.setPageMargins(QMarginsF(kMargin_mm, kMargin_mm, kMargin_mm, kMargin_mm), QPageLayout::Millimeter);
    pdf.setTitle(report.code);
    QPainter p(&pdf);
    Sheet sheet(p, QRectF(0, 0, pdf.width(), pdf.height()));
    draw(sheet, report);
  }
  return out.commit() ? QString() : tr("%1 cannot be written: %2.").arg(file, out.errorString());
}

}  // namespace swage::console
