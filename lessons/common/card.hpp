// SPDX-License-Identifier: Apache-2.0
//
// Metrics and channels of several lessons: the same id means the same number in all of them.
#pragma once

#include <swage/abi/lesson_card.h>

namespace swage::lessons {

// clang-format off
inline constexpr swage_metric_info kTaskTime = {"time.task", "s", "Time since the hand set off.", "now - first time that the tips were quicker than 2 mm/s for 0.1 s", "M01", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A};
inline constexpr swage_metric_info kTaskSuccess = {"task.success", "1", "1 when the attempt was passed.", "1 or 0", "M04", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_C};
inline constexpr swage_metric_info kDrops = {"grasp.drops", "1", "How often the needle was dropped or pushed away.", "count of: free, in no tissue, and further than drop_distance from where it was left", "M07", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B};
inline constexpr swage_metric_info kForceMean = {"force.mean", "N", "Mean grip force while held.", "mean of F below 20 Hz", "M15", SWAGE_BETTER_INSIDE, SWAGE_EVIDENCE_C};
inline constexpr swage_metric_info kForcePeak = {"force.peak", "N", "Grip force that was exceeded for one two-hundredth of the held time.", "99.5 % quantile of F below 20 Hz while held", "M16", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_B};
inline constexpr swage_metric_info kTipReach = {"grasp.tip_reach", "m", "Mean reach of the tips past the needle while held.", "mean of (tips - place) . x_T", "M11", SWAGE_BETTER_INSIDE, SWAGE_EVIDENCE_C};
inline constexpr swage_metric_info kBending = {"needle.bending", "1", "Greatest bending moment in the needle over the moment at which it yields.", "max of the needle's signal needle.stress", "M21", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_D};
inline constexpr swage_metric_info kPath = {"motion.path", "m", "Length of the path of the tips.", "sum of abs(dx) below 6 Hz", "M22", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A};
// Not rated: in 020 the expert, who approaches the needle in two movements, has -1.87 and a novice -1.40.
inline constexpr swage_metric_info kSparc = {"motion.sparc", "1", "Smoothness of the movements: spectral arc length, median over the movements of the tips; about -1.4 of one that is smooth.", "- arc length of the normalised spectrum of the speed below 6 Hz, up to 10 Hz", "M27", SWAGE_BETTER_NONE, SWAGE_EVIDENCE_B};
inline constexpr swage_metric_info kLdlj = {"motion.ldlj", "1", "Smoothness of the long movements: log dimensionless jerk, median over movements of the tips beyond 20 mm; about -5.3 of one that is smooth.", "- ln(T^3 / peak^2 integral of (d2v/dt2)^2 dt)", "M28", SWAGE_BETTER_HIGHER, SWAGE_EVIDENCE_B};
inline constexpr swage_metric_info kPathOfBoth = {"motion.path", "m", "Length of the paths of both pairs of tips.", "sum of abs(dx) below 6 Hz", "M22", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_A};

/// Metric of points deducted, of 100; reported at the end.
constexpr swage_metric_info points(const char* id, const char* doc, const char* formula) {
  return {id, "1", doc, formula, "", SWAGE_BETTER_LOWER, SWAGE_EVIDENCE_NONE};
}
inline constexpr swage_metric_info kPointsTime = points("points.time", "Points lost for active time beyond the par time.", "15 clamp(time / par_time - 1, 0, 1)");

inline constexpr swage_metric_info kPointsBending = points("points.bending", "Points lost for bending the needle.", "20 clamp((needle.bending - 0.7) / 0.3, 0, 1)");

/// Labels of the metrics above. `rank`: place among the metrics that are shown first; 0: shown on demand.
constexpr swage_metric_label label(const char* id, const char* title, int32_t show = SWAGE_SHOW_QUANTITY, int32_t rank = 0, const char* least = nullptr, const char* most = nullptr) {
  return {id, title, show, rank, least, most};
}
inline constexpr swage_metric_label kTaskTimeLabel = label("time.task", "Active time", SWAGE_SHOW_QUANTITY, 1, nullptr, "par_time");
inline constexpr swage_metric_label kTaskSuccessLabel = label("task.success", "Passed", SWAGE_SHOW_YES_NO);
inline constexpr swage_metric_label kDropsLabel = label("grasp.drops", "Drops", SWAGE_SHOW_COUNT, 0, nullptr, "max_drops");
inline constexpr swage_metric_label kForceMeanLabel = label("force.mean", "Grip force, mean", SWAGE_SHOW_QUANTITY, 0, "force", "force");
inline constexpr swage_metric_label kPathLabel = label("motion.path", "Tip path length");
inline constexpr swage_metric_label kSparcLabel = label("motion.sparc", "Smoothness (spectral arc length)");
inline constexpr swage_metric_label kLdljLabel = label("motion.ldlj", "Smoothness of long movements (log jerk)");
inline constexpr swage_metric_label kPointsBendingLabel = label("points.bending", "Needle bending", SWAGE_SHOW_POINTS);
inline constexpr swage_metric_label kPointsDropsLabel = label("points.drops", "Drops", SWAGE_SHOW_POINTS);
inline constexpr swage_metric_label kPointsForceLabel = label("points.force", "Grip force", SWAGE_SHOW_POINTS);
inline constexpr swage_metric_label kPointsTimeLabel = label("points.time", "Time", SWAGE_SHOW_POINTS);

inline constexpr swage_criterion kParTime = {"Active time beyond {par_time} costs points.", nullptr, SWAGE_CRITERION_POINTS, 0};
inline constexpr swage_criterion kMaxTime = {"The time limit is {max_time}.", nullptr, SWAGE_CRITERION_LIMIT, 0};
inline constexpr swage_criterion kMaxOverTime = {"Gripping too hard for more than {max_over_time} ends the attempt.", nullptr, SWAGE_CRITERION_LIMIT, 0};
inline constexpr swage_criterion kMaxDrops = {"More drops than {max_drops} end the attempt.", nullptr, SWAGE_CRITERION_LIMIT, 0};

inline constexpr uint32_t kHeard = SWAGE_CHANNEL_COLOUR | SWAGE_CHANNEL_SHAPE | SWAGE_CHANNEL_SOUND;
inline constexpr uint32_t kFelt = kHeard | SWAGE_CHANNEL_FORCE;

inline constexpr swage_cue_info kTooHard = {"grip.too_hard", "The grip force is above the limit.", kFelt, 0};

inline constexpr swage_cue_info kGraspWrong = {"grasp.wrong", "Held at the wrong place, and not with the tips.", kHeard, 0};
inline constexpr swage_cue_info kGraspTipsOnly = {"grasp.tips_only", "Held with the tips, but at the wrong place.", kHeard, 0};
inline constexpr swage_cue_info kGraspPointOnly = {"grasp.point_only", "Held at the right place, but not with the tips.", kHeard, 0};
inline constexpr swage_cue_info kGraspGood = {"grasp.good", "Held at the right place and with the tips.", kHeard, 0};
// clang-format on

}  // namespace swage::lessons
