// SPDX-License-Identifier: Apache-2.0
//
// Metrics and cues of the lesson of the knot: the one table behind its declarations, `swage describe` and knot.md.
#pragma once

#include <cstddef>

#include "common/card.hpp"

namespace swage::lesson_knot {

/// Order of kMetrics.
enum class Measure : size_t {
  kTime,
  kSuccess,
  kThrows,
  kUndone,
  kWrong,
  kSliding,
  kLoop,
  kLoosest,
  kGap,
  kTension,
  kTaut,
  kCut,
  kTail,
  kTailLeast,
  kTailMost,
  kDrops,
  kTakenAnew,
  kForce,
  kPeak,
  kOverTime,
  kPath,
  kSparc,
  kLdlj,
  kHold,
  kPassages,
  kAirGap,
  kIdle,
  kRegrasps,
  kPointsUndone,
  kPointsDrops,
  kPointsTension,
  kPointsForce,
  kPointsCut,
  kPointsTails,
  kPointsTime,
  kCount
};

// clang-format off
inline constexpr swage_metric_info kMetrics[] = {
    lessons::kTaskTime,
    lessons::kTaskSuccess,
    {"knot.right_throws", "1", "Throws from the first one on that are those that are asked for.", "max of the throws in the order, turns and signs of word or of its mirror image", "", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_D},
    {"knot.undone", "1", "How often a throw that was tied came undone.", "count of: knot.throws fewer", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"knot.wrong", "1", "How often a throw was tied that is not asked for, or the thread was tangled.", "count of: another word begins", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"knot.slides", "1", "Throws that slide: one strand runs straight through.", "knot.sliding", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"knot.left_loop", "m", "Thread from one strand of the first throw to the other: what the knot is tied around.", "knot.loop", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"knot.loosest", "m", "Thread that one strand takes in the loosest throw, from the throw before it on.", "knot.loosest", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"wound.gap", "m", "Distance of the two edges of the wound.", "gap - tissue.shift of both", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"tissue.pull_peak", "N", "Tension of the stitch that was exceeded for one two-hundredth of the held time.", "99.5 % quantile of the tension of the thread where it leaves the tissue, below 20 Hz, while held", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"thread.taut", "1", "Share of the held time in which the stitch was tighter than the limit.", "sum of dt with T > tension / held time", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"tissue.cut", "m", "How far the thread has cut its holes through the tissue, the farthest of them.", "max of pull.cut", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    {"thread.tail", "m", "Length of the tail outside of the tissue.", "pull.tail", "", SWAGE_BETTER_INSIDE, SWAGE_EVIDENCE_D},
    {"thread.tail_least", "m", "The shorter of the two ends that were cut, from the knot on; told as the next one where ends are cut.", "min of: knot.from - cut, cut - knot.to", "", SWAGE_BETTER_INSIDE, SWAGE_EVIDENCE_D},
    {"thread.tail_most", "m", "The longer of the two ends that were cut.", "max", "", SWAGE_BETTER_INSIDE, SWAGE_EVIDENCE_D},
    {"thread.drops", "1", "How often the thread got out of the jaws that wind before all throws were tied.", "count of: not held any more", "M07", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"thread.regrasps", "1", "How often the long end was laid down between two throws and taken anew.", "count of: held again within retake_time", "", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_D},
    lessons::kForceMean,
    lessons::kForcePeak,
    {"force.over_time", "1", "Share of the held time in which the jaws were above the limit.", "sum of dt with F > force.high / held time", "M18", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    lessons::kPathOfBoth,
    lessons::kSparc,
    lessons::kLdlj,
    {"hold.progress", "1", "Share of the hold that is done.", "unbroken hold / hold_time", "", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_NONE},
    {"thread.passages", "1", "How often the simulated thread went through itself or through the instrument, which no thread does.", "thread.passed + winding.passages", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_NONE},
    {"knot.air_gap", "m", "How high the first throw stands above the tissue.", "height of the first throw over the way from hole to hole - diameter of the thread", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"time.idle", "1", "Share of the time at work in which an instrument did nothing, mean of both.", "sum of dt in which the tips stay within 0.1 mm below 6 Hz, the opening within 1 deg and F within 0.05 N for more than 0.5 s / sum of dt, both since the hand set off and while the knot is not kept", "M03", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"grasp.regrasps", "1", "Grasps of the thread after the first one of each hand.", "count", "M08", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    lessons::points("points.undone", "Points lost for throws that came undone or were not those that are asked for.", "10 min(undone + wrong, 3)"),
    lessons::points("points.drops", "Points lost for a thread that got out of the jaws.", "15 drops"),
    lessons::points("points.tension", "Points lost for a stitch that was too tight.", "40 share of the held time above the tension"),
    lessons::points("points.force", "Points lost for gripping too hard.", "40 share of the held time above force.high"),
    lessons::points("points.cut", "Points lost for tissue that was cut.", "20 min(cut / most_cut, 1)"),
    lessons::points("points.tails", "Points lost for ends of another length.", "10 clamp(2 greatest difference of an end from what is asked / tail_tolerance - 1, 0, 1)"),
    lessons::kPointsTime,
};
static_assert(sizeof kMetrics / sizeof kMetrics[0] == static_cast<size_t>(Measure::kCount));

inline constexpr swage_metric_label kLabels[] = {
    lessons::kTaskTimeLabel,
    lessons::kTaskSuccessLabel,
    lessons::label("knot.right_throws", "Right throws", SWAGE_SHOW_COUNT, 2),
    lessons::label("knot.undone", "Throws that came undone", SWAGE_SHOW_COUNT, 3),
    lessons::label("knot.wrong", "Wrong throws", SWAGE_SHOW_COUNT),
    lessons::label("knot.slides", "Sliding throws", SWAGE_SHOW_COUNT, 0, nullptr, "most_sliding"),
    lessons::label("knot.left_loop", "Loop of the knot", SWAGE_SHOW_QUANTITY, 0, nullptr, "most_loop"),
    lessons::label("knot.loosest", "Loosest throw", SWAGE_SHOW_QUANTITY, 0, nullptr, "most_throw"),
    lessons::label("wound.gap", "Gap of the wound", SWAGE_SHOW_QUANTITY, 4, nullptr, "most_gap"),
    lessons::label("tissue.pull_peak", "Pull on the tissue, peak", SWAGE_SHOW_QUANTITY, 5, nullptr, "tension"),
    lessons::label("thread.taut", "Time above the limit of tension", SWAGE_SHOW_SHARE),
    lessons::label("tissue.cut", "Cut into the tissue", SWAGE_SHOW_QUANTITY, 0, nullptr, "most_cut"),
    lessons::label("thread.tail", "Length of the tail"),
    lessons::label("thread.tail_least", "Shortest tail"),
    lessons::label("thread.tail_most", "Longest tail"),
    lessons::label("thread.drops", "Thread lost from the jaws", SWAGE_SHOW_COUNT, 6, nullptr, "max_drops"),
    lessons::label("thread.regrasps", "Long end taken anew", SWAGE_SHOW_COUNT),
    lessons::kForceMeanLabel,
    lessons::label("force.peak", "Grip force, peak", SWAGE_SHOW_QUANTITY, 0, nullptr, "force"),
    lessons::label("force.over_time", "Time above the force limit", SWAGE_SHOW_SHARE),
    lessons::kPathLabel,
    lessons::kSparcLabel,
    lessons::kLdljLabel,
    lessons::label("hold.progress", "Hold completed", SWAGE_SHOW_SHARE),
    lessons::label("thread.passages", "Thread through itself or the instrument", SWAGE_SHOW_COUNT),
    lessons::label("knot.air_gap", "Air gap below the knot"),
    lessons::label("time.idle", "Idle time", SWAGE_SHOW_SHARE),
    lessons::label("grasp.regrasps", "Regrasps", SWAGE_SHOW_COUNT),
    lessons::label("points.undone", "Wrong or undone throws", SWAGE_SHOW_POINTS),
    lessons::label("points.drops", "Thread lost from the jaws", SWAGE_SHOW_POINTS),
    lessons::label("points.tension", "Tension of the stitch", SWAGE_SHOW_POINTS),
    lessons::kPointsForceLabel,
    lessons::label("points.cut", "Cut into the tissue", SWAGE_SHOW_POINTS),
    lessons::label("points.tails", "Tails", SWAGE_SHOW_POINTS),
    lessons::kPointsTimeLabel,
};

inline constexpr swage_criterion kCriteria[] = {
    {"Tie the throws {word}, flat, of which {most_sliding} may slide: turns of each with their sign, or all of them the mirror image.", nullptr, SWAGE_CRITERION_PASS, 0},
    {"Draw each throw down on the one before it: one strand takes {most_throw} of thread in it at most.", nullptr, SWAGE_CRITERION_PASS, 0},
    {"Draw them down until the loop has {most_loop} at most and the edges are within {most_gap}, and keep that for {hold_time}.", nullptr, SWAGE_CRITERION_PASS, 0},
    {"Then cut both ends so that {tail} of each are left at the knot, to within {tail_tolerance}; the knot must keep without the hands for {hold_time}.", "cut", SWAGE_CRITERION_PASS, 0},
    {"A cut through the knot or its loop, before all throws are tied, or too near to the knot ends the attempt.", "cut", SWAGE_CRITERION_ENDS, 0},
    {"A thread that breaks, is drawn out of the tissue, or cuts it by more than {most_cut} ends the attempt; so does one that the simulation lets go through itself or the instrument.", nullptr, SWAGE_CRITERION_ENDS, 0},
    {"Losing the thread from the jaws more often than {max_drops} times ends the attempt.", nullptr, SWAGE_CRITERION_LIMIT, 0},
    lessons::kMaxOverTime,
    lessons::kMaxTime,
    lessons::kParTime,
    {"Throws that are wrong or come undone, a lost thread, a stitch tighter than {tension}, gripping too hard and cutting cost points.", nullptr, SWAGE_CRITERION_POINTS, 0},
};

/// Order of kCues.
enum class Sign : size_t { kHeld, kTaut, kOn, kTied, kLoose, kWrong, kTogether, kTooHard, kDone, kTailGood, kCount };

inline constexpr swage_cue_info kCues[] = {
    {"thing.held", "The thread is held.", lessons::kHeard, 0},
    {"thread.taut", "The stitch is too tight.", lessons::kFelt, 0},
    {"loop.on", "The thread is wound about the instrument: take the tail.", lessons::kHeard, 0},
    {"knot.tied", "The throws that are asked for are tied, and lie flat.", lessons::kHeard, 0},
    {"knot.loose", "The throws are tied, and one of them is not drawn down.", lessons::kHeard, 0},
    {"knot.wrong", "A throw is not the one that is asked for, slides, or the thread is tangled.", lessons::kHeard, 0},
    {"wound.closed", "The edges of the wound are together.", lessons::kHeard, 0},
    lessons::kTooHard,
    {"target.done", "The knot has been kept for long enough.", lessons::kHeard, 0},
    {"suture.tail_good", "This end has its length.", lessons::kHeard, 0},
};
// clang-format on
static_assert(sizeof kCues / sizeof kCues[0] == static_cast<size_t>(Sign::kCount));

}  // namespace swage::lesson_knot
