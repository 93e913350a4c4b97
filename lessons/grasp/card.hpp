// SPDX-License-Identifier: Apache-2.0
//
// Metrics and cues of the grasp lesson: the one table behind its declarations, `swage describe` and grasp.md. Codes M..
// are those of the metric catalogue that the page names.
#pragma once

#include <cstddef>

#include "common/card.hpp"

namespace swage::lesson_grasp {

/// Order of kMetrics.
enum class Measure : size_t {
  kTime,
  kApproach,
  kCarry,
  kIdle,
  kSuccess,
  kTries,
  kDrops,
  kRegrasps,
  kResets,
  kSpotError,
  kInZone,
  kTipReach,
  kTiltAxis,
  kTiltPlane,
  kTilt,
  kBalance,
  kSnap,
  kForce,
  kPeak,
  kSteadiness,
  kOverTime,
  kOverDose,
  kSlipRisk,
  kBending,
  kPath,
  kSparc,
  kLdlj,
  kHold,
  kTremor,
  kHoldError,
  kInTarget,
  kHoldBreaks,
  kSettling,
  kPointsTries,
  kPointsDrops,
  kPointsHold,
  kPointsForce,
  kPointsTilt,
  kPointsBending,
  kPointsTime,
  kCount
};

// clang-format off
inline constexpr swage_metric_info kMetrics[] = {
    lessons::kTaskTime,
    {"time.approach", "s", "Time until the jaws first touched it, since the hand set off.", "first grasp.touched - start of time.task", "M02", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A},
    {"time.carry", "s", "Time in the phase carry.", "sum of dt in the phase", "M02", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A},
    {"time.idle", "1", "Share of the time at work, outside holds, in which the instrument did nothing.", "sum of dt in which the tips stay within 0.1 mm below 6 Hz, the opening within 1 deg and F within 0.05 N for more than 0.5 s / sum of dt, both outside holds and since the hand set off", "M03", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A},
    lessons::kTaskSuccess,
    {"grasp.tries", "1", "Closings of the jaws that touch the needle, up to the first correct grasp.", "count; reopened by 2 deg in between", "M06", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    lessons::kDrops,
    {"grasp.regrasps", "1", "Grasps after the first correct one.", "count", "M08", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"grasp.resets", "1", "How often the program put the needle back to its start.", "count of host.reset of the needle", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"grasp.spot_error", "1", "Mean distance from the region, share of the needle.", "mean over grasps of max(0, low - s, s - high)", "M09", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"grasp.in_zone", "1", "Share of grasps that were in the region.", "grasps with low <= s <= high / grasps", "M10", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_C},
    lessons::kTipReach,
    {"grasp.tilt_axis", "rad", "Mean tilt of the needle from perpendicular to the jaw axis while held.", "mean of abs(asin(tangent . x_T))", "M12", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"grasp.tilt_plane", "rad", "Mean tilt of the needle's plane from perpendicular to the jaw faces while held.", "mean of abs(asin(normal . z_T))", "M12", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"grasp.tilt", "rad", "Mean of these two tilts, which costs points.", "(grasp.tilt_axis + grasp.tilt_plane) / 2", "M12", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"grasp.balance", "1", "Mean difference of the two jaw forces while held, over the greater one.", "mean of abs(left - right) / max(left, right)", "M13", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"grasp.snap", "rad", "Mean rotation of the needle from first contact to 0.1 s after the grasp.", "mean over grasps of the angle of q q0^-1", "M14", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    lessons::kForceMean,
    lessons::kForcePeak,
    {"force.steadiness", "N", "Spread of the grip force while it is lifted, carried and held.", "standard deviation of F below 20 Hz, held and more than 0.2 mm from the start", "M17", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"force.over_time", "1", "Share of the held time above the limit.", "sum of dt with F > force.high / held time", "M18", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"force.over_dose", "N*s", "Excess over the limit, summed over time.", "integral of max(0, F - force.high)", "M19", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"force.slip_risk", "1", "Share of that time with less than the least force.", "sum of dt with F < force.low / sum of dt, both held and more than 0.2 mm from the start", "M20", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    lessons::kBending,
    lessons::kPath,
    lessons::kSparc,
    lessons::kLdlj,
    {"hold.progress", "1", "Share of the hold that is done.", "unbroken hold / hold_time", "", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_NONE},
    {"hold.tremor", "m", "Shaking of the tips in the scene during the hold.", "root mean square of the tips between 8 and 12 Hz", "M30", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A},
    {"hold.error", "m", "Distance from the target during the hold.", "root mean square", "M32", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"hold.in_target", "1", "Share of the time since the target was first reached that was spent in it.", "time within the radius / time since the first entry", "M33", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_C},
    {"hold.breaks", "1", "How often the hold broke.", "count; out is a tenth of the radius further than in", "M34", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"hold.settling", "s", "Time from the first entry to the start of the last hold.", "start of the hold - first entry", "M35", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    lessons::points("points.tries", "Points lost for grasp attempts after the first.", "8 clamp(tries - 1, 0, 5)"),
    lessons::points("points.drops", "Points lost for drops and resets of the needle.", "15 (drops + resets)"),
    lessons::points("points.hold", "Points lost for interrupted holds at the target.", "5 min(breaks, 3)"),
    lessons::points("points.force", "Points lost for gripping too hard.", "40 share of the held time above force.high"),
    lessons::points("points.tilt", "Points lost for a needle that is tilted in the jaws.", "20 clamp(mean tilt / 45 deg, 0, 1)"),
    lessons::kPointsBending,
    lessons::kPointsTime,
};
static_assert(sizeof kMetrics / sizeof kMetrics[0] == static_cast<size_t>(Measure::kCount));

/// Titles of the metrics, and the order in which the first ones are shown.
inline constexpr swage_metric_label kLabels[] = {
    lessons::kTaskTimeLabel,
    lessons::label("time.approach", "Time to first contact"),
    lessons::label("time.carry", "Carrying time"),
    lessons::label("time.idle", "Idle time", SWAGE_SHOW_SHARE),
    lessons::kTaskSuccessLabel,
    lessons::label("grasp.tries", "Grasp attempts", SWAGE_SHOW_COUNT, 2),
    lessons::kDropsLabel,
    lessons::label("grasp.regrasps", "Regrasps", SWAGE_SHOW_COUNT),
    lessons::label("grasp.resets", "Resets", SWAGE_SHOW_COUNT),
    lessons::label("grasp.spot_error", "Grasp position error", SWAGE_SHOW_SHARE, 3),
    lessons::label("grasp.in_zone", "Grasps in the region", SWAGE_SHOW_SHARE),
    lessons::label("grasp.tip_reach", "Tip overhang", SWAGE_SHOW_QUANTITY, 0, "tip_zone", "tip_zone"),
    lessons::label("grasp.tilt_axis", "Tilt to the jaw axis"),
    lessons::label("grasp.tilt_plane", "Tilt to the jaw plane"),
    lessons::label("grasp.tilt", "Tilt in the jaws", SWAGE_SHOW_QUANTITY, 5, nullptr, "max_tilt"),
    lessons::label("grasp.balance", "Jaw force imbalance", SWAGE_SHOW_SHARE),
    lessons::label("grasp.snap", "Rotation on grasping"),
    lessons::kForceMeanLabel,
    lessons::label("force.peak", "Grip force, peak", SWAGE_SHOW_QUANTITY, 4, nullptr, "force"),
    lessons::label("force.steadiness", "Grip force variability"),
    lessons::label("force.over_time", "Time above the force limit", SWAGE_SHOW_SHARE),
    lessons::label("force.over_dose", "Cumulative excess force"),
    lessons::label("force.slip_risk", "Time below the least force", SWAGE_SHOW_SHARE),
    lessons::label("needle.bending", "Needle bending (% of yield)", SWAGE_SHOW_SHARE),
    lessons::kPathLabel,
    lessons::kSparcLabel,
    lessons::kLdljLabel,
    lessons::label("hold.progress", "Hold completed", SWAGE_SHOW_SHARE),
    lessons::label("hold.tremor", "Tremor during the hold"),
    lessons::label("hold.error", "Hold position error"),
    lessons::label("hold.in_target", "Time in the target", SWAGE_SHOW_SHARE),
    lessons::label("hold.breaks", "Interrupted holds", SWAGE_SHOW_COUNT),
    lessons::label("hold.settling", "Settling time"),
    lessons::label("points.tries", "Grasp attempts", SWAGE_SHOW_POINTS),
    lessons::label("points.drops", "Drops and resets", SWAGE_SHOW_POINTS),
    lessons::label("points.hold", "Interrupted holds", SWAGE_SHOW_POINTS),
    lessons::kPointsForceLabel,
    lessons::label("points.tilt", "Tilt", SWAGE_SHOW_POINTS),
    lessons::kPointsBendingLabel,
    lessons::kPointsTimeLabel,
};

/// Requirements on the trainee.
inline constexpr swage_criterion kCriteria[] = {
    {"Grasp the {needle} in the marked region, at {region} of its length.", nullptr, SWAGE_CRITERION_PASS, 0},
    {"Use the tips of the jaws.", "tips_needed", SWAGE_CRITERION_PASS, 0},
    {"Hold it perpendicular to the jaws both ways, to within {max_tilt}.", "max_tilt", SWAGE_CRITERION_PASS, 0},
    {"Lift it by {lift}.", "lift", SWAGE_CRITERION_PASS, 0},
    {"Carry it to within {target_radius} of the target.", "carry", SWAGE_CRITERION_PASS, 0},
    {"Hold it for {hold_time} with {force}.", nullptr, SWAGE_CRITERION_PASS, 0},
    {"Leaving the target during the hold ends the attempt.", "leave=fail", SWAGE_CRITERION_LIMIT, 0},
    lessons::kMaxOverTime,
    {"Holding it outside the region for {max_wrong_time} ends the attempt.", "max_wrong_time", SWAGE_CRITERION_LIMIT, 0},
    lessons::kMaxDrops,
    lessons::kMaxTime,
    lessons::kParTime,
    {"Further grasp attempts, drops, gripping too hard and a tilt in the jaws cost points; with a needle also bending it.", nullptr, SWAGE_CRITERION_POINTS, 0},
};

using lessons::kHeard;

/// Order of kCues; the first ones are those of a grade.
enum class Sign : size_t { kWrong, kTipsOnly, kPointOnly, kTilted, kGood, kTooHard, kNear, kDone, kCount };

inline constexpr swage_cue_info kCues[] = {
    lessons::kGraspWrong,
    lessons::kGraspTipsOnly,
    lessons::kGraspPointOnly,
    {"grasp.tilted", "Held at the right place and with the tips, but not perpendicular to the jaws.", kHeard, 0},
    lessons::kGraspGood,
    lessons::kTooHard,
    {"target.near", "The needle is at the target; the hold runs.", kHeard, 0},
    {"target.done", "The hold at the target is done.", kHeard, 0},
};
// clang-format on
static_assert(sizeof kCues / sizeof kCues[0] == static_cast<size_t>(Sign::kCount));

}  // namespace swage::lesson_grasp
