// SPDX-License-Identifier: Apache-2.0
//
// Metrics and cues of the lesson of passing: the one table behind its declarations, `swage describe` and pass.md.
#pragma once

#include <cstddef>

#include "common/card.hpp"

namespace swage::lesson_pass {

/// Order of kMetrics.
enum class Measure : size_t {
  kTime,
  kSuccess,
  kPasses,
  kShared,
  kPlaceError,
  kSnatches,
  kDrops,
  kForce,
  kPeak,
  kOverTime,
  kBending,
  kPath,
  kSparc,
  kLdlj,
  kHold,
  kPointsDrops,
  kPointsSnatches,
  kPointsForce,
  kPointsBending,
  kPointsTime,
  kCount
};

// clang-format off
inline constexpr swage_metric_info kMetrics[] = {
    lessons::kTaskTime,
    lessons::kTaskSuccess,
    {"pass.count", "1", "How often the needle was passed from one gripper to the other.", "count of: held by both for share_time at the place, then by the other alone", "", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_D},
    {"pass.shared", "s", "Mean time for which both held the needle in a pass.", "sum over passes of the time held by both / passes", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"pass.place_error", "m", "Mean distance of the needle from the place while both held it.", "mean of the distance of its nearest place", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"pass.snatches", "1", "How often the other gripper had the needle without a pass.", "count of: changed hands, but not held by both for share_time at the place", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    lessons::kDrops,
    lessons::kForceMean,
    lessons::kForcePeak,
    {"force.over_time", "1", "Share of the held time in which a gripper was above the limit.", "sum of dt with F > force.high / held time", "M18", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"needle.bending", "1", "Greatest bending moment in the needle over the moment at which it yields.", "max of the needle's signal needle.stress", "M21", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    lessons::kPathOfBoth,
    lessons::kSparc,
    lessons::kLdlj,
    {"hold.progress", "1", "Share of the last hold that is done.", "unbroken hold / hold_time", "", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_NONE},
    lessons::points("points.drops", "Points lost for drops and resets of the needle.", "15 (drops + resets)"),
    lessons::points("points.snatches", "Points lost for a needle that changed hands without a pass.", "10 min(snatches, 3)"),
    lessons::points("points.force", "Points lost for gripping too hard.", "40 share of the held time above force.high"),
    lessons::kPointsBending,
    lessons::kPointsTime,
};
static_assert(sizeof kMetrics / sizeof kMetrics[0] == static_cast<size_t>(Measure::kCount));

inline constexpr swage_metric_label kLabels[] = {
    lessons::kTaskTimeLabel,
    lessons::kTaskSuccessLabel,
    lessons::label("pass.count", "Passes", SWAGE_SHOW_COUNT, 2, "passes", nullptr),
    lessons::label("pass.shared", "Time held by both", SWAGE_SHOW_QUANTITY, 3),
    lessons::label("pass.place_error", "Distance from the place"),
    lessons::label("pass.snatches", "Changes of hand without a pass", SWAGE_SHOW_COUNT, 4),
    lessons::kDropsLabel,
    lessons::kForceMeanLabel,
    lessons::label("force.peak", "Grip force, peak", SWAGE_SHOW_QUANTITY, 5, nullptr, "force"),
    lessons::label("force.over_time", "Time above the force limit", SWAGE_SHOW_SHARE),
    lessons::label("needle.bending", "Needle bending (% of yield)", SWAGE_SHOW_SHARE),
    lessons::kPathLabel,
    lessons::kSparcLabel,
    lessons::kLdljLabel,
    lessons::label("hold.progress", "Hold completed", SWAGE_SHOW_SHARE),
    lessons::label("points.drops", "Drops and resets", SWAGE_SHOW_POINTS),
    lessons::label("points.snatches", "Changes of hand without a pass", SWAGE_SHOW_POINTS),
    lessons::kPointsForceLabel,
    lessons::kPointsBendingLabel,
    lessons::kPointsTimeLabel,
};

inline constexpr swage_criterion kCriteria[] = {
    {"Take the needle with one gripper and bring it to within {place_radius} of the place.", nullptr, SWAGE_CRITERION_PASS, 0},
    {"Take it there with the other, hold it with both for {share_time}, then let go with the first: {passes} times.", nullptr, SWAGE_CRITERION_PASS, 0},
    {"Hold it with the last one alone for {hold_time} with {force}.", nullptr, SWAGE_CRITERION_PASS, 0},
    lessons::kMaxOverTime,
    lessons::kMaxDrops,
    lessons::kMaxTime,
    lessons::kParTime,
    {"Drops, snatching and gripping too hard cost points; with a needle that bends also bending it.", nullptr, SWAGE_CRITERION_POINTS, 0},
};

/// Order of kCues.
enum class Sign : size_t { kHeld, kBoth, kTooHard, kNear, kDone, kCount };

inline constexpr swage_cue_info kCues[] = {
    {"thing.held", "Held by one gripper.", lessons::kHeard, 0},
    {"grasp.good", "Held by both for long enough: the first may let go.", lessons::kHeard, 0},
    lessons::kTooHard,
    {"target.near", "The needle is at the place where it is passed.", lessons::kHeard, 0},
    {"target.done", "All passes are done.", lessons::kHeard, 0},
};
// clang-format on
static_assert(sizeof kCues / sizeof kCues[0] == static_cast<size_t>(Sign::kCount));

}  // namespace swage::lesson_pass
