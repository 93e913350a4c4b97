// SPDX-License-Identifier: Apache-2.0
//
// Metrics and cues of the lesson of the loop: the one table behind its declarations, `swage describe` and loop.md.
#pragma once

#include <cstddef>

#include "common/card.hpp"

namespace swage::lesson_loop {

/// Order of kMetrics.
enum class Measure : size_t {
  kTime,
  kSuccess,
  kTurns,
  kMostTurns,
  kSlips,
  kPlace,
  kTension,
  kTaut,
  kDrops,
  kForce,
  kPeak,
  kOverTime,
  kPath,
  kSparc,
  kLdlj,
  kHold,
  kPassages,
  kPointsSlips,
  kPointsDrops,
  kPointsTension,
  kPointsForce,
  kPointsTime,
  kCount
};

// clang-format off
inline constexpr swage_metric_info kMetrics[] = {
    lessons::kTaskTime,
    lessons::kTaskSuccess,
    {"loop.turns", "1", "Turns of the thread about the instrument, with their sign.", "winding.turns", "", SWAGE_BETTER_INSIDE, SWAGE_EVIDENCE_D},
    {"loop.most_turns", "1", "Most turns that the thread had about the instrument.", "max of abs(winding.turns)", "", SWAGE_BETTER_INSIDE, SWAGE_EVIDENCE_D},
    {"loop.slips", "1", "How often a whole turn slid off the instrument or was unwound.", "count of: whole turns fewer, while all that are asked for were there", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"loop.place", "m", "Mean distance of the turns behind the tips, while they lay on the instrument.", "mean of winding.behind", "", SWAGE_BETTER_INSIDE, SWAGE_EVIDENCE_D},
    {"tissue.pull_peak", "N", "Pull of the thread on the tissue that was exceeded for one two-hundredth of the held time.", "99.5 % quantile of thread.tension_first below 20 Hz while held", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"thread.taut", "1", "Share of the held time in which the thread pulled on the tissue harder than the limit.", "sum of dt with T > tension / held time", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"thread.drops", "1", "How often the thread got out of the jaws that held it.", "count of: not held any more", "M07", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    lessons::kForceMean,
    lessons::kForcePeak,
    {"force.over_time", "1", "Share of the held time in which the jaws were above the limit.", "sum of dt with F > force.high / held time", "M18", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    lessons::kPathOfBoth,
    lessons::kSparc,
    lessons::kLdlj,
    {"hold.progress", "1", "Share of the hold that is done.", "unbroken hold / hold_time", "", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_NONE},
    {"thread.passages", "1", "How often the simulated thread went through itself or through the instrument, which no thread does.", "thread.passed + winding.passages", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_NONE},
    lessons::points("points.slips", "Points lost for turns that slid off.", "10 min(slips, 3)"),
    lessons::points("points.drops", "Points lost for a thread that got out of the jaws.", "15 drops"),
    lessons::points("points.tension", "Points lost for pulling on the tissue too hard.", "40 share of the held time above the tension"),
    lessons::points("points.force", "Points lost for gripping too hard.", "40 share of the held time above force.high"),
    lessons::kPointsTime,
};
static_assert(sizeof kMetrics / sizeof kMetrics[0] == static_cast<size_t>(Measure::kCount));

inline constexpr swage_metric_label kLabels[] = {
    lessons::kTaskTimeLabel,
    lessons::kTaskSuccessLabel,
    lessons::label("loop.turns", "Turns at the end, signed"),
    lessons::label("loop.most_turns", "Turns about the instrument, a whole one from 0.75", SWAGE_SHOW_QUANTITY, 2),
    lessons::label("loop.slips", "Turns that slid off", SWAGE_SHOW_COUNT, 3),
    lessons::label("loop.place", "Distance of the turns behind the tips"),
    lessons::label("tissue.pull_peak", "Pull on the tissue, peak", SWAGE_SHOW_QUANTITY, 4, nullptr, "tension"),
    lessons::label("thread.taut", "Time above the limit of pull", SWAGE_SHOW_SHARE),
    lessons::label("thread.drops", "Thread lost from the jaws", SWAGE_SHOW_COUNT, 5, nullptr, "max_drops"),
    lessons::kForceMeanLabel,
    lessons::label("force.peak", "Grip force, peak", SWAGE_SHOW_QUANTITY, 0, nullptr, "force"),
    lessons::label("force.over_time", "Time above the force limit", SWAGE_SHOW_SHARE),
    lessons::kPathLabel,
    lessons::kSparcLabel,
    lessons::kLdljLabel,
    lessons::label("hold.progress", "Hold completed", SWAGE_SHOW_SHARE),
    lessons::label("thread.passages", "Thread through itself or the instrument", SWAGE_SHOW_COUNT),
    lessons::label("points.slips", "Turns that slid off", SWAGE_SHOW_POINTS),
    lessons::label("points.drops", "Thread lost from the jaws", SWAGE_SHOW_POINTS),
    lessons::label("points.tension", "Pull on the tissue", SWAGE_SHOW_POINTS),
    lessons::kPointsForceLabel,
    lessons::kPointsTimeLabel,
};

inline constexpr swage_criterion kCriteria[] = {
    {"Take the thread with one instrument and wind it about the tips of the other. Whole turns: {turns}.", nullptr, SWAGE_CRITERION_PASS, 0},
    {"Keep it drawn for {hold_time}: no turn less, none more, and at least {least_draw} on the instrument.", nullptr, SWAGE_CRITERION_PASS, 0},
    {"A thread that breaks ends the attempt; so does one that the simulation lets go through itself or the instrument.", nullptr, SWAGE_CRITERION_ENDS, 0},
    {"Losing the thread from the jaws more often than {max_drops} times ends the attempt.", nullptr, SWAGE_CRITERION_LIMIT, 0},
    lessons::kMaxOverTime,
    lessons::kMaxTime,
    lessons::kParTime,
    {"Turns that slide off, a lost thread, pulling above {tension} and gripping too hard cost points.", nullptr, SWAGE_CRITERION_POINTS, 0},
};

/// Order of kCues.
enum class Sign : size_t { kHeld, kTaut, kOn, kTooMany, kTooHard, kDone, kCount };

inline constexpr swage_cue_info kCues[] = {
    {"thing.held", "The thread is held.", lessons::kHeard, 0},
    {"thread.taut", "The thread pulls on the tissue too hard.", lessons::kFelt, 0},
    {"loop.on", "The turns that are asked for lie on the instrument: keep them drawn.", lessons::kHeard, 0},
    {"loop.too_many", "There are more turns than asked for.", lessons::kHeard, 0},
    lessons::kTooHard,
    {"target.done", "The turns have been kept for long enough.", lessons::kHeard, 0},
};
// clang-format on
static_assert(sizeof kCues / sizeof kCues[0] == static_cast<size_t>(Sign::kCount));

}  // namespace swage::lesson_loop
