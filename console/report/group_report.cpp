// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/report/group_report.hpp"

#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>
#include <algorithm>

#include "console/models/words.hpp"
#include "console/report/sheet.hpp"

namespace swage::console {
namespace {

constexpr double kHeading_px = 90;  // height of a heading and some lines below it
const QColor kGrey(80, 80, 80);

class GroupWords {
  Q_DECLARE_TR_FUNCTIONS(group_report)
};

QString day_words(const QString& utc) {
  const QDateTime when = QDateTime::fromString(utc, Qt::ISODate).toLocalTime();
  return when.isValid() ? date_text(when.date()) : GroupWords::tr("not yet");
}

QStringList cells_of(const GroupRow& row, bool of_course) {
  const QString who = row.name.isEmpty() || row.name == row.code ? row.code : GroupWords::tr("%1 (%2)").arg(person_text(row.name), row.code);
  const QString lessons = of_course ? GroupWords::tr("%1 of %2").arg(row.lessons_passed).arg(row.passed_steps.size())
                                    : QString::number(row.lessons_passed);
  return {who,
          lessons,
          row.attempts == 0 ? QStringLiteral("–") : GroupWords::tr("%1, %2 passed").arg(row.attempts).arg(row.passed),
          row.last_score ? QString::number(*row.last_score, 'f', 0) : QStringLiteral("–"),
          day_words(row.last_utc)};
}

/// Each column but the names as wide as its longest text.
QVector<double> shares_of(const Sheet& sheet, const QStringList& heads, const QVector<QStringList>& rows) {
  QVector<double> shares = {0};
  double sum = 0;
  for (int c = 1; c < heads.size(); ++c) {
    double share = sheet.share_of(heads[c], true);
    for (const QStringList& row : rows) share = std::max(share, sheet.share_of(row[c], false));
    shares += share;
    sum += share;
  }
  shares[0] = std::max(0.0, 1 - sum);
  return shares;
}

// The reason of who needs attention has a line of its own: beside the numbers there is too little room for it.
void add_people(Sheet& sheet, const GroupReport& r) {
  const QStringList heads = {GroupWords::tr("Name"), GroupWords::tr("Lessons passed"), GroupWords::tr("Attempts"), GroupWords::tr("Last score"),
                             GroupWords::tr("Last seen")};
  QVector<QStringList> cells;
  for (const GroupRow& row : r.rows) cells += cells_of(row, !r.course.isEmpty());
  const QVector<double> shares = shares_of(sheet, heads, cells);
  sheet.row(heads, shares, true);
  for (int i = 0; i < cells.size(); ++i) {
    const QString& flag = r.rows[i].flag;
    sheet.row(cells[i], shares, false, flag.isEmpty() ? QString() : GroupWords::tr("▲ Needs attention: %1").arg(flag));
  }
}

// a lesson that few have passed is the hurdle of the course
void add_lessons(Sheet& sheet, const GroupReport& r) {
  if (r.lessons.isEmpty()) return;
  sheet.gap(10);
  sheet.keep(kHeading_px);
  sheet.text(GroupWords::tr("Lessons of the course"), 11, true);
  const QVector<double> shares = {0.6, 0.4};
  sheet.row({GroupWords::tr("Lesson"), GroupWords::tr("Passed by")}, shares, true);
  for (int i = 0; i < r.lessons.size(); ++i) {
    const auto passed = std::count_if(r.rows.begin(), r.rows.end(), [i](const GroupRow& row) { return row.passed_steps.value(i); });
    sheet.row({r.lessons[i], GroupWords::tr("%1 of %2").arg(passed).arg(r.rows.size())}, shares, false);
  }
}

}  // namespace

void draw_group(Sheet& sheet, const GroupReport& r) {
  sheet.text(r.title, 18, true);
  const QString what = r.course.isEmpty() ? GroupWords::tr("All lessons") : r.course;
  sheet.text(GroupWords::tr("%1, %2").arg(what, date_text(QDate::currentDate())), 10, false, kGrey);
  sheet.text(group_words(r), 11);
  sheet.gap(8);
  add_people(sheet, r);
  add_lessons(sheet, r);
  sheet.gap(8);
  const QString rule = r.course.isEmpty() ? GroupWords::tr("A lesson is passed here when one attempt at it was.")
                                          : GroupWords::tr("A lesson is passed here when the rule of the course is met, in Test.");
  sheet.text(rule + QLatin1Char(' ') +
                 GroupWords::tr("Attempts that count: by the person's own hand, ended by themselves, not void. Last score: of the newest passed one."),
             8, false, kGrey);
}

QString group_words(const GroupReport& r) {
  int flagged = 0, passed = 0;
  std::vector<double> scores;
  for (const GroupRow& row : r.rows) {
    flagged += !row.flag.isEmpty();
    passed += row.lessons_passed;
    if (row.last_score) scores.push_back(*row.last_score);
  }
  QStringList words = {GroupWords::tr("%1 people, of whom %2 need attention.").arg(r.rows.size()).arg(flagged)};
  if (!r.lessons.isEmpty()) words += GroupWords::tr("%1 of %2 lessons passed.").arg(passed).arg(r.rows.size() * r.lessons.size());
  if (!scores.empty()) {
    const auto middle = scores.begin() + static_cast<std::ptrdiff_t>(scores.size() / 2);
    std::nth_element(scores.begin(), middle, scores.end());
    double median = *middle;
    if (scores.size() % 2 == 0) median = 0.5 * (median + *std::max_element(scores.begin(), middle));
    words += GroupWords::tr("Median of the last scores: %1.").arg(median, 0, 'f', 0);
  }
  return words.join(QLatin1Char(' '));
}

QString write_group_report(const GroupReport& report, const QString& file) {
  const QString title = report.course.isEmpty() ? report.title : report.title + QStringLiteral(", ") + report.course;
  return write_sheet(file, title, [&](Sheet& sheet) { draw_group(sheet, report); });
}

}  // namespace swage::console
