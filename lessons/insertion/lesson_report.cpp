// SPDX-License-Identifier: Apache-2.0
//
// Metrics of the lesson, and the deducted points.
#include <algorithm>

#include "common/report.hpp"
#include "insertion_lesson.hpp"

namespace swage::lesson_insertion {

using lessons::index;

void InsertionLesson::report(const Look& look, const Finding& finding, const Memory& m,
                             const Verdict& verdict) const {
  const auto tell = [&](Measure measure, double value) { verdict.metric(metric_[index(measure)], value); };
  const Rules& rules = judge_.rules();
  tell(Measure::kTime, task_time(m, look.time_s));
  tell(Measure::kSuccess, finding.end == End::kPassed ? 1 : 0);
  tell(Measure::kDrops, m.drops);
  tell(Measure::kForce, GripWatch::mean(m.grip));
  tell(Measure::kPeak, judge_.grip().peak(m.grip));
  tell(Measure::kPath, m.path.length);
  lessons::report_smoothness(verdict, metric_[index(Measure::kSparc)], metric_[index(Measure::kLdlj)], {&m.path, 1});
  if (m.grip.held_s > 0) tell(Measure::kTipReach, m.reach_s / m.grip.held_s);
  if (m.twist.told != 0 && !has_far()) tell(Measure::kTwist, m.twist.most);
  if (bending_.valid()) tell(Measure::kBending, m.bending);
  tell(Measure::kEntries, m.entries);
  tell(Measure::kDeflections, m.deflections);
  tell(Measure::kStray, m.stray.count);
  tell(Measure::kProgress, std::min(1.0, m.deepest / rules.drive));
  if (thread_.valid()) report_suture(m, verdict);
  // metrics without a value before the first entry are not reported
  if (m.entries == 0) return;
  tell(Measure::kEntryDistance, m.entry_distance);
  tell(Measure::kEntryAngle, m.entry_angle);
  tell(Measure::kCosine, m.inside_s > 0 ? m.cosine_s / m.inside_s : 0);
  tell(Measure::kAngle, angle_rms(m));
  tell(Measure::kInAngle, m.travel > 0 ? in_angle_share(m) : 0);
  if (m.wall > 0) tell(Measure::kDepth, look.below / m.wall);
  tell(Measure::kArc, arc_rms(m));
  tell(Measure::kWound, std::max(look.wound, m.worst_wound));
  if (pierce_.wound_wide.valid() && !has_cut()) tell(Measure::kWoundWide, look.wound_wide);
  if (const double exit = std::max(m.worst_exit, exit_wound(look, rules.far)); exit > 0) tell(Measure::kWoundExit, exit);
  tell(Measure::kArea, look.area_ratio);
  tell(Measure::kPull, m.pull_s);
  tell(Measure::kSwept, look.swept);
  report_stitches(look, m, verdict);
  if (has_far()) report_far(look, m, verdict);
}

void InsertionLesson::report_points(const Points& lost, const Verdict& verdict) const {
  const auto tell = [&](Measure measure, double value) { verdict.metric(metric_[index(measure)], value); };
  tell(Measure::kPointsWound, lost.wound);
  tell(Measure::kPointsAngle, lost.angle);
  tell(Measure::kPointsEntry, lost.entry);
  if (bending_.valid()) tell(Measure::kPointsBending, lost.bending);
  tell(Measure::kPointsRefused, lost.refused);
  tell(Measure::kPointsDrops, lost.drops);
  if (thread_.valid()) tell(Measure::kPointsSuture, lost.suture);
  if (params_.task == Task::kStitch) tell(Measure::kPointsExit, lost.exit);
  report_running(lost, verdict);
  tell(Measure::kPointsTime, lost.time);
}

void InsertionLesson::report_stitches(const Look& look, const Memory& m, const Verdict& verdict) const {
  const auto tell = [&](Measure measure, double value) { verdict.metric(metric_[index(measure)], value); };
  const StitchState& s = m.stitch;
  tell(Measure::kBiteIn, s.bite_in / look.diameter);
  if (params_.task == Task::kStitch) tell(Measure::kStitches, s.count);
  if (s.out == 0 && s.count == 0) return;
  if (has_exit()) tell(Measure::kExitDistance, m.exit_distance);
  tell(Measure::kExitAngle, m.exit_angle);
  tell(Measure::kBiteOut, s.bite_out / look.diameter);
  tell(Measure::kAsymmetry, Stitches::asymmetry(s));
  if (s.oblique >= 0) tell(Measure::kOblique, s.oblique);
  if (params_.stitches > 1) tell(Measure::kMostOblique, s.most_oblique);
  if (params_.stitches > 1 && s.count > 0) tell(Measure::kUnequal, Stitches::unequal(s));
  if (const double uneven = Stitches::unevenness(s); uneven >= 0) tell(Measure::kUneven, uneven);
}

}  // namespace swage::lesson_insertion
