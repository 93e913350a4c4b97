// SPDX-License-Identifier: Apache-2.0
#include "grasp_lesson.hpp"

#include <algorithm>

#include "common/declare.hpp"
#include "common/report.hpp"
#include "common/rules.hpp"
#include "common/sentences.hpp"

namespace swage::lesson_grasp {

using lessons::index;
using toolkit::vec;

void GraspLesson::build(const GraspParams& params, LessonBuilder& builder) {
  params_ = params;
  lessons::require_ordered(builder, "region", params.region);
  lessons::require_ordered(builder, "tip_zone", params.tip_zone);
  lessons::require_ordered(builder, "force", params.force);
  builder.state<Memory>();
  declare(builder);
}

void GraspLesson::declare(LessonBuilder& builder) {
  lessons::declare_card(builder, kCues, cue_, kMetrics, metric_, [this](size_t i) {
    return params_.carry || (i != index(Sign::kNear) && i != index(Sign::kDone));
  });

  phase_[index(Stage::kApproach)] = builder.phase("approach", ("Bring the open jaws to the " + params_.needle + ".").c_str());
  phase_[index(Stage::kGrasp)] = builder.phase("grasp", "Close the jaws on the region and lift what they hold.");
  phase_[index(Stage::kCarry)] = builder.phase("carry", ("Bring the " + params_.needle + " to the target.").c_str());
  phase_[index(Stage::kHold)] = builder.phase("hold", "Hold with steady force.");
  phase_[index(Stage::kRegrasp)] = builder.phase("regrasp", "Open the jaws, and grasp it in the marked region.");
  phase_[index(Stage::kDropped)] = builder.phase("dropped", "It was dropped: pick it up where it lies, or put it back.");
  phase_[index(Stage::kDone)] = builder.phase("done", "The attempt is over.");

  dropped_ = builder.event("needle.dropped", "The needle has left where it was held or lay.");
  hold_began_ = builder.event("hold.began", "All that is asked of a hold is fulfilled from here on.");
  hold_broke_ = builder.event("hold.broke", "Something that is asked of a hold is no longer fulfilled.");
  const std::string thing = "The " + params_.needle;
  const auto failure = [&](End end, const char* event, const std::string& doc) {
    failed_[index(end)] = builder.event(event, doc.c_str());
  };
  failure(End::kDropped, "failed.dropped", thing + " was dropped too often.");
  failure(End::kTooHard, "failed.too_hard", thing + " was held too hard for too long.");
  failure(End::kOutOfTime, "failed.out_of_time", "Time ran out before the hold was complete.");
  failure(End::kWrongGrasp, "failed.wrong_grasp", thing + " was held at the wrong place for too long.");
  failure(End::kLost, "failed.lost", thing + " has gone where nobody can reach it.");
  failure(End::kLeftTarget, "failed.left_target", thing + " left the target during the hold.");
}

void GraspLesson::bind(const Scene& scene, Binder& binder) {
  gripper_ = lessons::find_gripper(scene, binder, params_.gripper, gripper_object_);
  needle_object_ = lessons::find_object(scene, binder, params_.needle);
  const std::vector<std::string> owners = lessons::grasp_owners(scene);
  if (owners.empty()) { binder.error(lessons::say::kNoGrasp());
  }
  if (binder.failed()) return;
  grasp_ = lessons::find_grasp(scene, binder, owners.front());
  const swage_scene_object& needle = scene->object[needle_object_];
  if (needle.n_body == 0) return binder.error(lessons::say::kNotTaken(params_.needle));
  needle_body_ = needle.first_body;
  region_ = binder.mark_arc(needle_object_, params_.region.low, params_.region.high, "region.target");
  bending_ = scene.find_signal(params_.needle, "needle.stress");  // only a needle that bends offers it
  put_back_ = scene.find_event("swage", "host.reset");
  if (!params_.carry) return;
  needle_ = Peer(needle.instance);
  if (!needle_.graspable())
    binder.error("\"" + params_.needle + "\" cannot be asked where it is nearest to the target");
  target_ = binder.mark_point(params_.target_centre, params_.target_radius, "target.point");
}

void GraspLesson::activate(double dt_s) {
  const GraspParams& p = params_;
  Rules rules;
  lessons::set_common_rules(p, is_practice(), rules);
  rules.region_low = p.region.low;
  rules.region_high = p.region.high;
  rules.tip_low = p.tip_zone.low;
  rules.tip_high = p.tip_zone.high;
  rules.tips_needed = p.tips_needed;
  rules.max_tilt = p.max_tilt;
  rules.lift = p.lift;
  rules.max_wrong_time = p.max_wrong_time;
  rules.target = {p.carry, p.target_radius, p.leave};
  judge_ = Judge(rules, dt_s);
}

void GraspLesson::draw(TargetState& target) {
  const Vec3 centre = vec(params_.target_centre), spread = vec(params_.target_spread);
  for (int i = 0; i < 3; ++i) target.p_W[i] = centre[i] + spread[i] * (2 * random() - 1);
  target.drawn = 1;
}

bool GraspLesson::read(const View& view, Look& look, TargetState& target) {
  const auto jaws = gripper_.describe(view.object(gripper_object_));
  if (!jaws) return false;
  look.time_s = view.time();
  look.dt_s = view.dt();
  look.held = view.signal(grasp_.held) != 0;
  look.touched = view.happened(grasp_.touched);
  look.taken = view.happened(grasp_.taken);
  look.force = view.signal(grasp_.force);
  look.s = view.signal(grasp_.s);
  look.tip_reach = view.signal(grasp_.tip_reach);
  look.tilt_axis = view.signal(grasp_.tilt_axis);
  look.tilt_plane = view.signal(grasp_.tilt_plane);
  look.balance = view.signal(grasp_.balance);
  look.opening = jaws->opening;
  look.tip_W = vec(jaws->tip_W);
  look.needle_W = vec(view.pose(needle_body_).p);
  look.q_WN = toolkit::quat(view.pose(needle_body_).q);
  if (bending_.valid()) look.bending = view.signal(bending_);
  for (const swage_view_event& event : view.events())
    if (event.event == put_back_ && event.value == needle_object_) look.reset = true;
  if (!params_.carry) return true;

  if (target.drawn == 0) draw(target);
  const Vec3 target_W = Eigen::Map<const Vec3>(target.p_W);
  const auto nearest = needle_.locate(view.object(needle_object_), toolkit::raw(target_W));
  if (!nearest) return false;
  look.target_distance = (vec(nearest->p_W) - target_W).norm();
  return true;
}

void GraspLesson::observe(const View& view, const Verdict& verdict, std::span<double> state) {
  Look look;
  auto& memory = as<Memory>(state);
  if (!read(view, look, memory.target)) return discard();
  const Finding finding = judge_.look(memory, look);
  report(memory, look.time_s, verdict);
  if (finding.end == End::kPassed) report_points(finding.lost, verdict);
  say(finding, memory.target, verdict);
}

void GraspLesson::say(const Finding& finding, const TargetState& target, const Verdict& verdict) const {
  // cues: the first ones are the grades without kNone
  const auto sign = [&](Sign s) { return cue_[static_cast<size_t>(s)]; };
  if (finding.grade != Grade::kNone)
    verdict.cue(needle_object_, cue_[static_cast<size_t>(finding.grade) - 1]);
  else
    verdict.clear_cue(needle_object_);
  finding.too_hard ? verdict.cue(gripper_object_, sign(Sign::kTooHard)) : verdict.clear_cue(gripper_object_);
  if (params_.carry) {
    const swage_vec3 p_W{target.p_W[0], target.p_W[1], target.p_W[2]};
    const Cue near = finding.near_target ? sign(Sign::kNear) : Cue();
    verdict.mark(target_, finding.end == End::kPassed ? sign(Sign::kDone) : near, &p_W);
  }

  // events
  if (finding.dropped) verdict.event(dropped_);
  if (finding.hold_began) verdict.event(hold_began_);
  if (finding.hold_broke) verdict.event(hold_broke_);
  verdict.phase(phase_[static_cast<size_t>(finding.stage)]);

  // verdict
  if (finding.end == End::kRunning) return;
  if (finding.end == End::kPassed) return verdict.pass(finding.score);
  const Event reason = failed_[static_cast<size_t>(finding.end)];
  verdict.event(reason);
  verdict.fail(reason, finding.score);
}

void GraspLesson::report_points(const Points& lost, const Verdict& verdict) const {
  const auto tell = [&](Measure measure, double value) {
    verdict.metric(metric_[static_cast<size_t>(measure)], value);
  };
  tell(Measure::kPointsTries, lost.tries);
  tell(Measure::kPointsDrops, lost.drops);
  if (params_.carry) tell(Measure::kPointsHold, lost.hold);
  tell(Measure::kPointsForce, lost.force);
  tell(Measure::kPointsTilt, lost.tilt);
  if (bending_.valid()) tell(Measure::kPointsBending, lost.bending);
  tell(Measure::kPointsTime, lost.time);
}

void GraspLesson::report(const Memory& m, double time_s, const Verdict& verdict) const {
  const auto tell = [&](Measure measure, double value) {
    verdict.metric(metric_[static_cast<size_t>(measure)], value);
  };
  const auto phase = [&](Stage stage) { return m.phase_s[static_cast<size_t>(stage)]; };
  tell(Measure::kTime, task_time(m, time_s));
  if (m.touched_s >= 0) tell(Measure::kApproach, approach_time(m));
  if (params_.carry) tell(Measure::kCarry, phase(Stage::kCarry));
  if (m.idle.all_s > 0) tell(Measure::kIdle, lessons::IdleWatch::share(m.idle));
  tell(Measure::kSuccess, m.passed);
  tell(Measure::kTries, m.tries);
  tell(Measure::kDrops, m.drops);
  tell(Measure::kRegrasps, m.regrasps);
  tell(Measure::kResets, m.resets);
  tell(Measure::kPath, m.path.length);
  lessons::report_smoothness(verdict, metric_[index(Measure::kSparc)], metric_[index(Measure::kLdlj)], {&m.path, 1});
  tell(Measure::kHold, std::min(1.0, m.hold_s / judge_.rules().hold_time));
  report_grasps(m, verdict);
  report_hold(m, verdict);
}

// Metrics without a value before the first grasp are not reported.
void GraspLesson::report_grasps(const Memory& m, const Verdict& verdict) const {
  const auto tell = [&](Measure measure, double value) {
    verdict.metric(metric_[static_cast<size_t>(measure)], value);
  };
  if (bending_.valid()) tell(Measure::kBending, m.bending);
  if (m.grasps > 0) {
    tell(Measure::kSpotError, m.spot_error_sum / m.grasps);
    tell(Measure::kInZone, m.good_grasps / m.grasps);
    tell(Measure::kSnap, m.snap_sum / m.grasps);
  }
  if (m.grip.held_s > 0) {
    tell(Measure::kTipReach, mean(m, m.reach_s));
    tell(Measure::kTiltAxis, mean(m, m.axis_s));
    tell(Measure::kTiltPlane, mean(m, m.plane_s));
    tell(Measure::kTilt, 0.5 * (mean(m, m.axis_s) + mean(m, m.plane_s)));
    tell(Measure::kBalance, mean(m, m.balance_s));
    tell(Measure::kForce, GripWatch::mean(m.grip));
    tell(Measure::kPeak, judge_.grip().peak(m.grip));
    tell(Measure::kOverTime, mean(m, m.over_s));
    tell(Measure::kOverDose, m.over_dose);
  }
  const bool lifts = params_.carry || params_.lift > 0;  // otherwise the needle need not leave its place
  if (lifts && m.lifted_s > 0) {
    tell(Measure::kSteadiness, lessons::deviation(m.spread));
    tell(Measure::kSlipRisk, m.timid_s / m.lifted_s);
  }
}

void GraspLesson::report_hold(const Memory& m, const Verdict& verdict) const {
  const auto tell = [&](Measure measure, double value) {
    verdict.metric(metric_[static_cast<size_t>(measure)], value);
  };
  if (m.best_hold_s > 0) {
    tell(Measure::kTremor, lessons::TremorWatch::rms(m.tremor));
    tell(Measure::kHoldBreaks, m.target.breaks);
  }
  if (!params_.carry || m.target.first_s < 0) return;
  tell(Measure::kHoldError, hold_error(m.target));
  tell(Measure::kInTarget, in_target(m.target));
  tell(Measure::kSettling, std::max(0.0, m.target.hold_began_s - m.target.first_s));
}

}  // namespace swage::lesson_grasp

SWAGE_EXPORT(swage::lesson_grasp::GraspLesson)
