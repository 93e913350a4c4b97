// SPDX-License-Identifier: Apache-2.0
//
// What the grasp lesson measures and signals: the one table behind its declarations, `swage describe` and grasp.md. Codes M..
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
  kHold,
  kTremor,
  kHoldError,
  kInTarget,
  kHoldBreaks,
  kSettling,
  kCount
};

// clang-format off
inline constexpr swage_metric_info kMetrics[] = {
    lessons::kTaskTime,
    {"time.approach", "s", "Time in the phase approach.", "sum of dt in the phase", "M02", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A},
    {"time.carry", "s", "Time in the phase carry.", "sum of dt in the phase", "M02", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A},
    {"time.idle", "1", "Share of the time outside holds in which the tips rested.", "sum of dt slower than 1 mm/s for more than 0.5 s / sum of dt, both outside holds", "M03", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A},
    lessons::kTaskSuccess,
    {"grasp.tries", "1", "Closings of the jaws that touch, up to the first correct grasp.", "count; reopened by 2 deg in between", "M06", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    lessons::kDrops,
    {"grasp.regrasps", "1", "Grasps after the first correct one.", "count", "M08", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"grasp.resets", "1", "How often the needle was brought back by hand of the program.", "count of host.reset of the needle", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"grasp.spot_error", "1", "Mean distance from the region, share of the needle.", "mean over grasps of max(0, low - s, s - high)", "M09", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"grasp.in_zone", "1", "Share of grasps that were in the region.", "grasps with low <= s <= high / grasps", "M10", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_C},
    {"grasp.tip_reach", "m", "Mean reach of the tips past the needle while held.", "mean of (tips - place) . x_T", "M11", SWAGE_BETTER_INSIDE, SWAGE_EVIDENCE_C},
    {"grasp.tilt_axis", "rad", "Mean lean of the needle against the jaw axis while held.", "mean of abs(asin(tangent . x_T))", "M12", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"grasp.tilt_plane", "rad", "Mean lean of its plane against the jaw faces while held.", "mean of abs(asin(normal . z_T))", "M12", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"grasp.balance", "1", "Mean difference of the jaws while held, share of the harder one.", "mean of abs(left - right) / max(left, right)", "M13", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"grasp.snap", "rad", "Mean turn of the needle from the touch to 0.1 s after the grasp.", "mean over grasps of the angle of q q0^-1", "M14", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    lessons::kForceMean,
    lessons::kForcePeak,
    {"force.steadiness", "N", "Spread of the grip force while carried.", "standard deviation of F below 20 Hz; carried: held, and more than 0.2 mm from the start", "M17", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"force.over_time", "1", "Share of the held time above the limit.", "sum of dt with F > force.high / held time", "M18", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"force.over_dose", "N*s", "Excess over the limit, summed over time.", "integral of max(0, F - force.high)", "M19", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"force.slip_risk", "1", "Share of the time carried with less than the least force.", "sum of dt with F < force.low / time carried", "M20", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"needle.bending", "1", "Greatest bending moment in the needle over the moment at which it yields.", "max of the needle's signal needle.stress", "M21", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    lessons::kPath,
    {"hold.progress", "1", "Share of the hold that is done.", "unbroken hold / hold_time", "", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_NONE},
    {"hold.tremor", "m", "Shaking of the tips in the scene during the hold.", "root mean square of the tips between 8 and 12 Hz", "M30", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A},
    {"hold.error", "m", "Distance from the target during the hold.", "root mean square", "M32", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"hold.in_target", "1", "Share of the time since the target was first reached that was spent in it.", "time within the radius / time since the first entry", "M33", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_C},
    {"hold.breaks", "1", "How often the hold broke.", "count; out is a tenth of the radius further than in", "M34", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"hold.settling", "s", "Time from the first entry to the start of the last hold.", "start of the hold - first entry", "M35", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
};
static_assert(sizeof kMetrics / sizeof kMetrics[0] == static_cast<size_t>(Measure::kCount));

using lessons::kHeard;

/// Order of kCues; the first five are those of a grade.
enum class Sign : size_t { kWrong, kTipsOnly, kPointOnly, kGood, kTooHard, kNear, kDone, kCount };

inline constexpr swage_cue_info kCues[] = {
    {"grasp.wrong", "Held at the wrong place, and not with the tips.", kHeard, 0},
    {"grasp.tips_only", "Held with the tips, but at the wrong place.", kHeard, 0},
    {"grasp.point_only", "Held at the right place, but not with the tips.", kHeard, 0},
    {"grasp.good", "Held at the right place and with the tips.", kHeard, 0},
    lessons::kTooHard,
    {"target.near", "The needle is at the target; the hold runs.", kHeard, 0},
    {"target.done", "The hold at the target is done.", kHeard, 0},
};
// clang-format on
static_assert(sizeof kCues / sizeof kCues[0] == static_cast<size_t>(Sign::kCount));

}  // namespace swage::lesson_grasp
