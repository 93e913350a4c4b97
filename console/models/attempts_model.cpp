// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/attempts_model.hpp"

#include <QDateTime>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "console/models/metric_titles.hpp"
#include "console/models/qt_text.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "judge/learning.hpp"

namespace swage::console {
namespace {

const QString kScoreId = QStringLiteral("score");
const QString kTimeId = QStringLiteral("time");

QString verdict(const record::AttemptRow& a) {
  if (a.state == "recovered") return QObject::tr("Recovered");
  if (a.is_void) return verdict_text(QStringLiteral("void"));
  const QString sign = a.outcome == "passed"   ? QStringLiteral("✓ ")
                       : a.outcome == "failed" ? QStringLiteral("✗ ")
                                               : QString();
  return sign + verdict_text(qt(a.outcome));
}

QString mode_words(const record::AttemptRow& a) {
  if (!is_hand(a)) return mode_text(qt(a.mode));
  const QString name = hand_name(a);
  return name.isEmpty() ? AttemptsModel::tr("Recorded hand, not counted") : AttemptsModel::tr("Recorded hand: %1").arg(name);
}

}  // namespace

void AttemptsModel::set_attempts(const std::vector<record::AttemptRow>& attempts) {
  beginResetModel();
  rows_ = QVector<record::AttemptRow>(attempts.begin(), attempts.end());
  endResetModel();
}

int AttemptsModel::rowCount(const QModelIndex& parent) const {
  return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int AttemptsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : kColumns; }

QVariant AttemptsModel::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rows_.size()) return {};
  const record::AttemptRow& a = rows_[index.row()];
  const bool number = index.column() == kScore;  // a time has five characters in every row, and its column stands before words
  if (role == Qt::TextAlignmentRole && number) return int(Qt::AlignRight | Qt::AlignVCenter);
  if (role == kId) return qt(a.id);
  if (role == Qt::ToolTipRole && index.column() == kLesson) return qt(a.lesson_id);
  if (role == Qt::ToolTipRole && index.column() == kMode && is_hand(a)) return tr("An attempt by a recorded hand counts for nobody.");
  if (role == kSortRole) {
    if (index.column() == kWhen) return qt(a.started_utc);
    if (index.column() == kScore) return has_score(a) ? a.score : -1.0;
    if (index.column() == kTime) return a.simulated_s;
  } else if (role != Qt::DisplayRole) {
    return {};
  }
  switch (index.column()) {
    case kWhen:
      return when_text(qt(a.started_utc));
    case kLesson:
      return said(a.lesson_title.empty() ? a.lesson_id : a.lesson_title);
    case kMode:
      return mode_words(a);
    case kVerdict:
      return verdict(a);
    case kScore:
      return has_score(a) ? QString::number(a.score, 'f', 0) : QStringLiteral("–");
    case kTime:
      return clock_text(a.simulated_s);
    case kReason:
      if (a.is_void && !a.void_reason.empty()) return tr("%1 (voided by %2)").arg(qt(a.void_reason), qt(a.void_by));
      return a.remark.empty() ? said_id(a.reason) : QStringLiteral("%1 (%2)").arg(said_id(a.reason), remark_text(qt(a.remark)));
    default:
      return {};
  }
}

