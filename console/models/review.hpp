// SPDX-License-Identifier: LGPL-3.0-or-later
//
// One recorded attempt for the Review page: traces over time, events, metrics as text; and the same data as
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

/// One signal over the attempt. Its values are read from the recording, which outlives it.
struct Trace {
  QString name, unit, tip;   // display unit
  double factor = 1;         // from SI to the display unit
  size_t index = 0;          // index into the script's signals
  double low = 0, high = 1;  // range of the axis in the display unit, rounded outwards
  bool wanted = false;       // shown from the start: forces, tilts, grasp position, depth
  bool flat = false;         // constant over the attempt
};

/// The trace with a range that holds both; an end that is less than a hundredth of the other is zero, as its number would say "3E-05".
Trace on_one_scale(const Trace& trace, const Trace& other);

struct Moment {
  double time_s = 0;
  QString what, means;
  bool by_person = false, technical = false;
  QString id = {};  // of the event; "" for a person's note
  QString as_kept = {}, doc = {};  // the event's id and meaning as recorded, untranslated
  bool by_lesson = false;
};

struct MetricLine {
  std::string id;
  QString name, value, doc;  // doc: description and, if the lesson has it, formula
  int32_t better = SWAGE_BETTER_NONE;
  bool points = false;  // points deducted, of the score's 100: not a measurement
  double number = 0;    // the value in SI
  QString unit;         // that of quantity_text()
  MetricTarget target;  // what the lesson asks, SI; none where it asks nothing
  QString asked;        // the words for it
};

struct Review {
  record::AttemptRow attempt;
  QVector<Trace> traces;  // wanted ones first
  QVector<Moment> moments;
  QVector<MetricLine> metrics;
  QVector<RatingLine> ratings;  // computed scores on the scales of surgeons
  QVector<RatedScale> scales;   // the same scales with all items and the instructor's points
  double dt_s = 1e-3, length_s = 0;
  uint64_t seed = 0;  // targets and tremor were drawn from it

  QString why;               // reason for the outcome, in the lesson's words; "" where it has none
  QString hand;              // "Recorded hand: novice" for an attempt without a person; else ""
  QString title() const;     // "Basic grasp · Recorded hand: novice · Arun P."
  QString facts() const;     // "✓ Passed, 87 of 100 · 21 Nov 2026 10:30 · Practice · seed 7"
  QString headline() const;  // title and facts without the verdict, on one line
  const MetricLine* metric(const std::string& id) const;  // nullptr when the attempt has no such metric
  QString verdict() const;   // "✓ Passed, 87 of 100"
};

/// `card`: of the replayed scene, if available, whose lesson's card has direction and formula of the metrics.
/// `given`: an instructor's points by item of a scale.
Review make_review(const record::AttemptRow& attempt, const record::Recording& recording,
                   const std::vector<record::EventRow>& events, const snapshot::SceneCard* card = nullptr,
                   const std::vector<std::pair<std::string, double>>& given = {});

/// Value of a trace at a recorded step, in the display unit.
double value_at(const Trace& trace, const record::Recording& recording, size_t step);

/// One line per step: time in s and every signal in SI, with units in the headings. The decimal sign is a point.
std::string signals_csv(const record::Recording& recording);
/// Long form: kind, time or value, unit, text; first the facts of the attempt, then metrics, ratings, events.
std::string summary_csv(const Review& review);

}  // namespace swage::console
