// SPDX-License-Identifier: Apache-2.0
//
// Metrics and cues of the angle lesson: the one table behind its declarations, `swage describe` and angles.md.
#pragma once

#include <cstddef>

#include "common/card.hpp"

namespace swage::lesson_angles {

/// Order of kMetrics.
enum class Measure : size_t {
  kTime,
  kSuccess,
  kBiasSide,
  kBiasDepth,
  kJndSide,
  kJndDepth,
  kRight,
  kAnswers,
  kAnswerTime,
  kStereo,
  kPath,
  kPointsBias,
  kPointsJnd,
  kPointsTime,
  kCount
};

// clang-format off
inline constexpr swage_metric_info kMetrics[] = {
    lessons::kTaskTime,
    lessons::kTaskSuccess,
    {"angle.bias_side", "rad", "Signed error in judging a tilt across the line of sight: seen minus real, positive to the right. 0 at best.", "of the curve Phi((lean + bias) / spread) through all answers", "M60", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_D},
    {"angle.bias_depth", "rad", "The same along the line of sight, positive away from the viewer. 0 at best.", "of the curve Phi((lean + bias) / spread) through all answers", "M60", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_D},
    {"angle.jnd_side", "rad", "Just-noticeable difference across the line of sight.", "0.674 spread: told right in 75 % of the answers but for the bias", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"angle.jnd_depth", "rad", "The same along the line of sight.", "0.674 spread: told right in 75 % of the answers but for the bias", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"angle.right", "1", "Share of right answers; the staircases hold it near 71 %.", "right answers / answers", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    {"angle.answers", "1", "Answers given.", "count", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    {"time.answer", "s", "Mean time from the question to the answer.", "sum / answers", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"view.stereo", "1", "1 when the view had stereo: compare only within one of the two.", "display of the host, else parameter stereo", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    lessons::kPath,
    lessons::points("points.bias", "Points lost for the bias of judging.", "35 mean over the axes of the share of max_bias"),
    lessons::points("points.jnd", "Points lost for the just-noticeable difference.", "35 mean over the axes of the share of max_jnd"),
    lessons::kPointsTime,
};
static_assert(sizeof kMetrics / sizeof kMetrics[0] == static_cast<size_t>(Measure::kCount));

/// Titles of the metrics, and the order in which the first ones are shown.
inline constexpr swage_metric_label kLabels[] = {
    lessons::label("time.task", "Active time", SWAGE_SHOW_QUANTITY, 5, nullptr, "par_time"),
    lessons::kTaskSuccessLabel,
    lessons::label("angle.bias_side", "Bias, sideways", SWAGE_SHOW_QUANTITY, 1, nullptr, "max_bias"),
    lessons::label("angle.bias_depth", "Bias, in depth", SWAGE_SHOW_QUANTITY, 2, nullptr, "max_bias"),
    lessons::label("angle.jnd_side", "Just-noticeable difference, sideways", SWAGE_SHOW_QUANTITY, 3, nullptr, "max_jnd"),
    lessons::label("angle.jnd_depth", "Just-noticeable difference, in depth", SWAGE_SHOW_QUANTITY, 4, nullptr, "max_jnd"),
    lessons::label("angle.right", "Correct answers", SWAGE_SHOW_SHARE),
    lessons::label("angle.answers", "Answers given", SWAGE_SHOW_COUNT),
    lessons::label("time.answer", "Time to answer, mean"),
    lessons::label("view.stereo", "Seen in stereo", SWAGE_SHOW_YES_NO),
    lessons::kPathLabel,
    lessons::label("points.bias", "Bias", SWAGE_SHOW_POINTS),
    lessons::label("points.jnd", "Just-noticeable difference", SWAGE_SHOW_POINTS),
    lessons::kPointsTimeLabel,
};

/// Requirements on the trainee.
inline constexpr swage_criterion kCriteria[] = {
    {"Answer {questions} questions.", nullptr, SWAGE_CRITERION_PASS, 0},
    {"Be off by at most {max_bias} on either axis.", nullptr, SWAGE_CRITERION_PASS, 0},
    {"Tell a tilt of {max_jnd} on either axis.", nullptr, SWAGE_CRITERION_PASS, 0},
    lessons::kMaxTime,
    lessons::kParTime,
};

/// Order of kCues.
enum class Sign : size_t { kRight, kWrong, kCount };

inline constexpr swage_cue_info kCues[] = {
    {"answer.right", "The answer was right.", lessons::kHeard, 0},
    {"answer.wrong", "It tilts to the other side.", lessons::kHeard, 0},
};
// clang-format on
static_assert(sizeof kCues / sizeof kCues[0] == static_cast<size_t>(Sign::kCount));

}  // namespace swage::lesson_angles
