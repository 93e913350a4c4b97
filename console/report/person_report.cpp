// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/report/person_report.hpp"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>

#include "console/models/made_with.hpp"
#include "console/models/words.hpp"
#include "console/report/sheet.hpp"
#include "console/widgets/band_bars.hpp"
#include "console/widgets/metric_chart.hpp"

namespace swage::console {
namespace {

constexpr int kMostAttempts = 12, kMostBars = 7;  // what one page holds

class PersonWords {
  Q_DECLARE_TR_FUNCTIONS(report)
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
  sheet.text(r.name.isEmpty() ? r.code : PersonWords::tr("%1 (%2)").arg(person_text(r.name), r.code), 18, true);
  sheet.text(PersonWords::tr("%1, %2").arg(r.lesson, QLocale().toString(QDate::currentDate(), QLocale::LongFormat)), 10, false, QColor(80, 80, 80));
  QString stands = PersonWords::tr("%1 of %2 attempts passed.").arg(r.standing.passed).arg(r.standing.attempts);
  if (const QString words = attention_words(r.standing); !words.isEmpty()) stands += PersonWords::tr(" Now: %1.").arg(words);
  sheet.text(stands, 11);
  sheet.gap(8);
  MetricChart chart;
  chart.set_theme(theme);
  chart.set_series(r.series);
  sheet.widget(chart, 250);
  sheet.text(r.series.fit, 9, false, QColor(80, 80, 80));
  if (!r.bars.isEmpty()) {
    sheet.gap(8);
    sheet.text(PersonWords::tr("Latest attempt, experts' band"), 11, true);
    BandBars bars;
    bars.set_theme(theme);
    bars.set_bars(r.bars.mid(0, kMostBars), {});
    sheet.widget(bars, bars.sizeHint().height());
  }
  sheet.gap(8);
  add_attempts(sheet, r);
  sheet.gap(12);
  sheet.text(PersonWords::tr("Instructor's note: ______________________________________________"), 10);
  sheet.gap(6);
  sheet.text(made_with(r.about).join(QStringLiteral(" · ")), 8, false, QColor(80, 80, 80));
  sheet.text(PersonWords::tr("Swage %1. For teaching, not for certification.").arg(QCoreApplication::applicationVersion()), 8, false, QColor(80, 80, 80));
}

}  // namespace

QString write_report(const PersonReport& report, const QString& file) {
  return write_sheet(file, report.code, [&](Sheet& sheet) { draw(sheet, report); });
}

}  // namespace swage::console
