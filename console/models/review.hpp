// SPDX-License-Identifier: LGPL-3.0-or-later
//
// One recorded attempt as the Review page shows it: traces over time, what happened when, metrics in words; and the same as
// CSV for other programs.
#pragma once

#include <QString>
#include <QVector>
#include <string>

#include "console/models/metric_facts.hpp"
#include "console/models/ratings.hpp"
#include "record/recorder.hpp"
#include "record/store.hpp"

namespace swage::console {

/// One signal over the attempt. Values are read from the recording, which outlives it.
struct Trace {
  QString name, unit, tip;   // unit as shown
  double factor = 1;         // from SI to that
  size_t index = 0;          // into the script's signals
  double low = 0, high = 1;  // of the axis, as shown; rounded outwards
  bool wanted = false;       // worth showing at once: forces, tilts, spot, depth
  bool flat = false;         // never changes
};

struct Moment {
  double time_s = 0;
  QString what, means;
  bool by_person = false, technical = false;
  QString id = {};  // of the event; "" for what a person said
  QString as_kept = {}, doc = {};  // the event's id and meaning as they are recorded, in no language of the window
  bool by_lesson = false;
};

struct MetricLine {
  std::string id;
  QString name, value, doc;  // doc: what it is and, where the lesson says, how it is computed
  int32_t better = SWAGE_BETTER_NONE;
  bool points = false;  // points that it cost, of the score's 100: no measurement
};

struct Review {
  record::AttemptRow attempt;
  QVector<Trace> traces;  // wanted ones first
  QVector<Moment> moments;
  QVector<MetricLine> metrics;
  QVector<RatingLine> ratings;  // on the scales of surgeons, as computed
  QVector<RatedScale> scales;   // the same scales whole, with what an instructor gave
  double dt_s = 1e-3, length_s = 0;
  uint64_t seed = 0;  // targets and tremor were drawn from it

  QString why;               // it ended so, in the lesson's words; "" where it has none
  QString hand;              // "Recorded hand: novice" where no person's hand made it; else ""
  QString title() const;     // "Basic grasp · Recorded hand: novice · Arun P."
  QString facts() const;     // "✓ Passed, 87 of 100 · 21 Nov 2026 10:30 · Practice · seed 7"
  QString headline() const;  // title and facts without the verdict, on one line
  const MetricLine* metric(const std::string& id) const;  // nullptr: it has none of that id
  QString verdict() const;   // "✓ Passed, 87 of 100"
};

/// `card`: of the replayed scene, where there is one; its lesson's card then says which way metrics are better, and how they
/// are computed. `given`: an instructor's points by item of a scale.
Review make_review(const record::AttemptRow& attempt, const record::Recording& recording,
                   const std::vector<record::EventRow>& events, const snapshot::SceneCard* card = nullptr,
                   const std::vector<std::pair<std::string, double>>& given = {});

/// Value of a trace at a recorded step, as shown.
double value_at(const Trace& trace, const record::Recording& recording, size_t step);

/// One line per step: time in s and every signal in SI, the unit in its heading. The decimal sign is a point.
std::string signals_csv(const record::Recording& recording);
/// Long form: kind, time or value, unit, words; the attempt's facts first, then metrics, ratings, events.
std::string summary_csv(const Review& review);

}  // namespace swage::console
