// SPDX-License-Identifier: Apache-2.0
//
// What the insertion lesson measures and signals: the one table behind its declarations, `swage describe` and insertion.md.
// Codes M.. are those of the metric catalogue that the page names.
#pragma once

#include <swage/abi/lesson_card.h>

#include <cstddef>

namespace swage::lesson_insertion {

/// Order of kMetrics.
enum class Measure : size_t {
  kTime,
  kSuccess,
  kDrops,
  kForce,
  kPeak,
  kPath,
  kEntries,
  kEntryDistance,
  kEntryAngle,
  kCosine,
  kAngle,
  kInAngle,
  kExitAngle,
  kDepth,
  kArc,
  kDeflections,
  kWound,
  kArea,
  kPull,
  kSwept,
  kProgress,
  kCount
};

// clang-format off
inline constexpr swage_metric_info kMetrics[] = {
    {"time.task", "s", "Time since the hand set off.", "now - first time that the tips were quicker than 2 mm/s for 0.1 s", "M01", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A},
    {"task.success", "1", "1 when the attempt was passed.", "1 or 0", "M04", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_C},
    {"grasp.drops", "1", "How often the needle was dropped outside the tissue.", "count of: free and further than drop_distance from where it was left", "M07", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"force.mean", "N", "Mean grip force while held.", "mean of F below 20 Hz", "M15", SWAGE_BETTER_INSIDE, SWAGE_EVIDENCE_C},
    {"force.peak", "N", "Greatest grip force while held.", "max of F below 20 Hz", "M16", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"motion.path", "m", "Way of the tips.", "sum of |dx| below 6 Hz", "M22", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A},
    {"insert.entries", "1", "How often the point went in.", "count of pierce.entered", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"insert.entry_distance", "m", "Distance of the last entry from the mark, along the surface.", "length of e - e.n n, e = entry - mark", "M36", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"insert.entry_angle", "rad", "Angle to the inward normal at the last entry.", "acos(t . n)", "M37", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"insert.cosine", "1", "The thesis's cosine of the penetration angle, mean over time: 0 perfect, 1 worst.", "mean of sqrt(1 - (t . n)^2)", "M38", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"insert.angle", "rad", "Angle to the inward normal while in the tissue, by way.", "sqrt(integral of angle^2 dl / l), l: way of the needle through its entry", "M39", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"insert.in_angle", "1", "Share of that way within in_angle.", "way with angle <= in_angle / way", "M40", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_C},
    {"insert.exit_angle", "rad", "Angle to the outward normal at the exit.", "acos(t . n)", "M41", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"insert.depth", "m", "The deepest that the point has been below the surface.", "max of -height", "M46", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_B},
    {"insert.arc_error", "m", "Distance of the entry from the needle's own curve, by way: 0 when it is turned about its centre.", "sqrt(integral of d^2 dl / l)", "M47", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"insert.deflections", "1", "Entries refused because of the angle.", "count of pierce.deflected", "M48", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"wound.size", "1", "Wound size of the thesis: 1 (100 %) is perfect.", "greatest distance of the wound's edge from the first puncture / radius of the wire", "M49", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"wound.area", "1", "Torn area over the needle's section: 1 is perfect.", "area / (pi d^2/4)", "M50", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"tissue.pull", "N*s", "Pull on the tissue along its surface, summed over time. Compare only within one tissue.", "integral of the length of f - f.n n", "M51", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"tissue.swept", "m2", "Area swept sideways inside the tissue.", "sum over steps", "M53", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"insert.progress", "1", "Greatest share of the needle that was inside, of what is asked.", "max of s / drive", "", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_NONE},
};
static_assert(sizeof kMetrics / sizeof kMetrics[0] == static_cast<size_t>(Measure::kCount));

inline constexpr uint32_t kHeard = SWAGE_CHANNEL_COLOUR | SWAGE_CHANNEL_SHAPE | SWAGE_CHANNEL_SOUND;
inline constexpr uint32_t kFelt = kHeard | SWAGE_CHANNEL_FORCE;

/// Order of kCues.
enum class Sign : size_t { kNear, kAngleGood, kAngleOff, kStuck, kTorn, kTooHard, kDone, kCount };

inline constexpr swage_cue_info kCues[] = {
    {"target.near", "The point is where it should go in.", kHeard, 0},
    {"insert.good", "In the tissue, within the angle.", kHeard, 0},
    {"insert.angle_off", "In the tissue, leaning more than the angle.", kFelt, 0},
    {"needle.stuck", "In the tissue, held by nobody.", kHeard, 0},
    {"tissue.tear", "The wound is larger than careful hands leave it.", kHeard, 0},
    {"grip.too_hard", "The grip force is above the limit.", kFelt, 0},
    {"target.done", "It went in here, and the task is done.", kHeard, 0},
};
// clang-format on
static_assert(sizeof kCues / sizeof kCues[0] == static_cast<size_t>(Sign::kCount));

}  // namespace swage::lesson_insertion
