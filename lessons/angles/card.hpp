// SPDX-License-Identifier: Apache-2.0
//
// What the angle lesson measures and signals: the one table behind its declarations, `swage describe` and angles.md.
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
  kCount
};

// clang-format off
inline constexpr swage_metric_info kMetrics[] = {
    lessons::kTaskTime,
    lessons::kTaskSuccess,
    {"angle.bias_side", "rad", "Signed error of judging a lean across the line of sight: seen minus real, positive to the right. 0 at best.", "of the curve Phi((lean + bias) / spread) through all answers", "M60", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_D},
    {"angle.bias_depth", "rad", "The same along the line of sight, positive away from the viewer. 0 at best.", "of the curve Phi((lean + bias) / spread) through all answers", "M60", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_D},
    {"angle.jnd_side", "rad", "Just noticeable difference across the line of sight.", "0.674 spread: told right in 75 % of the answers but for the bias", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"angle.jnd_depth", "rad", "The same along the line of sight.", "0.674 spread: told right in 75 % of the answers but for the bias", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"angle.right", "1", "Share of right answers; the staircases hold it near 71 %.", "right answers / answers", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    {"angle.answers", "1", "Answers given.", "count", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    {"time.answer", "s", "Mean time from the question to the answer.", "sum / answers", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"view.stereo", "1", "1 when the view had stereo, as the lesson says: compare only within one of the two.", "parameter stereo", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_NONE},
    lessons::kPath,
};
static_assert(sizeof kMetrics / sizeof kMetrics[0] == static_cast<size_t>(Measure::kCount));

/// Order of kCues.
enum class Sign : size_t { kRight, kWrong, kCount };

inline constexpr swage_cue_info kCues[] = {
    {"answer.right", "The answer was right.", lessons::kHeard, 0},
    {"answer.wrong", "It leans to the other side.", lessons::kHeard, 0},
};
// clang-format on
static_assert(sizeof kCues / sizeof kCues[0] == static_cast<size_t>(Sign::kCount));

}  // namespace swage::lesson_angles
