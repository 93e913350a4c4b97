// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/review.hpp"

#include <QObject>
#include <QStringList>
#include <algorithm>
#include <charconv>
#include <cmath>

#include "console/models/attempts_model.hpp"
#include "console/models/metric_titles.hpp"
#include "console/models/qt_text.hpp"
#include "console/models/said.hpp"
#include "console/models/words.hpp"
#include "host/words.hpp"
#include "judge/host_events.hpp"
#include "judge/metrics.hpp"

namespace swage::console {
namespace {

// rank of a signal in an instructor's view, best first
int rank(const judge::Name& signal) {
  static const QStringList kWords = {"grasp.force", "grip.force", "pierce.force", "knot.throws", "winding.turns", "pull.tension",
                                     "cosine",      "stress",     "spot",         "tilt_axis",   "tilt_plane",    "tilt",
                                     "depth",       "angle",      "force",        "bend",        "reach"};
  const QString id = qt(signal.id);
  for (int i = 0; i < kWords.size(); ++i) {
    if (id.contains(kWords[i])) return i;
  }
  return -1;
}

Trace make_trace(const record::Recording& r, size_t index) {
  const judge::Name& name = r.info.script.signals[index];
  const QString unit = qt(name.unit);
  Trace t;
  t.index = index;
  t.name = said_name(name, r.info.script.signals);
  t.unit = display_unit(unit);
  t.factor = display_factor(unit);
  t.tip = QStringLiteral("%1: %2").arg(said_id(name.owner), said(name.doc));
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
  t.low = -nice_end(-low);
  t.high = nice_end(high);
  if (t.high <= t.low) t.high = t.low + 1;
  t.wanted = !t.flat && rank(name) >= 0;
  return t;
}

void add_moments(const record::Recording& r, const std::vector<record::EventRow>& events, Review& out) {
  for (const record::EventRow& e : events) {
    Moment m;
    m.time_s = e.time_s;
    m.by_person = e.owner == "note";
    if (!m.by_person) m.id = qt(e.id);
    m.as_kept = e.owner == "gap" ? QStringLiteral("not_recorded") : qt(e.id);
    m.by_lesson = e.owner == "lesson";
    m.technical = e.owner == "gap" || (e.owner == judge::kHostOwner && (e.id == "host.gap" || e.id == "host.solver" || e.id == "host.not_drawn"));
    m.what = m.by_person ? (e.id.empty() ? QObject::tr("Mark") : qt(e.id)) : said_id(e.id);
    if (e.owner == "gap") m.what = QObject::tr("Not recorded");
    for (const judge::Name& name : r.info.script.events) {
      if (name.owner != e.owner || name.id != e.id) continue;
      m.what = said_name(name, r.info.script.events);
      m.means = said_event(name.doc);
      m.doc = qt(std::string(host::without_value(name.doc)));
    }
    out.moments += m;
  }
  std::stable_sort(out.moments.begin(), out.moments.end(),
                   [](const Moment& a, const Moment& b) { return a.time_s < b.time_s; });
}

void add_metrics(const record::Recording& r, const snapshot::SceneCard* card, Review& out) {
  for (const record::MetricValue& m : out.attempt.metrics) {
    const MetricFacts facts = metric_facts(card, m.id);
    MetricLine line;
    line.id = m.id;
    line.name = metric_title(qt(m.id));
    line.points = metric_show(qt(m.id)) == SWAGE_SHOW_POINTS;
    line.number = m.value;
    line.unit = metric_unit(qt(m.id), qt(m.unit));
    line.value = line.points ? (m.value < 0.05 ? QStringLiteral("0") : QStringLiteral("−%L1").arg(m.value, 0, 'f', 1))
                             : quantity_text(m.value, line.unit);
    line.better = facts.better;
    for (const judge::Name& name : r.info.script.metrics) {
      if (name.id == m.id) line.doc = said(name.doc);
    }
    if (!facts.formula.isEmpty()) line.doc += QStringLiteral("\n") + facts.formula;
    out.metrics += line;
  }
}

template <class Number>
void put(std::string& out, Number value) {
  if (!std::isfinite(value)) return;  // an empty field, as in spreadsheets
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  out.append(text, end);
}

// not translated: files are read by programs, and in other languages
std::string better_in_files(int32_t better) {
  if (better == SWAGE_BETTER_INSIDE) return "best inside its band";
  const std::string word = host::better_text(better);
  return word.empty() ? word : word + " is better";
}

std::string quoted(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) out += c == '"' ? std::string("\"\"") : std::string(1, c);
  return out + "\"";
}

const QString kBetween = QStringLiteral("  ·  ");

// time, mode and seed of the attempt
QString origin(const Review& r) {
  QStringList parts{when_text(qt(r.attempt.started_utc))};
  if (r.hand.isEmpty()) parts += mode_text(qt(r.attempt.mode));
  return (parts << QObject::tr("seed %1").arg(r.seed)).join(kBetween);
}

// who held the instruments, if no person did
QString hand_words(const record::AttemptRow& attempt, const record::Recording& recording) {
  if (!is_hand(attempt)) return {};
  QStringList hands;
  for (const record::HandInfo& h : recording.info.hands)
    if (const QString one = said(h.choice); !one.isEmpty() && !hands.contains(one)) hands += one;
  return hands.isEmpty() ? QObject::tr("Recorded hand") : QObject::tr("Recorded hand: %1").arg(hands.join(QStringLiteral(", ")));
}

}  // namespace

