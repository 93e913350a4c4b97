// SPDX-License-Identifier: Apache-2.0
//
// Metrics and cues of the pull test: the one table behind its declarations, `swage describe` and pull.md.
#pragma once

#include "common/card.hpp"

namespace swage::lesson_pull {

/// Order of kMetrics.
enum class Measure : size_t { kSuccess, kBears, kSlip, kOpens, kCount };

// clang-format off
inline constexpr swage_metric_info kMetrics[] = {
    lessons::kTaskSuccess,
    {"pull.bears", "N", "Greatest tension that the loop has borne.", "max of the mean tension of both strands beside the pin", "", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_D},
    {"pull.slip", "m", "Thread that has gone through the knot into its loop, from both sides together.", "max of the thread of the loop, over that at the preload", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"pull.opens", "m", "By how much the loop has opened, its stretch and straightened bends included.", "2 (way of the pin since the preload)", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
};

inline constexpr swage_metric_label kLabels[] = {
    lessons::kTaskSuccessLabel,
    lessons::label("pull.bears", "Tension borne", SWAGE_SHOW_QUANTITY, 1, "load"),
    lessons::label("pull.slip", "Slip", SWAGE_SHOW_QUANTITY, 2, nullptr, "most_slip"),
    lessons::label("pull.opens", "Opening", SWAGE_SHOW_QUANTITY, 3, nullptr, "most_opening"),
};

inline constexpr swage_criterion kCriteria[] = {
    {"The knot is to bear {load}.", nullptr, SWAGE_CRITERION_PASS, 0},
    {"A knot that slips by more than {most_slip} has given way, and one whose loop opens by more than {most_opening}.", nullptr, SWAGE_CRITERION_LIMIT, 0},
    lessons::kMaxTime,
};

/// Order of kCues.
enum class Sign : size_t { kHolds, kGivesWay, kCount };

inline constexpr swage_cue_info kCues[] = {
    {"knot.holds", "The knot bears the load.", lessons::kHeard, 0},
    {"knot.gives_way", "The knot has given way.", lessons::kHeard, 0},
};
// clang-format on
static_assert(sizeof kMetrics / sizeof kMetrics[0] == static_cast<size_t>(Measure::kCount));
static_assert(sizeof kCues / sizeof kCues[0] == static_cast<size_t>(Sign::kCount));

}  // namespace swage::lesson_pull