QVariant AttemptsModel::headerData(int section, Qt::Orientation orientation, int role) const {
  if (orientation != Qt::Horizontal) return {};
  if (role == Qt::TextAlignmentRole) {
    return int((section == kScore ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
  }
  if (role != Qt::DisplayRole) return {};
  switch (section) {
    case kWhen:
      return tr("When");
    case kLesson:
      return tr("Lesson");
    case kMode:
      return tr("Mode");
    case kVerdict:
      return tr("Verdict");
    case kScore:
      return tr("Score");
    case kTime:
      return tr("Time");
    case kReason:
      return tr("Reason");
    default:
      return {};
  }
}

bool is_hand(const record::AttemptRow& attempt) { return attempt.is_scripted || attempt.mode == "hand"; }

// a list of attempts has the name in brackets after the device: "swage.device.skilled (novice)"
QString hand_name(const record::AttemptRow& attempt) {
  const std::string& device = attempt.device;
  const size_t open = device.rfind(" (");
  if (!is_hand(attempt) || open == std::string::npos || device.back() != ')') return {};
  return said(device.substr(open + 2, device.size() - open - 3));
}

bool counts(const record::AttemptRow& a) { return !a.is_void && !is_hand(a) && (a.outcome == "passed" || a.outcome == "failed"); }

bool has_score(const record::AttemptRow& attempt) { return attempt.outcome == "passed"; }

QStringList metric_ids(const QVector<record::AttemptRow>& attempts) {
  QStringList ids = {kScoreId, kTimeId};
  for (const record::AttemptRow& a : attempts) {
    for (const record::MetricValue& m : a.metrics) {
      const QString id = qt(m.id);
      if (!ids.contains(id) && metric_show(id) != SWAGE_SHOW_POINTS) ids += id;
    }
  }
  return ids;
}

MetricSeries metric_series(const QVector<record::AttemptRow>& attempts, const QString& id) {
  MetricSeries series;
  series.id = id;
  series.name = metric_title(id);
  series.better = metric_facts(nullptr, id.toStdString()).better;
  series.unit = id == kTimeId ? QStringLiteral("s") : QString();
  QVector<const record::AttemptRow*> order;
  for (const record::AttemptRow& a : attempts) order += &a;
  std::stable_sort(order.begin(), order.end(),
                   [](const auto* a, const auto* b) { return a->started_utc < b->started_utc; });
  for (const record::AttemptRow* a : order) {
    // an aborted attempt says nothing about skill
    if (!counts(*a)) continue;
    const bool passed = a->outcome == "passed";
    if (id == kScoreId && !has_score(*a)) {
      ++series.without_score;
      continue;
    }
    double value = id == kScoreId ? a->score : id == kTimeId ? a->simulated_s : std::nan("");
    for (const record::MetricValue& m : a->metrics) {
      if (qt(m.id) != id) continue;
      const QString unit = metric_unit(id, qt(m.unit));
      series.factor = display_factor(unit);
      value = m.value * series.factor;
      series.unit = display_unit(unit);
    }
    if (!std::isfinite(value)) continue;
    series.failed += !passed;
    const QDateTime when = QDateTime::fromString(qt(a->started_utc), Qt::ISODate).toLocalTime();
    series.points += {value, passed, a->mode == "test", when.date().toString(Qt::ISODate),
                      when_text(qt(a->started_utc)) + QStringLiteral(", ") + verdict(*a)};
  }
  const int32_t show = metric_show(id);
  const bool negative = std::any_of(series.points.begin(), series.points.end(), [](const MetricPoint& p) { return p.value < 0; });
  if (!negative) series.least = 0;  // metrics without negative values are amounts, which have no values below 0
  if (id == kScoreId) series.most = 100;
  if (show == SWAGE_SHOW_YES_NO) series.most = 1;
  return series;
}

namespace {

// a sentence on the points that come from attempts not passed
QString about_failures(const MetricSeries& series) {
  if (series.without_score > 0)
    return QLatin1Char(' ') + QObject::tr("Not passed, so without a score and left out: %1.").arg(series.without_score);
  if (series.failed > 0)
    return QLatin1Char(' ') + QObject::tr("Not passed, counted with what was measured: %1.").arg(series.failed);
  return {};
}

void fit_curve(MetricSeries& series) {
  const auto n = static_cast<int>(series.points.size()), fewest = static_cast<int>(judge::kFewestForCurve);
  series.curve.clear();
  series.fit.clear();
  if (n < fewest) {
    series.fit = QObject::tr("A curve needs %1 finished attempts. %2 more.").arg(fewest).arg(fewest - n);
    return;
  }
  std::vector<double> values;
  for (const MetricPoint& p : series.points) values.push_back(p.value);
  // clamped to the metric's scale, which the fit and its interval do not know
  const auto text = [&](double v) {
    v = std::clamp(v, series.least.value_or(v), std::max(series.most.value_or(v), series.least.value_or(v)));
    const QString number = series.id == kScoreId ? QLocale().toString(v, 'f', 0) : QLocale().toString(v, 'g', 3);
    return QStringLiteral("%1 %2").arg(number, series.unit).trimmed();
  };
  const judge::Curve curve = judge::fit_curve(values);
  if (!curve.fitted) {
    const judge::Recent last = judge::recent(values);
    series.fit = QObject::tr("No curve: %1 Median of the last %2: %3 (%4 to %5).")
                     .arg(said_message(curve.why_not))
                     .arg(last.n)
                     .arg(text(last.median), text(last.low), text(last.high)) ;
    return;
  }
  for (int i = 0; i < n; ++i) series.curve += curve.at(i + 1);
  // a fitted level further outside than the spread of the attempts is not credible
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double span = *most - *least;
  const bool level = curve.low >= *least - span && curve.high <= *most + span;
  series.fit = QObject::tr("Learning curve: %1 at the first attempt, %2 at the latest").arg(text(curve.at(1)), text(curve.at(n)));
  if (!level) {
    series.fit += QObject::tr("; a plateau cannot be estimated from these attempts yet.");
    return;
  }
  series.fit += QObject::tr(", towards %1 (95 %: %2 to %3).").arg(text(curve.a), text(curve.low), text(curve.high));
  if (std::isfinite(curve.half_way) && curve.half_way > 0 && curve.half_way < 1000)
    series.fit += QLatin1Char(' ') + QObject::tr("Half-way after %1 attempts.").arg(QLocale().toString(curve.half_way, 'f', 1));
}

}  // namespace

void fit_series(MetricSeries& series) {
  fit_curve(series);
  series.fit += about_failures(series);
}

}  // namespace swage::console
