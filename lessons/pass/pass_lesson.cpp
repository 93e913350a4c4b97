// SPDX-License-Identifier: Apache-2.0
#include "pass_lesson.hpp"

#include <algorithm>

#include "common/declare.hpp"
#include "common/report.hpp"
#include "common/rules.hpp"
#include "common/sentences.hpp"

namespace swage::lesson_pass {

using lessons::index;
using toolkit::vec;

void PassLesson::build(const P& params, LessonBuilder& builder) {
  lessons::require_ordered(builder, "force", params.force);
  if (params.first == params.second) builder.error("second", lessons::say::kTwoGrippers());
  builder.state<Memory>();
  lessons::declare_card(builder, kCues, cue_, kMetrics, metric_);
  phase_[index(Stage::kTake)] = builder.phase("take", "Take the needle with one of the two.");
  phase_[index(Stage::kBring)] = builder.phase("bring", "Bring it to the mark.");
  phase_[index(Stage::kPass)] = builder.phase("pass", "Take it with the other one; let go only when both hold it.");
  phase_[index(Stage::kHold)] = builder.phase("hold", "Let go with the first and hold it with the other.");
  phase_[index(Stage::kDone)] = builder.phase("done", "The attempt is over.");
  passed_on_ = builder.event("pass.done", "The needle has been passed; value: to which gripper, from 0.");
  snatched_ = builder.event("pass.snatched", "The needle has changed hands, but both did not hold it long enough at the place.");
  dropped_ = builder.event("needle.dropped", "The needle has left where it was held or lay.");
  failed_[index(End::kDropped)] = builder.event("failed.dropped", "The needle was dropped too often.");
  failed_[index(End::kTooHard)] = builder.event("failed.too_hard", "The needle was held too hard for too long.");
  failed_[index(End::kOutOfTime)] = builder.event("failed.out_of_time", "Time ran out before the needle was passed and held.");
  failed_[index(End::kLost)] = builder.event("failed.lost", "The needle has gone where nobody can reach it.");
}

void PassLesson::bind(const Scene& scene, Binder& binder) {
  const std::string* const names[kHands][2] = {{&params().first, &params().first_grasp}, {&params().second, &params().second_grasp}};
  for (int i = 0; i < kHands; ++i) {
    hand_[i].gripper = lessons::find_gripper(scene, binder, *names[i][0], hand_[i].object);
    hand_[i].grasp = lessons::find_grasp(scene, binder, *names[i][1]);
  }
  needle_object_ = lessons::find_object(scene, binder, params().needle);
  if (binder.failed()) return;
  const swage_scene_object& needle = scene->object[needle_object_];
  if (needle.n_body == 0) return binder.error(lessons::say::kNotTaken(params().needle));
  needle_body_ = needle.first_body;
  needle_ = Peer(needle.instance);
  if (!needle_.graspable()) return binder.error("\"" + params().needle + "\" cannot be asked where it is nearest to the place");
  bending_ = scene.find_signal(params().needle, "needle.stress");  // only a needle that bends offers it
  put_back_ = scene.find_event("swage", "host.reset");
  place_ = binder.mark_point(params().place, params().place_radius, "target.point");
}

void PassLesson::activate(double dt_s) {
  const P& p = params();
  Rules rules;
  lessons::set_common_rules(p, is_practice(), rules);
  rules.place_radius = p.place_radius;
  rules.share_time = p.share_time;
  rules.passes = p.passes;
  judge_ = Judge(rules, dt_s);
}

bool PassLesson::read(const View& view, Look& look) const {
  look.time_s = view.time();
  look.dt_s = view.dt();
  for (int i = 0; i < kHands; ++i) {
    const auto jaws = hand_[i].gripper.describe(view.object(hand_[i].object));
    if (!jaws) return false;
    look.hand[i] = {view.signal(hand_[i].grasp.held) != 0, view.signal(hand_[i].grasp.force), vec(jaws->tip_W)};
  }
  look.needle_W = vec(view.pose(needle_body_).p);
  const auto nearest = needle_.locate(view.object(needle_object_), params().place);
  if (!nearest) return false;
  look.place_distance = (vec(nearest->p_W) - vec(params().place)).norm();
  if (bending_.valid()) look.bending = view.signal(bending_);
  for (const swage_view_event& event : view.events())
    if (event.event == put_back_ && event.value == needle_object_) look.reset = true;
  return true;
}

void PassLesson::observe(const View& view, const Verdict& verdict, std::span<double> state) {
  Look look;
  auto& memory = as<Memory>(state);
  if (!read(view, look)) return discard();
  const Finding finding = judge_.look(memory, look);
  report(memory, look.time_s, verdict);
  if (finding.passed_on) verdict.event(passed_on_, memory.owner - 1);
  if (finding.end == End::kPassed) report_points(finding.lost, verdict);
  say(finding, verdict);
}

void PassLesson::say(const Finding& finding, const Verdict& verdict) const {
  const auto sign = [&](Sign s) { return cue_[index(s)]; };
  if (finding.held)
    verdict.cue(needle_object_, sign(finding.may_let_go ? Sign::kBoth : Sign::kHeld));
  else
    verdict.clear_cue(needle_object_);
  for (int i = 0; i < kHands; ++i)
    finding.too_hard[i] ? verdict.cue(hand_[i].object, sign(Sign::kTooHard)) : verdict.clear_cue(hand_[i].object);
  const bool done = finding.stage == Stage::kHold || finding.end == End::kPassed;
  if (done || (finding.held && finding.near_place))
    verdict.mark(place_, sign(done ? Sign::kDone : Sign::kNear));
  else
    verdict.clear_mark(place_);
  if (finding.snatched) verdict.event(snatched_);
  if (finding.dropped) verdict.event(dropped_);
  verdict.phase(phase_[index(finding.stage)]);

  if (finding.end == End::kRunning) return;
  if (finding.end == End::kPassed) return verdict.pass(finding.score);
  const Event reason = failed_[index(finding.end)];
  verdict.event(reason);
  verdict.fail(reason, finding.score);
}

// Metrics without a value before the needle was held are not reported.
void PassLesson::report(const Memory& m, double time_s, const Verdict& verdict) const {
  tell(verdict, Measure::kTime, Judge::task_time(m, time_s));
  tell(verdict, Measure::kSuccess, m.passed);
  tell(verdict, Measure::kPasses, m.passes);
  tell(verdict, Measure::kSnatches, m.snatches);
  tell(verdict, Measure::kDrops, m.drops);
  tell(verdict, Measure::kPath, m.path[0].length + m.path[1].length);
  lessons::report_smoothness(verdict, metric_[index(Measure::kSparc)], metric_[index(Measure::kLdlj)], m.path);
  tell(verdict, Measure::kHold, std::min(1.0, m.hold_s / judge_.rules().hold_time));
  if (bending_.valid()) tell(verdict, Measure::kBending, m.bending);
  if (m.passes > 0) tell(verdict, Measure::kShared, m.shared_s / m.passes);
  if (m.shared_all_s > 0) tell(verdict, Measure::kPlaceError, m.error_s / m.shared_all_s);
  if (!(m.held_s > 0)) return;
  const double held_s = m.grip[0].held_s + m.grip[1].held_s;
  tell(verdict, Measure::kForce, (m.grip[0].force_s + m.grip[1].force_s) / held_s);
  tell(verdict, Measure::kPeak, std::max(judge_.grip().peak(m.grip[0]), judge_.grip().peak(m.grip[1])));
  tell(verdict, Measure::kOverTime, m.over_s / m.held_s);
}

void PassLesson::report_points(const Points& lost, const Verdict& verdict) const {
  tell(verdict, Measure::kPointsDrops, lost.drops);
  tell(verdict, Measure::kPointsSnatches, lost.snatches);
  tell(verdict, Measure::kPointsForce, lost.force);
  if (bending_.valid()) tell(verdict, Measure::kPointsBending, lost.bending);
  tell(verdict, Measure::kPointsTime, lost.time);
}

}  // namespace swage::lesson_pass

SWAGE_EXPORT(swage::lesson_pass::PassLesson)
