// SPDX-License-Identifier: Apache-2.0
//
// Metrics and cues of the ring lesson: the one table behind its declarations, `swage describe` and ring.md. Codes M.. are
// those of the metric catalogue that the page names.
#pragma once

#include <cstddef>

#include "common/card.hpp"

namespace swage::lesson_ring {

/// Order of kMetrics.
enum class Measure : size_t {
  kTime,
  kSuccess,
  kTouches,
  kTouchTime,
  kTouchPeak,
  kOffCentre,
  kTilt,
  kDrops,
  kRegrasps,
  kForce,
  kPeak,
  kOverTime,
  kPath,
  kSparc,
  kLdlj,
  kTremor,
  kProgress,
  kPosts,
  kPointsTouches,
  kPointsTouchTime,
  kPointsDrops,
  kPointsForce,
  kPointsTime,
  kCount
};

// clang-format off
inline constexpr swage_metric_info kMetrics[] = {
    lessons::kTaskTime,
    lessons::kTaskSuccess,
    {"ring.touches", "1", "Touches of wire, posts or stand by the ring or the instrument while the ring is carried.", "count of: force of a watched coupling above 0.1 mN; apart by 0.15 s", "M52", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"ring.touch_time", "1", "Share of the time carried in which something touched.", "sum of dt that touches / time carried", "M52", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"ring.touch_peak", "N", "Greatest force of these touches.", "max of the sum of the watched couplings' forces while carried", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"ring.off_centre", "m", "Distance of the wire from the ring's centre, by way along the wire.", "sqrt(integral of d^2 dl / l)", "M32", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"ring.tilt", "rad", "Angle between the ring's axis and the wire, by way along the wire.", "sqrt(integral of angle^2 dl / l)", "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    {"grasp.drops", "1", "How often the ring was dropped.", "count of: free and further than drop_distance from where it was left", "M07", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B},
    {"grasp.regrasps", "1", "Grasps after the first one.", "count", "M08", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D},
    lessons::kForceMean,
    lessons::kForcePeak,
    {"force.over_time", "1", "Share of the held time above the limit.", "sum of dt with F > force.high / held time", "M18", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_C},
    lessons::kPath,
    lessons::kSparc,
    lessons::kLdlj,
    {"motion.tremor", "m", "Shaking of the tips in the scene while the ring is carried.", "root mean square of the tips between 8 and 12 Hz", "M30", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A},
    {"ring.progress", "1", "Share of the way along the wire that is done.", "greatest place of the ring on the wire within the course", "", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_NONE},
    {"ring.posts", "1", "Posts that the ring has been over.", "count", "", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_NONE},
    lessons::points("points.touches", "Points lost for touches.", "4 clamp(touches, 0, 10)"),
    lessons::points("points.touch_time", "Points lost for the time in which something touched.", "20 clamp(share of the time carried / 20 %, 0, 1)"),
    lessons::points("points.drops", "Points lost for drops of the ring.", "15 drops"),
    lessons::points("points.force", "Points lost for gripping too hard.", "20 share of the held time above force.high"),
    lessons::kPointsTime,
};
static_assert(sizeof kMetrics / sizeof kMetrics[0] == static_cast<size_t>(Measure::kCount));

/// Titles of the metrics, and the order in which the first ones are shown.
inline constexpr swage_metric_label kLabels[] = {
    lessons::kTaskTimeLabel,
    lessons::kTaskSuccessLabel,
    lessons::label("ring.touches", "Touches", SWAGE_SHOW_COUNT, 2, nullptr, "max_touches"),
    lessons::label("ring.touch_time", "Time touching", SWAGE_SHOW_SHARE, 3),
    lessons::label("ring.touch_peak", "Touch force, peak"),
    lessons::label("ring.off_centre", "Distance from the wire's centre", SWAGE_SHOW_QUANTITY, 4),
    lessons::label("ring.tilt", "Ring tilt to the wire"),
    lessons::kDropsLabel,
    lessons::label("grasp.regrasps", "Regrasps", SWAGE_SHOW_COUNT),
    lessons::kForceMeanLabel,
    lessons::label("force.peak", "Grip force, peak", SWAGE_SHOW_QUANTITY, 0, nullptr, "force"),
    lessons::label("force.over_time", "Time above the force limit", SWAGE_SHOW_SHARE),
    lessons::kPathLabel,
    lessons::kSparcLabel,
    lessons::kLdljLabel,
    lessons::label("motion.tremor", "Tremor while carrying", SWAGE_SHOW_QUANTITY, 5),
    lessons::label("ring.progress", "Path along the wire", SWAGE_SHOW_SHARE),
    lessons::label("ring.posts", "Posts completed", SWAGE_SHOW_COUNT),
    lessons::label("points.touches", "Touches", SWAGE_SHOW_POINTS),
    lessons::label("points.touch_time", "Time touching", SWAGE_SHOW_POINTS),
    lessons::kPointsDropsLabel,
    lessons::kPointsForceLabel,
    lessons::kPointsTimeLabel,
};

/// Requirements on the trainee.
inline constexpr swage_criterion kCriteria[] = {
    {"Carry the ring along the wire and off its free end.", nullptr, SWAGE_CRITERION_PASS, 0},
    {"Lower it over each post in turn: {posts}; let go over the last.", "posts", SWAGE_CRITERION_PASS, 0},
    {"More touches than {max_touches} end the attempt.", nullptr, SWAGE_CRITERION_LIMIT, 0},
    lessons::kMaxOverTime,
    lessons::kMaxDrops,
    lessons::kMaxTime,
    lessons::kParTime,
    {"Touches, drops and gripping too hard cost points.", nullptr, SWAGE_CRITERION_POINTS, 0},
};

/// Order of kCues.
enum class Sign : size_t { kClear, kTouching, kTooHard, kNear, kDone, kCount };

inline constexpr swage_cue_info kCues[] = {
    {"ring.clear", "Carried, and nothing touches.", lessons::kHeard, 0},
    {"ring.touching", "The ring or the instrument touches wire, post or stand.", lessons::kFelt, 0},
    lessons::kTooHard,
    {"target.near", "The ring is over the post.", lessons::kHeard, 0},
    {"target.done", "The ring lies over the last post.", lessons::kHeard, 0},
};
// clang-format on
static_assert(sizeof kCues / sizeof kCues[0] == static_cast<size_t>(Sign::kCount));

}  // namespace swage::lesson_ring
