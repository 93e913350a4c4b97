// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/models/reading.hpp"

#include <swage/abi/lesson_card.h>

#include <algorithm>
#include <cmath>

#include "console/models/metric_titles.hpp"
#include "console/models/words.hpp"

namespace swage::console {
namespace {

constexpr int kMostCounters = 4;

bool ends_with(const std::string& text, const char* end) {
  return QString::fromStdString(text).endsWith(QLatin1String(end));
}

}  // namespace

Reader::Reader(const snapshot::SceneCard& card) {
  const judge::Script& script = card.script;
  for (int i = 0; i < static_cast<int>(script.signals.size()); ++i) {
    const judge::Name& s = script.signals[static_cast<size_t>(i)];
    if (s.unit == "N" && (ends_with(s.id, "grasp.force") || ends_with(s.id, "grip.force"))) force_.append(i);
    if (s.unit == "rad" && s.id.find("tilt") != std::string::npos) tilt_.append(i);
    if (ends_with(s.id, "grasp.held")) held_.append(i);
    if (ends_with(s.id, "pierce.angle")) angle_ = i;
    if (ends_with(s.id, "pierce.state")) pierced_ = i;
  }
  find_tension(card);
  // counts are shown live; metrics with a unit are shown at the end
  for (int i = 0; i < static_cast<int>(script.metrics.size()) && counters_.size() < kMostCounters; ++i) {
    const judge::Name& m = script.metrics[static_cast<size_t>(i)];
    const auto row = static_cast<size_t>(i);
    if (row < card.metrics.size() && card.metrics[row].show == SWAGE_SHOW_COUNT)
      counters_.append({i, metric_title(QString::fromStdString(m.id)), QString::fromStdString(m.unit)});
  }
  for (size_t i = 0; i < script.metrics.size(); ++i) {
    if (ends_with(script.metrics[i].id, "hold.progress")) hold_ = static_cast<int>(i);
  }
  for (const judge::Name& cue : script.cues) {
    cues_.append(QString::fromStdString(cue.id));
    grasp_ |= cues_.last() == QLatin1String("grasp.point_only");
  }
  // an assistant's jaws grip, too: a lesson that neither measures nor signals a grip shows no force
  const bool grips = std::any_of(script.metrics.begin(), script.metrics.end(), [](const judge::Name& m) { return m.unit == "N"; }) ||
                     std::any_of(cues_.begin(), cues_.end(), [](const QString& c) {
                       return c.startsWith(QLatin1String("grip.")) || c.startsWith(QLatin1String("grasp.")) || c.endsWith(QLatin1String(".held"));
                     });
  if (!grips && !script.metrics.empty()) force_.clear();
  for (const judge::Name& phase : script.phases) {
    phases_.append(phase.doc.empty() ? human_id(QString::fromStdString(phase.id))
                                     : QString::fromStdString(phase.doc));
  }
}

// Signals of tension: at the needle that draws the thread; for a stitch without a needle, where lessons limit it, before the first hole
// and beyond the last; for a thread without needle and stitch, the end that the lesson's metrics name, or its own greatest. The greatest
// is also that of the piece between the jaws, which keeps the tension with which they closed on it.
void Reader::find_tension(const snapshot::SceneCard& card) {
  const auto all = [&](const char* name) {
    QVector<int> out;
    for (int i = 0; i < static_cast<int>(card.script.signals.size()); ++i) {
      const judge::Name& s = card.script.signals[static_cast<size_t>(i)];
      if (s.unit == "N" && ends_with(s.id, name)) out.append(i);
    }
    return out;
  };
  tension_ = all("swage.tension");
  if (!tension_.isEmpty()) return;
  const QVector<int> before = all("pull.tension_tail"), beyond = all("pull.tension_out");
  if (!before.isEmpty() && !beyond.isEmpty()) {
    tension_ = {before.first(), beyond.last()};
    return;
  }
  constexpr const char* kAtEnd = "thread.tension_first";
  const bool judged = std::any_of(card.metrics.begin(), card.metrics.end(),
                                  [](const snapshot::CardMetric& m) { return m.formula.find(kAtEnd) != std::string::npos; });
  if (judged) tension_ = all(kAtEnd);
  if (tension_.isEmpty()) tension_ = all("thread.tension");
}

QStringList Reader::meanings(const snapshot::SceneCard& card) {
  QStringList out;
  for (const judge::Name& cue : card.script.cues) out += QString::fromStdString(cue.id);
  for (const judge::Script::Mark& mark : card.script.marks) out += QString::fromStdString(mark.meaning);
  out.removeDuplicates();
  return out;
}

Reading Reader::read(const snapshot::Snapshot& s) const {
  Reading r;
  const auto signal = [&](int i) {
    return i >= 0 && static_cast<uint32_t>(i) < s.n_signal ? s.signal[i] : std::nan("");
  };
  // of several objects the one that is grasped, which has a finite value
  for (const int i : force_) r.force = std::fmax(r.force.value_or(0), signal(i));
  for (const int i : tension_) r.tension = std::fmax(r.tension.value_or(0), signal(i));
  const bool any_held = std::any_of(held_.begin(), held_.end(), [&](int i) { return signal(i) > 0.5; });
  const bool held = held_.isEmpty() || any_held;
  if (!held_.isEmpty()) r.held = any_held;
  // a needle that only touches the tissue has no angle yet
  if (angle_ >= 0 && signal(pierced_) > (any_held ? 0.5 : 1.5)) r.tilt = signal(angle_);
  for (const int i : angle_ < 0 ? tilt_ : QVector<int>()) {
    if (held && r.force.value_or(1) > 0) r.tilt = std::max(r.tilt.value_or(0), std::abs(signal(i)));
  }
  // the grasp meanings combine two yes/no facts; that of a tilt says that both are right
  for (uint32_t o = 0; o < s.n_object; ++o) {
    const uint32_t cue = s.object_cue[o];
    if (cue >= static_cast<uint32_t>(cues_.size())) continue;
    const QString& meaning = cues_[static_cast<int>(cue)];
    r.meanings += meaning;
    if (meaning == QLatin1String("grasp.wrong")) r.spot = false, r.tips = false;
    if (meaning == QLatin1String("grasp.tips_only")) r.spot = false, r.tips = true;
    if (meaning == QLatin1String("grasp.point_only")) r.spot = true, r.tips = false;
    if (meaning == QLatin1String("grasp.good") || meaning == QLatin1String("grasp.tilted")) r.spot = true, r.tips = true;
  }
  for (uint32_t m = 0; m < s.n_mark; ++m) {
    if (s.mark_cue[m] < static_cast<uint32_t>(cues_.size()))
      r.meanings += cues_[static_cast<int>(s.mark_cue[m])];
  }
  r.meanings.removeDuplicates();
  if (const QLatin1String near("target.near"); cues_.contains(near)) r.at_target = r.meanings.contains(near);
  if (s.phase < static_cast<uint32_t>(phases_.size())) r.phase = phases_[static_cast<int>(s.phase)];
  if (hold_ >= 0 && static_cast<uint32_t>(hold_) < s.n_metric) r.hold = s.metric[hold_];
  for (const Counter& c : counters_) {
    const bool known = static_cast<uint32_t>(c.metric) < s.n_metric;
    r.counts.append({c.name, quantity_text(known ? s.metric[c.metric] : std::nan(""), c.unit)});
  }
  return r;
}

}  // namespace swage::console
