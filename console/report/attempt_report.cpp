// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/report/attempt_report.hpp"

#include <QCoreApplication>
#include <QLocale>
#include <algorithm>

#include "console/models/attempts_model.hpp"
#include "console/models/made_with.hpp"
#include "console/models/metric_limits.hpp"
#include "console/models/qt_text.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "console/report/sheet.hpp"
#include "console/widgets/timeline.hpp"
#include "console/widgets/track_plot.hpp"

namespace swage::console {
namespace {

constexpr int kMostMoments = 5, kTraces = 3;  // number of worst moments; number of traces that can be told apart in grey
constexpr double kHeading_px = 90;            // height of a heading and some lines below it
constexpr double kTimeline_px = 260, kTrack_px = 190;
const QColor kGrey(80, 80, 80);

class AttemptWords {
  Q_DECLARE_TR_FUNCTIONS(attempt_report)
};

QString seconds(double s) { return AttemptWords::tr("%L1 s").arg(s, 0, 'f', 2); }

void add_metrics(Sheet& sheet, const Review& review) {
  const QVector<double> shares = {0.5, 0.2, 0.3};
  sheet.row({AttemptWords::tr("Metric"), AttemptWords::tr("Value"), AttemptWords::tr("Direction")}, shares, true);
  for (const PrintedMetric& row : metric_rows(review)) sheet.row(row.cells, shares, false, row.below);
  if (std::none_of(review.metrics.begin(), review.metrics.end(), [](const MetricLine& m) { return m.points; })) return;
  sheet.gap(4);
  sheet.keep(kHeading_px);
  sheet.row({AttemptWords::tr("Points lost"), AttemptWords::tr("Of 100"), {}}, shares, true);
  for (const MetricLine& m : review.metrics)
    if (m.points) sheet.row({m.name, m.value, {}}, shares, false);
}

// Each item with its computed points and the instructor's; scales without either are left out.
void add_ratings(Sheet& sheet, const Review& review) {
  const QVector<double> shares = {0.4, 0.3, 0.3};
  for (const RatedScale& scale : review.scales) {
    if (scale.decided == 0 && scale.given == 0) continue;
    sheet.gap(4);
    sheet.keep(kHeading_px);
    sheet.text(scale.title, 11, true);
    sheet.text(scale.computed_words() + (scale.given > 0 ? QLatin1Char(' ') + scale.given_words() : QString()), 9);
    sheet.text(AttemptWords::tr("Source: %1").arg(scale.source), 8, false, kGrey);
    sheet.row({AttemptWords::tr("Item"), AttemptWords::tr("Computed from metrics"), AttemptWords::tr("Instructor's rating")}, shares, true);
    for (const RatedItem& item : scale.items)
      sheet.row({item.title, item.computed ? scale.points_words(*item.computed) : AttemptWords::tr("not decided"),
                 item.given ? scale.points_words(*item.given) : QStringLiteral("–")},
                shares, false);
  }
}

void add_moments(Sheet& sheet, const AttemptReport& r) {
  const QVector<double> shares = {0.12, 0.88};
  if (!r.worst.isEmpty()) sheet.keep(kHeading_px), sheet.text(AttemptWords::tr("Worst moments"), 11, true);
  for (int i = 0; i < std::min<int>(kMostMoments, static_cast<int>(r.worst.size())); ++i)
    sheet.row({seconds(r.worst[i].time_s), r.worst[i].what}, shares, false);
  if (const auto more = r.worst.size() - kMostMoments; more > 0) sheet.text(AttemptWords::tr("Further moments, in the review: %1.").arg(more), 8, false, kGrey);
  if (!r.notes.empty()) sheet.gap(6), sheet.keep(kHeading_px), sheet.text(AttemptWords::tr("Notes"), 11, true);
  for (const record::Note& note : r.notes) sheet.text(seconds(note.time_s) + QStringLiteral("   ") + qt(note.text), 9);
}

void add_plots(Sheet& sheet, const AttemptReport& r, const UiTheme& theme) {
  Timeline timeline;
  timeline.set_theme(theme);
  timeline.hide_cursor();
  timeline.set_review(&r.review, &r.recording);
  QVector<int> shown;
  for (int i = 0; i < r.review.traces.size() && shown.size() < kTraces; ++i)
    if (r.review.traces[i].wanted) shown += i;
  timeline.set_shown(shown);
  if (!shown.isEmpty()) sheet.widget(timeline, kTimeline_px);
  if (!r.track) return;
  TrackPlot track;
  track.set_theme(theme);
  track.set_track(r.track);
  track.set_cursor(r.review.length_s);
  sheet.widget(track, kTrack_px);
}

// The versions and the seed that produced the numbers.
QString made_with_line(const AttemptReport& r) {
  QStringList plugins;
  for (const auto& [id, version] : r.recording.info.plugins)
    if (const QString one = qt(id + " " + version); !plugins.contains(one)) plugins += one;
  return (made_with(r.about) + QStringList{AttemptWords::tr("seed %1").arg(r.review.seed)}).join(QStringLiteral(" · ")) + QStringLiteral("\n") +
         plugins.join(QStringLiteral(", "));
}

}  // namespace

QVector<PrintedMetric> metric_rows(const Review& review) {
  QVector<PrintedMetric> out;
  for (const MetricLine* m : by_limit(review))
    out.push_back({{m->name, marked_value(*m, m->target), better_words(m->better)}, beyond(m->number, m->target) != Beyond::kNo ? m->asked : QString()});
  return out;
}

void draw_attempt(Sheet& sheet, const AttemptReport& r) {
  const record::AttemptRow& a = r.review.attempt;
  sheet.text(said(a.lesson_title.empty() ? a.lesson_id : a.lesson_title), 18, true);
  const QString name = person_text(qt(a.person_name));
  const QString who =
      a.person_code.empty() || a.person_code == a.person_name ? name : AttemptWords::tr("%1 (%2)").arg(name, qt(a.person_code));
  sheet.text(QStringList({who, when_text(qt(a.started_utc)), r.review.hand.isEmpty() ? mode_text(qt(a.mode)) : r.review.hand,
                          seconds(a.simulated_s)}).join(QStringLiteral(" · ")), 10,
             false, kGrey);
  sheet.text(r.review.verdict(), 13, true);
  if (!a.void_reason.empty()) sheet.text(AttemptWords::tr("Void: %1").arg(qt(a.void_reason)), 10);
  sheet.gap(6);
  add_metrics(sheet, r.review);
  sheet.gap(4);
  add_ratings(sheet, r.review);
  sheet.gap(8);
  add_moments(sheet, r);
  sheet.gap(8);
  add_plots(sheet, r, UiTheme::stock(QStringLiteral("light")));
  sheet.text(made_with_line(r), 8, false, kGrey);
}

QString write_attempt_report(const AttemptReport& report, const QString& file) {
  return write_sheet(file, report.review.headline(), [&](Sheet& sheet) { draw_attempt(sheet, report); });
}

}  // namespace swage::console
