// SPDX-License-Identifier: Apache-2.0
//
// What the insertion lesson measures and signals: the one table behind its declarations, `swage describe` and insertion.md.
// Codes M.. are those of the metric catalogue that the page names.
#pragma once

#include <cstddef>

#include "common/card.hpp"

namespace swage::lesson_insertion {

/// Order of kMetrics.
enum class Measure : size_t {
  kTime,
  kSuccess,
  kDrops,
  kForce,
  kPeak,
  kTipReach,
  kBending,
  kPath,
  kSparc,
  kLdlj,
  kEntries,
  kEntryDistance,
  kEntryAngle,
  kCosine,
  kAngle,
  kInAngle,
  kExitDistance,
  kExitAngle,
  kDepth,
  kArc,
  kDeflections,
  kWound,
  kArea,
  kPull,
  kSwept,
  kStray,
  kBiteIn,
  kBiteOut,
  kAsymmetry,
  kOblique,
  kUneven,
  kStitches,
  kProgress,
  kTension,
  kSwageGrasps,
  kThreadPull,
  kTail,
  kCut,
  kSawn,
  kPointsWound,
  kPointsAngle,
  kPointsEntry,
  kPointsBending,
  kPointsRefused,
  kPointsDrops,
  kPointsSuture,
  kPointsTime,
  kCount
};

// clang-format off
inline constexpr swage_metric_info kMetrics[] = {
    lessons::kTaskTime,
    lessons::kTaskSuccess,
    lessons::kDrops,
    lessons::kForceMean,
    lessons::kForcePeak,
    lessons::kTipReach,
    lessons::kBending,
    lessons::kPath,
    lessons::kSparc,
    lessons::kLdlj,
    {"insert.entries", "1", "How often the point went in.", "count of pierce.entered", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"insert.entry_distance", "m", "Distance of the last entry from the mark, along the surface.", "length of e - e.n n, e = entry - mark", "M36", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"insert.entry_angle", "rad", "Angle to the inward normal at the last entry.", "acos(t . n)", "M37", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"insert.cosine", "1", "The thesis's cosine of the penetration angle, mean over time: 0 perfect, 1 worst.", "mean of sqrt(1 - (t . n)^2)", "M38", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"insert.angle", "rad", "Angle to the inward normal while in the tissue, by way.", "sqrt(integral of angle^2 dl / l), l: way of the needle through its entry", "M39", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"insert.in_angle", "1", "Share of that way within in_angle.", "way with angle <= in_angle / way", "M40", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_C},
    {"insert.exit_distance", "m", "Distance of the last exit from its mark, along the surface; told where the lesson has such a mark.", "length of e - e.n n, e = exit - mark", "M41", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"insert.exit_angle", "rad", "Angle to the outward normal at the exit.", "acos(t . n)", "M41", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"insert.depth", "1", "The deepest that the point has been below the surface, over the thickness of the wall.", "max of -height / thickness where it went in", "M46", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_B},
    {"insert.arc_error", "m", "Distance of the entry from the needle's own curve, by way: 0 when it is turned about its centre.", "sqrt(integral of d^2 dl / l)", "M47", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"insert.deflections", "1", "Punctures that failed because of the angle.", "count of pierce.deflected", "M48", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"wound.size", "1", "Size of the entry wound about the first puncture: 1 (100 %) is perfect.", "greatest distance of the wound's edge from the first puncture / radius of the wire", "M49", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"wound.area", "1", "Torn area over the needle's section: 1 is perfect.", "area / (pi d^2/4)", "M50", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"tissue.pull", "N*s", "Pull on the tissue along its surface, summed over time. Compare only within one tissue.", "integral of the length of f - f.n n", "M51", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"tissue.swept", "m2", "Area swept sideways inside the tissue.", "sum over steps", "M53", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"tissue.stray", "1", "Touches of the tissue that are not part of the task.", "count of: any of the needle touches it further than the tolerance from the mark, or from where it went in and came out; a jaw gets into it; apart by 0.15 s", "M52", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"stitch.bite_in", "1", "Bite of the last entry: its distance from the edge, in needle diameters.", "edge(entry) / d", "M42", SWAGE_BETTER_INSIDE, SWAGE_EVIDENCE_A},
    {"stitch.bite_out", "1", "The same of the last exit.", "edge(exit) / d", "M42", SWAGE_BETTER_INSIDE, SWAGE_EVIDENCE_A},
    {"stitch.asymmetry", "1", "How unlike the two bites of the last stitch are.", "abs(b1 - b2) / mean(b1, b2)", "M43", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"stitch.obliquity", "rad", "Angle between the last stitch and the normal to the edge, along the surface.", "acos(abs(s . e) / length of s), s = exit - entry along the surface", "M44", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A},
    {"stitch.unevenness", "1", "How uneven the stitches lie along the edge; from three on.", "standard deviation / mean of the distances between neighbours", "M45", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A},
    {"stitch.count", "1", "Stitches that are through.", "count", "", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_NONE},
    {"insert.progress", "1", "Greatest share of the needle that was inside, of what is asked.", "max of s / drive", "", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_NONE},
    {"thread.tension", "N", "Greatest tension of the thread at the swage; told, as all of the thread, where the lesson names one.", "max", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_NONE},
    {"thread.swage_grasps", "1", "How often the needle was grasped at the swage, which damages the suture.", "count of: held nearer to the blunt end than swage_zone", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"thread.pull", "N*s", "Pull of the thread on the tissue, summed over time.", "integral of the length of f", "M51", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"thread.tail", "m", "Thread left before the entry; told once the thread is in the tissue.", "length", "", SWAGE_BETTER_INSIDE, SWAGE_EVIDENCE_NONE},
    {"thread.cut", "m", "How far the thread cut its holes through the tissue.", "max over the holes", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_NONE},
    {"thread.sawn", "m", "Thread drawn back against its way through the tissue.", "sum", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_NONE},
    lessons::points("points.wound", "Points lost for the size of the wound.", "30 clamp((wound.size - 1) / 2, 0, 1)"),
    lessons::points("points.angle", "Points lost for the angle in the tissue.", "30 clamp(insert.angle / 45 deg, 0, 1)"),
    lessons::points("points.entry", "Points lost for the distance of the entry from the mark.", "15 clamp(insert.entry_distance / tolerance, 0, 1)"),
    lessons::kPointsBending,
    lessons::points("points.refused", "Points lost for failed punctures.", "8 clamp(insert.deflections, 0, 3)"),
    lessons::points("points.drops", "Points lost for drops of the needle.", "15 grasp.drops"),
    lessons::points("points.suture", "Points lost for grasps at the swage.", "15 thread.swage_grasps"),
    lessons::kPointsTime,
};
static_assert(sizeof kMetrics / sizeof kMetrics[0] == static_cast<size_t>(Measure::kCount));

/// What they are called, and which are shown first.
inline constexpr swage_metric_label kLabels[] = {
    lessons::kTaskTimeLabel,
    lessons::kTaskSuccessLabel,
    lessons::kDropsLabel,
    lessons::kForceMeanLabel,
    lessons::label("force.peak", "Grip force, peak", SWAGE_SHOW_QUANTITY, 0, nullptr, "force"),
    lessons::label("grasp.tip_reach", "Tip overhang"),
    lessons::label("needle.bending", "Needle bending (% of yield)", SWAGE_SHOW_SHARE),
    lessons::kPathLabel,
    lessons::kSparcLabel,
    lessons::kLdljLabel,
    lessons::label("insert.entries", "Entries", SWAGE_SHOW_COUNT),
    lessons::label("insert.entry_distance", "Entry-point error", SWAGE_SHOW_QUANTITY, 3, nullptr, "tolerance"),
    lessons::label("insert.entry_angle", "Angle at the entry", SWAGE_SHOW_QUANTITY, 0, nullptr, "in_angle"),
    lessons::label("insert.cosine", "Cosine of penetration, mean"),
    lessons::label("insert.angle", "Deviation from perpendicular", SWAGE_SHOW_QUANTITY, 4, nullptr, "in_angle"),
    lessons::label("insert.in_angle", "Path within angle tolerance", SWAGE_SHOW_SHARE),
    lessons::label("insert.exit_distance", "Exit-point error"),
    lessons::label("insert.exit_angle", "Angle at the exit"),
    lessons::label("insert.depth", "Depth (% of wall)", SWAGE_SHOW_SHARE),
    lessons::label("insert.arc_error", "Deviation from the needle's arc"),
    lessons::label("insert.deflections", "Failed punctures", SWAGE_SHOW_COUNT, 0, nullptr, "max_deflections"),
    lessons::label("wound.size", "Entry wound size", SWAGE_SHOW_SHARE, 2, nullptr, "max_wound"),
    lessons::label("wound.area", "Entry wound area (% of the needle's)", SWAGE_SHOW_SHARE),
    lessons::label("tissue.pull", "Tissue pull over time"),
    lessons::label("tissue.swept", "Area torn in the tissue"),
    lessons::label("tissue.stray", "Stray touches of the tissue", SWAGE_SHOW_COUNT, 5),
    lessons::label("stitch.bite_in", "Entry bite (needle diameters)"),
    lessons::label("stitch.bite_out", "Exit bite (needle diameters)"),
    lessons::label("stitch.asymmetry", "Bite asymmetry", SWAGE_SHOW_SHARE),
    lessons::label("stitch.obliquity", "Stitch obliquity"),
    lessons::label("stitch.unevenness", "Spacing variability", SWAGE_SHOW_SHARE),
    lessons::label("stitch.count", "Stitches completed", SWAGE_SHOW_COUNT),
    lessons::label("insert.progress", "Required depth reached", SWAGE_SHOW_SHARE),
    lessons::label("thread.tension", "Thread tension, peak"),
    lessons::label("thread.swage_grasps", "Grasps at the swage", SWAGE_SHOW_COUNT),
    lessons::label("thread.pull", "Pull of the thread over time"),
    lessons::label("thread.tail", "Tail length"),
    lessons::label("thread.cut", "Cut by the thread"),
    lessons::label("thread.sawn", "Thread drawn back"),
    lessons::label("points.wound", "Wound size", SWAGE_SHOW_POINTS),
    lessons::label("points.angle", "Angle in the tissue", SWAGE_SHOW_POINTS),
    lessons::label("points.entry", "Entry point", SWAGE_SHOW_POINTS),
    lessons::kPointsBendingLabel,
    lessons::label("points.refused", "Failed punctures", SWAGE_SHOW_POINTS),
    lessons::kPointsDropsLabel,
    lessons::label("points.suture", "Grasps at the swage", SWAGE_SHOW_POINTS),
    lessons::kPointsTimeLabel,
};

/// What is asked of the trainee.
inline constexpr swage_criterion kCriteria[] = {
    {"Puncture the tissue within {tolerance} of the mark.", nullptr, SWAGE_CRITERION_PASS, 0},
    {"Drive {drive} of the needle into the tissue.", "task=insert", SWAGE_CRITERION_PASS, 0},
    {"Bring the point out, let go, take it where it came out and pull the needle through.", "task=stitch", SWAGE_CRITERION_PASS, 0},
    {"Draw the thread through until {tail} of it are left at the entry, to within {tail_tolerance}.", "task=stitch", SWAGE_CRITERION_PASS, 0},
    {"Stitches: {stitches}.", "task=stitch", SWAGE_CRITERION_PASS, 0},
    {"Stay perpendicular to the surface, to within {in_angle}, for at least {least_in_angle} of the way.", "least_in_angle", SWAGE_CRITERION_PASS, 0},
    {"A wound beyond {max_wound} of the needle's size ends the attempt.", nullptr, SWAGE_CRITERION_LIMIT, 0},
    {"More failed punctures than {max_deflections} end the attempt.", nullptr, SWAGE_CRITERION_LIMIT, 0},
    lessons::kMaxDrops,
    lessons::kMaxTime,
    lessons::kParTime,
    {"A large wound, an angle off the perpendicular, an entry off the mark and a bent needle cost points; up to {in_angle} counts as perpendicular.", nullptr, SWAGE_CRITERION_POINTS, 0},
};

using lessons::kFelt;
using lessons::kHeard;

/// Order of kCues.
enum class Sign : size_t { kNear, kAngleGood, kAngleOff, kStuck, kTorn, kTooHard, kDone, kSwageHeld, kTailGood, kBent, kDeflected, kDropped, kLeft, kCount };

inline constexpr swage_cue_info kCues[] = {
    {"target.near", "The point is where it should go in, or came out where it should.", kHeard, 0},
    {"insert.good", "In the tissue, within the angle.", kHeard, 0},
    {"insert.angle_off", "In the tissue, leaning more than the angle.", kFelt, 0},
    {"needle.stuck", "In the tissue, held by nobody.", kHeard, 0},
    {"tissue.tear", "The wound is larger than careful hands leave it.", kHeard, 0},
    lessons::kTooHard,
    {"target.done", "It went in here, and the task is done.", kHeard, 0},
    {"suture.swage_held", "The needle is grasped at the swage, which damages the suture.", kFelt, 0},
    {"suture.tail_good", "The tail has its length.", kHeard, 0},
    {"needle.bent", "The needle was bent beyond its yield: it stays bent.", kFelt, 0},
    {"tissue.deflected", "The tissue has turned the point away, and it has not gone in since.", kFelt, 0},
    {"needle.dropped", "The needle was dropped and is to be taken again.", kFelt, 0},
    {"target.left", "The point went in beyond the tolerance of the mark.", kFelt, 0},
};
// clang-format on
static_assert(sizeof kCues / sizeof kCues[0] == static_cast<size_t>(Sign::kCount));

}  // namespace swage::lesson_insertion
