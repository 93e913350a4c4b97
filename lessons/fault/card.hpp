// SPDX-License-Identifier: Apache-2.0
//
// Metrics and cues of the lesson of faulty knots: the one table behind its declarations, `swage describe` and fault.md.
#pragma once

#include <cstddef>

#include "common/card.hpp"

namespace swage::lesson_fault {

/// Order of kMetrics; those of pulled knots in the order of Knot.
enum class Measure : size_t {
  kTime,
  kSuccess,
  kRight,
  kFalseAlarms,
  kMissed,
  kAnswers,
  kAnswerTime,
  kPath,
  kSquareBears,
  kGrannyBears,
  kSlidingBears,
  kLooseBears,
  kSquareOpens,
  kGrannyOpens,
  kSlidingOpens,
  kLooseOpens,
  kPointsWrong,
  kPointsMissed,
  kPointsTime,
  kCount
};

// clang-format off
inline constexpr swage_metric_info kMetrics[] = {
    lessons::kTaskTime,
    lessons::kTaskSuccess,
    {"fault.right", "1", "Right answers.", "count", "", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_D},
    {"fault.false_alarms", "1", "Sound knots that were called faulty.", "count", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"fault.missed", "1", "Faulty knots that were called sound.", "count", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"fault.answers", "1", "Answers given.", "count", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    {"time.answer", "s", "Mean time from the question to the answer.", "sum / answers", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    lessons::kPath,
    {"pull.square_bears", "N", "Most that the last square knot has borne.", "max of thread.tension while it was pulled", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    {"pull.granny_bears", "N", "Most that the last granny has borne.", "max of thread.tension while it was pulled", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    {"pull.sliding_bears", "N", "Most that the last sliding knot has borne.", "max of thread.tension while it was pulled", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    {"pull.loose_bears", "N", "Most that the last knot with a loose first throw has borne.", "max of thread.tension while it was pulled", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    {"pull.square_opens", "m", "By how much the loop of the last square knot has opened, its stretch included.", "2 (way of the instrument since the loop was taut)", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    {"pull.granny_opens", "m", "By how much the loop of the last granny has opened, its stretch included.", "2 (way of the instrument since the loop was taut)", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    {"pull.sliding_opens", "m", "By how much the loop of the last sliding knot has opened, its stretch included.", "2 (way of the instrument since the loop was taut)", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    {"pull.loose_opens", "m", "By how much the loop of the last knot with a loose first throw has opened, its stretch included.", "2 (way of the instrument since the loop was taut)", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    lessons::points("points.wrong", "Points lost for false alarms and wrong names.", "15 (answers - right - missed)"),
    lessons::points("points.missed", "Points lost for faulty knots that were called sound.", "25 missed"),
    lessons::kPointsTime,
};
static_assert(sizeof kMetrics / sizeof kMetrics[0] == static_cast<size_t>(Measure::kCount));

inline constexpr swage_metric_label kLabels[] = {
    lessons::label("time.task", "Active time", SWAGE_SHOW_QUANTITY, 5, nullptr, "par_time"),
    lessons::kTaskSuccessLabel,
    lessons::label("fault.right", "Right answers", SWAGE_SHOW_COUNT, 1, "least_right"),
    lessons::label("fault.false_alarms", "False alarms", SWAGE_SHOW_COUNT, 2),
    lessons::label("fault.missed", "Missed faults", SWAGE_SHOW_COUNT, 3),
    lessons::label("fault.answers", "Answers given", SWAGE_SHOW_COUNT),
    lessons::label("time.answer", "Time to answer, mean", SWAGE_SHOW_QUANTITY, 4),
    lessons::kPathLabel,
    lessons::label("pull.square_bears", "Borne by the square knot"),
    lessons::label("pull.granny_bears", "Borne by the granny"),
    lessons::label("pull.sliding_bears", "Borne by the sliding knot"),
    lessons::label("pull.loose_bears", "Borne by the loose throw"),
    lessons::label("pull.square_opens", "Opening of the square knot"),
    lessons::label("pull.granny_opens", "Opening of the granny"),
    lessons::label("pull.sliding_opens", "Opening of the sliding knot"),
    lessons::label("pull.loose_opens", "Opening of the loose throw"),
    lessons::label("points.wrong", "Wrong answers", SWAGE_SHOW_POINTS),
    lessons::label("points.missed", "Missed faults", SWAGE_SHOW_POINTS),
    lessons::kPointsTimeLabel,
};

/// Requirements on the trainee.
inline constexpr swage_criterion kCriteria[] = {
    {"Name at least {least_right} of the knots right.", nullptr, SWAGE_CRITERION_PASS, 0},
    lessons::kMaxTime,
    lessons::kParTime,
    {"A faulty knot that is called sound costs most; false alarms and wrong names cost points.", nullptr, SWAGE_CRITERION_POINTS, 0},
};

/// Order of kCues.
enum class Sign : size_t { kRight, kWrong, kHolds, kGivesWay, kCount };

inline constexpr swage_cue_info kCues[] = {
    {"answer.right", "The answer was right.", lessons::kHeard, 0},
    {"knot.misjudged", "It is another knot.", lessons::kHeard, 0},
    {"knot.holds", "The knot bears the load.", lessons::kHeard, 0},
    {"knot.gives_way", "The knot has given way.", lessons::kHeard, 0},
};
// clang-format on
static_assert(sizeof kCues / sizeof kCues[0] == static_cast<size_t>(Sign::kCount));

}  // namespace swage::lesson_fault
