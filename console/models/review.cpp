// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/review.hpp"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "console/models/words.hpp"
#include "judge/host_events.hpp"

namespace swage::console {
namespace {

QString qt(const std::string& s) { return QString::fromStdString(s); }

// what an instructor looks at first, best first
int rank(const judge::Name& signal) {
  static const QStringList kWords = {"grasp.force", "grip.force", "pierce.force", "cosine", "spot",
                                     "tilt_axis",   "tilt_plane", "tilt",         "depth",  "angle",
                                     "force",       "bend",       "reach"};
  const QString id = qt(signal.id);
  for (int i = 0; i < kWords.size(); ++i) {
    if (id.contains(kWords[i])) return i;
  }
  return -1;
}

double nice_up(double value) {
  if (!(value > 0)) return 0;
  const double ten = std::pow(10, std::floor(std::log10(value)));
  for (const double m : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0}) {
    if (value <= m * ten * (1 + 1e-9)) return m * ten;
  }
  return 10 * ten;
}

Trace make_trace(const record::Recording& r, size_t index) {
  const judge::Name& name = r.info.script.signals[index];
  const QString unit = qt(name.unit);
  Trace t;
  t.index = index;
  t.name = human_id(qt(name.id));
  t.unit = display_unit(unit);
  t.factor = display_factor(unit);
  t.tip = QStringLiteral("%1: %2").arg(qt(name.owner), qt(name.doc));
  double low = 0, high = 0, first = std::nan("");
  t.flat = true;
  const size_t n = r.info.script.signals.size();
  for (size_t i = index; i < r.signal.size(); i += n) {
    const double v = t.factor * static_cast<double>(r.signal[i]);
    if (!std::isfinite(v)) continue;
    if (std::isnan(first)) first = v;
    t.flat &= v == first;
    low = std::min(low, v);
    high = std::max(high, v);
  }
  t.low = -nice_up(-low);
  t.high = nice_up(high);
  if (t.high <= t.low) t.high = t.low + 1;
  t.wanted = !t.flat && rank(name) >= 0;
  return t;
}

void add_moments(const record::Recording& r, const std::vector<record::EventRow>& events, Review& out) {
  for (const record::EventRow& e : events) {
    Moment m;
    m.time_s = e.time_s;
    m.by_person = e.owner == "note";
    m.technical = e.owner == "gap" || (e.owner == judge::kHostOwner && e.id == "host.gap");
    m.what = m.by_person ? (e.id.empty() ? QObject::tr("Mark") : qt(e.id)) : human_id(qt(e.id));
    if (e.owner == "gap") m.what = QObject::tr("Not recorded");
    for (const judge::Name& name : r.info.script.events) {
      if (name.owner == e.owner && name.id == e.id)
        m.means = qt(name.doc).section(QStringLiteral("; value:"), 0, 0);
    }
    out.moments += m;
  }
  std::stable_sort(out.moments.begin(), out.moments.end(),
                   [](const Moment& a, const Moment& b) { return a.time_s < b.time_s; });
}

void add_metrics(const record::Recording& r, Review& out) {
  const auto better = [](int direction) {
    return direction < 0   ? QObject::tr("↓ lower is better")
           : direction > 0 ? QObject::tr("↑ higher is better")
                           : QString();
  };
  for (const record::MetricValue& m : out.attempt.metrics) {
    MetricLine line;
    line.name = human_id(qt(m.id));
    line.value = quantity_text(m.value, qt(m.unit));
    line.better = better(better_direction(qt(m.id)));
    for (const judge::Name& name : r.info.script.metrics) {
      if (name.id == m.id) line.doc = qt(name.doc);
    }
    out.metrics += line;
  }
}

template <class Number>
void put(std::string& out, Number value) {
  if (!std::isfinite(value)) return;  // an empty field, as spreadsheets expect
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  out.append(text, end);
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

}  // namespace

// what is known of the metrics that the stock lessons use; of others no direction is claimed
int better_direction(const QString& id) {
  static const QStringList lower = {"time", "tries",  "drops",   "error",     "over_",   "peak",
                                    "tilt", "path",   "regrasp", "different", "balance", "slip",
                                    "snap", "tremor", "bend",    "tear"};
  static const QStringList higher = {"score", "in_zone", "success", "progress", "smooth"};
  const auto names = [&](const QStringList& words) {
    return std::any_of(words.begin(), words.end(), [&](const QString& w) { return id.contains(w); });
  };
  return names(higher) ? 1 : names(lower) ? -1 : 0;
}

QString Review::headline() const {
  return QStringList({qt(attempt.lesson_title.empty() ? attempt.lesson_id : attempt.lesson_title),
                      qt(attempt.person_name), when_text(qt(attempt.started_utc)),
                      human_id(qt(attempt.mode))})
      .join(QStringLiteral("  ·  "));
}

QString Review::verdict() const {
  const QString sign = attempt.outcome == "passed"   ? QStringLiteral("✓ ")
                       : attempt.outcome == "failed" ? QStringLiteral("✗ ")
                                                     : QString();
  const QString text = sign + verdict_text(attempt.is_void ? QStringLiteral("void") : qt(attempt.outcome));
  if (attempt.outcome == "passed")
    return QObject::tr("%1, %2 of 100").arg(text).arg(attempt.score, 0, 'f', 0);
  return attempt.reason.empty() ? text : QStringLiteral("%1: %2").arg(text, human_id(qt(attempt.reason)));
}

Review make_review(const record::AttemptRow& attempt, const record::Recording& recording,
                   const std::vector<record::EventRow>& events) {
  Review out;
  out.attempt = attempt;
  out.dt_s = recording.info.dt;
  out.length_s = recording.step.empty() ? 0 : static_cast<double>(recording.step.back() + 1) * out.dt_s;
  for (size_t i = 0; i < recording.info.script.signals.size(); ++i) out.traces += make_trace(recording, i);
  const auto order = [&](const Trace& t) {
    const int r = rank(recording.info.script.signals[t.index]);
    return t.wanted ? r : 1000 + static_cast<int>(t.index);
  };
  std::stable_sort(out.traces.begin(), out.traces.end(),
                   [&](const Trace& a, const Trace& b) { return order(a) < order(b); });
  add_moments(recording, events, out);
  add_metrics(recording, out);
  return out;
}

double value_at(const Trace& trace, const record::Recording& recording, size_t step) {
  const size_t at = step * recording.info.script.signals.size() + trace.index;
  return at < recording.signal.size() ? trace.factor * static_cast<double>(recording.signal[at])
                                      : std::nan("");
}

std::string signals_csv(const record::Recording& r) {
  const size_t n = r.info.script.signals.size();
  std::string out = "time [s]";
  for (const judge::Name& s : r.info.script.signals)
    out += "," + quoted(s.owner + " " + s.id + " [" + s.unit + "]");
  out += '\n';
  for (size_t i = 0; i < r.step.size(); ++i) {
    put(out, static_cast<double>(r.step[i] + 1) * r.info.dt);
    for (size_t k = 0; k < n; ++k) {
      out += ',';
      put(out, r.signal[i * n + k]);
    }
    out += '\n';
  }
  return out;
}

std::string summary_csv(const Review& review) {
  const record::AttemptRow& a = review.attempt;
  std::string out = "kind,name,time [s],value,unit,words\n";
  const auto line = [&](const char* kind, const std::string& name, double time, double value,
                        const std::string& unit, const std::string& words) {
    out += std::string(kind) + "," + quoted(name) + ",";
    put(out, time);
    out += ',';
    put(out, value);
    out += "," + quoted(unit) + "," + quoted(words) + "\n";
  };
  const double none = std::nan("");
  for (const auto& [name, words] : {std::pair{"attempt", a.id},
                                    {"person", a.person_name},
                                    {"lesson", a.lesson_id},
                                    {"mode", a.mode},
                                    {"device", a.device},
                                    {"started_utc", a.started_utc},
                                    {"outcome", a.outcome},
                                    {"reason", a.reason}})
    line("attempt", name, none, none, "", words);
  line("attempt", "score", none, a.score, "1", "0 to 100");
  line("attempt", "simulated", none, a.simulated_s, "s", "");
  for (const record::MetricValue& m : a.metrics) {
    const int better = better_direction(qt(m.id));
    line("metric", m.id, none, m.value, m.unit,
         better < 0   ? "lower is better"
         : better > 0 ? "higher is better"
                      : "");
  }
  for (const Moment& m : review.moments)
    line("event", m.what.toStdString(), m.time_s, none, "", m.means.toStdString());
  return out;
}

}  // namespace swage::console
