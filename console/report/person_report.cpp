// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/report/person_report.hpp"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <algorithm>
#include <vector>

#include "console/models/made_with.hpp"
#include "console/models/words.hpp"
#include "console/report/sheet.hpp"
#include "console/widgets/band_bars.hpp"
#include "console/widgets/metric_chart.hpp"

namespace swage::console {
namespace {

constexpr int kFewBars = 3;          // with fewer on a page the bars begin on the next one
constexpr double kBarsHead_px = 30;  // above the bars: which side is better
constexpr double kLeastLast = 0.16;  // of the page, for the reason of the verdict
constexpr double kTableHead_px = 90;  // height of a heading and some lines below it

class PersonWords {
  Q_DECLARE_TR_FUNCTIONS(report)
};

/// Each column as wide as its longest text, in either language. The last has what is left, and at least kLeastLast of the page: then
/// the title of the lesson, or the widest column without one, gives way and is elided.
QVector<double> column_shares(const Sheet& sheet, const AttemptsModel& model, const QVector<int>& columns, const QStringList& heads) {
  QVector<double> shares;
  double sum = 0;
  for (int c = 0; c + 1 < columns.size(); ++c) {
    double share = sheet.share_of(heads[c], true);
    for (int i = 0; i < model.rowCount(); ++i) share = std::max(share, sheet.share_of(model.index(i, columns[c]).data().toString(), false));
    shares += share;
    sum += share;
  }
  if (const double over = sum - (1 - kLeastLast); over > 0) {
    const auto lesson = columns.indexOf(AttemptsModel::kLesson);
    const auto widest = lesson >= 0 ? shares.begin() + lesson : std::max_element(shares.begin(), shares.end());
    const double less = std::clamp(over, 0.0, std::max(0.0, *widest - kLeastLast / 2));
    *widest -= less;
    sum -= less;
  }
  return shares << std::max(0.0, 1 - sum);
}

void add_attempts(Sheet& sheet, const PersonReport& r) {
  AttemptsModel model;
  model.set_attempts({r.attempts.begin(), r.attempts.end()});
  const bool several = std::any_of(r.attempts.begin(), r.attempts.end(),
                                   [&](const record::AttemptRow& a) { return a.lesson_id != r.attempts.front().lesson_id; });
  QVector<int> columns = {AttemptsModel::kWhen, AttemptsModel::kMode, AttemptsModel::kVerdict, AttemptsModel::kScore,
                          AttemptsModel::kTime, AttemptsModel::kReason};
  if (several) columns.insert(1, AttemptsModel::kLesson);
  QStringList heads;
  for (const int c : columns) heads += model.headerData(c, Qt::Horizontal, Qt::DisplayRole).toString();
  const QVector<double> shares = column_shares(sheet, model, columns, heads);
  sheet.row(heads, shares, true);
  for (int i = 0; i < model.rowCount(); ++i) {
    QStringList cells;
    for (const int c : columns) cells += model.index(i, c).data().toString();
    sheet.row(cells, shares, false);
  }
}

/// "62 of 72 attempts at this lesson passed; 184 of 223 at all lessons."
QString passed_words(const PersonReport& r) {
  std::vector<const record::AttemptRow*> here;
  for (const record::AttemptRow& a : r.attempts) here.push_back(&a);
  const Standing at_lesson = standing_of(here, QDateTime::currentDateTimeUtc());
  const QString all = PersonWords::tr("%1 of %2 attempts at all lessons passed.").arg(r.standing.passed).arg(r.standing.attempts);
  if (at_lesson.attempts == r.standing.attempts) return all;
  return PersonWords::tr("%1 of %2 attempts at this lesson passed.").arg(at_lesson.passed).arg(at_lesson.attempts) + QLatin1Char(' ') + all;
}

void add_bars(Sheet& sheet, const PersonReport& r, const UiTheme& theme) {
  if (r.bars.isEmpty()) return;
  sheet.gap(8);
  sheet.keep(kTableHead_px + kFewBars * BandBars::row_px());
  sheet.text(PersonWords::tr("Latest attempt, experts' band"), 11, true);
  for (int from = 0; from < r.bars.size();) {
    sheet.keep(kBarsHead_px + kFewBars * BandBars::row_px());
    const int n = std::max(1, static_cast<int>((sheet.room() - kBarsHead_px) / BandBars::row_px()));  // that fit on this page
    BandBars bars;
    bars.set_theme(theme);
    bars.set_bars(r.bars.mid(from, n), {});
    sheet.widget(bars, bars.sizeHint().height());
    from += n;
  }
}

void draw(Sheet& sheet, const PersonReport& r) {
  const UiTheme theme = UiTheme::stock(QStringLiteral("light"));
  sheet.text(r.name.isEmpty() ? r.code : PersonWords::tr("%1 (%2)").arg(person_text(r.name), r.code), 18, true);
  sheet.text(PersonWords::tr("%1, %2").arg(r.lesson, date_text(QDate::currentDate())), 10, false, QColor(80, 80, 80));
  QString stands = passed_words(r);
  if (const QString words = attention_words(r.standing); !words.isEmpty()) stands += PersonWords::tr(" Now: %1.").arg(words);
  sheet.text(stands, 11);
  sheet.gap(8);
  MetricChart chart;
  chart.set_theme(theme);
  chart.set_series(r.series);
  sheet.widget(chart, 250);
  sheet.text(r.series.fit, 9, false, QColor(80, 80, 80));
  add_bars(sheet, r, theme);
  sheet.gap(8);
  sheet.keep(kTableHead_px);
  sheet.text(PersonWords::tr("Attempts"), 11, true);
  add_attempts(sheet, r);
  sheet.gap(12);
  sheet.keep(kTableHead_px);
  sheet.text(PersonWords::tr("Instructor's note: ______________________________________________"), 10);
  sheet.gap(6);
  sheet.text(made_with(r.about).join(QStringLiteral(" · ")), 8, false, QColor(80, 80, 80));
}

}  // namespace

QString write_report(const PersonReport& report, const QString& file) {
  const QString title = (report.code.isEmpty() ? person_text(report.name) : report.code) + QStringLiteral(", ") + report.lesson;
  return write_sheet(file, title, [&](Sheet& sheet) { draw(sheet, report); });
}

}  // namespace swage::console