Trace on_one_scale(const Trace& trace, const Trace& other) {
  constexpr double kSeen = 0.01;  // less is within the breadth of a line
  Trace out = trace;
  out.low = std::min(trace.low, other.low);
  out.high = std::max(trace.high, other.high);
  if (out.low < 0 && out.high > 0 && out.high < -kSeen * out.low) out.high = 0;
  if (out.low < 0 && out.high > 0 && -out.low < kSeen * out.high) out.low = 0;
  return out;
}

QString Review::title() const {
  QStringList parts{said(attempt.lesson_title.empty() ? attempt.lesson_id : attempt.lesson_title)};
  if (!hand.isEmpty()) parts += hand;
  return (parts << person_text(qt(attempt.person_name))).join(kBetween);
}

QString Review::facts() const { return verdict() + kBetween + origin(*this); }

QString Review::headline() const { return title() + kBetween + origin(*this); }

const MetricLine* Review::metric(const std::string& id) const {
  for (const MetricLine& m : metrics)
    if (m.id == id) return &m;
  return nullptr;
}

QString Review::verdict() const {
  const QString sign = attempt.outcome == "passed"   ? QStringLiteral("✓ ")
                       : attempt.outcome == "failed" ? QStringLiteral("✗ ")
                                                     : QString();
  const QString text = sign + verdict_text(attempt.is_void ? QStringLiteral("void") : qt(attempt.outcome));
  if (attempt.outcome == "passed")
    return QObject::tr("%1, %2 of 100").arg(text).arg(attempt.score, 0, 'f', 0);
  const QString told = why.isEmpty() ? said_id(attempt.reason) : why;
  return attempt.reason.empty() || told == text ? text : QStringLiteral("%1: %2").arg(text, told);
}

Review make_review(const record::AttemptRow& attempt, const record::Recording& recording,
                   const std::vector<record::EventRow>& events, const snapshot::SceneCard* card,
                   const std::vector<std::pair<std::string, double>>& given) {
  Review out;
  out.attempt = attempt;
  out.dt_s = recording.info.dt;
  out.seed = recording.info.seed;
  out.hand = hand_words(attempt, recording);
  out.length_s = recording.step.empty() ? 0 : static_cast<double>(recording.step.back() + 1) * out.dt_s;
  for (size_t i = 0; i < recording.info.script.signals.size(); ++i) out.traces += make_trace(recording, i);
  const auto order = [&](const Trace& t) {
    const int r = rank(recording.info.script.signals[t.index]);
    return t.wanted ? r : 1000 + static_cast<int>(t.index);
  };
  std::stable_sort(out.traces.begin(), out.traces.end(),
                   [&](const Trace& a, const Trace& b) { return order(a) < order(b); });
  for (const judge::Name& event : recording.info.script.events) {
    if (event.id == attempt.reason) out.why = said_event(event.doc);
  }
  add_moments(recording, events, out);
  add_metrics(recording, card, out);
  out.ratings = rating_lines(out.attempt.outcome, judge::metrics_of(out.attempt.metrics));
  out.scales = rated_scales(out.attempt.outcome, judge::metrics_of(out.attempt.metrics), given);
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
  line("attempt", "seed", none, none, "", std::to_string(review.seed));
  line("attempt", "score", none, a.score, "1", "0 to 100");
  line("attempt", "simulated", none, a.simulated_s, "s", "");
  for (size_t i = 0; i < a.metrics.size(); ++i) {
    const record::MetricValue& m = a.metrics[i];
    const int32_t better = review.metrics[static_cast<int>(i)].better;
    line("metric", m.id, none, m.value, m.unit, better_in_files(better));
  }
  for (const RatingLine& r : review.ratings)
    line("rating", r.id, none, r.points, "1", std::to_string(std::lround(r.lowest)) + " to " + std::to_string(std::lround(r.highest)));
  for (const RatedScale& scale : review.scales)
    for (const RatedItem& item : scale.items)
      if (item.given)
        line("rating_by_instructor", item.id, none, *item.given, "1",
             std::to_string(std::lround(scale.lowest)) + " to " + std::to_string(std::lround(scale.highest)));
  for (const Moment& m : review.moments)
    line("event", (m.by_person ? m.what : human_id(m.as_kept)).toStdString(), m.time_s, none, "", m.doc.toStdString());
  return out;
}

}  // namespace swage::console
