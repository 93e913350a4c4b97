// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/worst_moments.hpp"

#include <QObject>
#include <QRegularExpression>
#include <algorithm>
#include <cmath>

#include "console/models/metric_titles.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"

namespace swage::console {
namespace {

// Relative tolerance between a metric and its signal's raw peak; the metric is a filtered peak or a quantile. 0: only equal numbers match;
// large: a signal of another size matches.
constexpr double kNear = 0.25;

QStringList parts(const std::string& id) {
  static const QRegularExpression kBreak(QStringLiteral("[._]"));
  return QString::fromStdString(id).split(kBreak, Qt::SkipEmptyParts);
}

// The ABI does not mark events as good or bad; their names do. Contacts of a coupling are not mishaps: only a lesson can define
// objects that must not be touched.
bool is_mishap(const Moment& m) {
  static const QRegularExpression kWords(
      QStringLiteral("(^|[._])(failed|dropped|broke|lost|deflected|refused|torn|slipped|missed|reset|quarantined|force_stopped|"
                     "pulled_off|off_angle|too_hard|collapsed)($|[._])"));
  static const QRegularExpression kTouched(QStringLiteral("(^|[._])touched($|[._])"));
  return kWords.match(m.id).hasMatch() || (m.by_lesson && kTouched.match(m.id).hasMatch());
}

struct Peak {
  double value = 0, time_s = 0;
};

Peak peak_of(const Trace& t, const record::Recording& r, double dt_s) {
  const size_t n = r.info.script.signals.size();
  Peak out;
  for (size_t i = 0; i < r.step.size() && i * n + t.index < r.signal.size(); ++i) {
    const double v = std::abs(static_cast<double>(r.signal[i * n + t.index]));
    if (std::isfinite(v) && v > out.value) out = {v, static_cast<double>(r.step[i] + 1) * dt_s};
  }
  return out;
}

// The peak of the signal from which a metric was computed: same unit, a word in common, nearly the same number.
bool find_peak(const record::MetricValue& m, const Review& review, const record::Recording& r, Peak& out) {
  double nearest = kNear * m.value;
  bool found = false;
  const QStringList words = parts(m.id);
  for (const Trace& t : review.traces) {
    const judge::Name& signal = r.info.script.signals[t.index];
    const QStringList own = parts(signal.id);
    const bool related = std::any_of(own.begin(), own.end(), [&](const QString& w) { return words.contains(w); });
    if (t.flat || signal.unit != m.unit || !related) continue;
    const Peak peak = peak_of(t, r, review.dt_s);
    if (std::abs(peak.value - m.value) > nearest) continue;
    nearest = std::abs(peak.value - m.value);
    out = peak;
    found = true;
  }
  return found;
}

void add_mishaps(const Review& review, QVector<WorstMoment>& out) {
  const QString reason = QString::fromStdString(review.attempt.reason);
  const bool failed = review.attempt.outcome == "failed" && !reason.isEmpty();
  bool told = false;
  for (const Moment& m : review.moments) {
    const bool ended = failed && m.id == reason;
    if (m.by_person || m.technical || !(ended || is_mishap(m))) continue;
    told |= ended;
    out += {m.time_s, ended ? QObject::tr("%1: this ended the attempt").arg(m.what) : m.what, m.means,
            ended ? kEndedIt : kOverLimit};
  }
  if (failed && !told)
    out += {review.length_s, QObject::tr("%1: this ended the attempt").arg(said_id(review.attempt.reason)), review.why, kEndedIt};
}

}  // namespace

QVector<WorstMoment> worst_moments(const Review& review, const record::Recording& recording, const TargetFinder& target) {
  QVector<WorstMoment> out;
  add_mishaps(review, out);
  const auto& metrics = review.attempt.metrics;
  for (size_t i = 0; i < metrics.size() && i < static_cast<size_t>(review.metrics.size()); ++i) {
    const record::MetricValue& m = metrics[i];
    const MetricLine& line = review.metrics[static_cast<int>(i)];
    const int32_t show = metric_show(QString::fromStdString(m.id));
    Peak peak;
    if (line.better != SWAGE_BETTER_LOWER || (show != SWAGE_SHOW_QUANTITY && show != SWAGE_SHOW_SHARE)) continue;
    if (!(std::isfinite(m.value) && m.value > 0) || !find_peak(m, review, recording, peak)) continue;
    const std::optional<double> most = target ? target(m.id).high : std::nullopt;
    const double share = most && *most > 0 ? m.value / *most : 0.5;
    const QString unit = metric_unit(QString::fromStdString(m.id), QString::fromStdString(m.unit));
    const QString asked = most ? quantity_text(*most, unit) : QString();
    const QString what = !most        ? QObject::tr("%1 %2").arg(line.name, line.value)
                         : share > 1 ? QObject::tr("%1 %2, at most %3 is asked").arg(line.name, line.value, asked)
                                      : QObject::tr("%1 %2, within what is asked (%3)").arg(line.name, line.value, asked);
    out += {peak.time_s, what, line.doc, share > 1 ? kOverLimit + share : share};
  }
  std::stable_sort(out.begin(), out.end(), [](const WorstMoment& a, const WorstMoment& b) { return a.weight > b.weight; });
  if (out.size() > kMostWorst) out.resize(kMostWorst);
  return out;
}

}  // namespace swage::console
