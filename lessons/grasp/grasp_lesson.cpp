// SPDX-License-Identifier: Apache-2.0
#include "grasp_lesson.hpp"

#include <algorithm>

namespace swage::lesson_grasp {

using toolkit::vec;

void GraspLesson::build(const GraspParams& params, LessonBuilder& builder) {
  params_ = params;
  const auto ordered = [&](const char* key, const Interval& range) {
    if (range.low >= range.high) builder.error(key, "the first number must be below the second");
  };
  ordered("region", params.region);
  ordered("tip_zone", params.tip_zone);
  ordered("force", params.force);
  builder.state<Memory>();
  declare_cues(builder);
  declare_metrics(builder);
}

void GraspLesson::declare_cues(LessonBuilder& builder) {
  const auto index = [](auto value) { return static_cast<size_t>(value); };
  cue_[index(Grade::kWrong)] = builder.cue("grasp.wrong", "Held at the wrong place, and not with the tips.");
  cue_[index(Grade::kTipsOnly)] =
      builder.cue("grasp.tips_only", "Held with the tips, but at the wrong place.");
  cue_[index(Grade::kPointOnly)] =
      builder.cue("grasp.point_only", "Held at the right place, but not with the tips.");
  cue_[index(Grade::kGood)] = builder.cue("grasp.good", "Held at the right place and with the tips.");
  too_hard_ = builder.cue("grip.too_hard", "The grip force is above the limit.");

  phase_[index(Stage::kApproach)] = builder.phase("approach", "Bring the open jaws to the needle.");
  phase_[index(Stage::kGrasp)] = builder.phase("grasp", "Close the jaws on the region.");
  phase_[index(Stage::kHold)] = builder.phase("hold", "Hold it with measured force.");
  phase_[index(Stage::kDone)] = builder.phase("done", "The attempt is over.");

  dropped_ = builder.event("needle.dropped", "The needle has left where it was held or lay.");
  hold_began_ = builder.event("hold.began", "All that is asked of a hold is fulfilled from here on.");
  hold_broke_ = builder.event("hold.broke", "Something that is asked of a hold is no longer fulfilled.");
  failed_[index(End::kDropped)] = builder.event("failed.dropped", "The needle was dropped too often.");
  failed_[index(End::kTooHard)] =
      builder.event("failed.too_hard", "The needle was held too hard for too long.");
  failed_[index(End::kOutOfTime)] =
      builder.event("failed.out_of_time", "The time was over before the hold was.");
}

void GraspLesson::declare_metrics(LessonBuilder& b) {
  metric_.time = b.metric("time.task", "s", "Time since the hand set off (M01).");
  metric_.tries =
      b.metric("grasp.tries", "1", "Closings of the jaws that touch, up to the first correct grasp (M06).");
  metric_.drops = b.metric("grasp.drops", "1", "How often the needle was dropped or knocked away (M07).");
  metric_.regrasps = b.metric("grasp.regrasps", "1", "Grasps after the first correct one (M08).");
  metric_.spot_error =
      b.metric("grasp.spot_error", "1", "Mean distance from the region, share of the needle (M09).");
  metric_.in_zone = b.metric("grasp.in_zone", "1", "Share of grasps that were in the region (M10).");
  metric_.tip_reach =
      b.metric("grasp.tip_reach", "m", "Mean reach of the tips past the needle while held (M11).");
  metric_.tilt_axis =
      b.metric("grasp.tilt_axis", "rad", "Mean lean of the needle against the jaw axis (M12).");
  metric_.tilt_plane =
      b.metric("grasp.tilt_plane", "rad", "Mean lean of its plane against the jaw faces (M12).");
  metric_.balance =
      b.metric("grasp.balance", "1", "Mean difference of the jaws, share of the harder one (M13).");
  metric_.snap =
      b.metric("grasp.snap", "rad", "Mean turn of the needle from touch to 0.1 s after the grasp (M14).");
  metric_.force = b.metric("force.mean", "N", "Mean grip force while held, below 20 Hz (M15).");
  metric_.peak = b.metric("force.peak", "N", "Greatest grip force, below 20 Hz (M16).");
  metric_.over_time = b.metric("force.over_time", "1", "Share of the held time above the limit (M18).");
  metric_.over_dose = b.metric("force.over_dose", "N*s", "Excess over the limit, summed over time (M19).");
  metric_.path = b.metric("motion.path", "m", "Way of the tips, below 6 Hz (M22).");
  metric_.hold = b.metric("hold.progress", "1", "Share of the hold that is done, 0 after a break.");
}

void GraspLesson::bind(const Scene& scene, Binder& binder) {
  gripper_ = lessons::find_gripper(scene, binder, params_.gripper, gripper_object_);
  needle_object_ = lessons::find_object(scene, binder, params_.needle);
  const std::vector<std::string> owners = lessons::grasp_owners(scene);
  if (owners.empty()) {
    binder.error("nothing in the scene tells about a grasp; add to \"couplings\" a \"swage.coupling.grasp\"");
  }
  if (binder.failed()) return;
  grasp_ = lessons::find_grasp(scene, binder, owners.front());
  const swage_scene_object& needle = scene->object[needle_object_];
  if (needle.n_body == 0) return binder.error("\"" + params_.needle + "\" has no body that could be taken");
  needle_body_ = needle.first_body;
  region_ = binder.mark_arc(needle_object_, params_.region.low, params_.region.high, "region.target");
}

void GraspLesson::activate(double dt_s) {
  const GraspParams& p = params_;
  Rules rules;
  rules.region_low = p.region.low;
  rules.region_high = p.region.high;
  rules.tip_low = p.tip_zone.low;
  rules.tip_high = p.tip_zone.high;
  rules.tips_needed = p.tips_needed;
  rules.force_low = p.force.low;
  rules.force_high = p.force.high;
  rules.lift = p.lift;
  rules.hold_time = p.hold_time;
  rules.par_time = p.par_time;
  rules.max_time = p.max_time;
  rules.max_over_time = p.max_over_time;
  rules.max_drops = p.max_drops;
  rules.drop_distance = p.drop_distance;
  judge_ = Judge(rules, dt_s);
}

bool GraspLesson::read(const View& view, Look& look) const {
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
  return true;
}

void GraspLesson::observe(const View& view, const Verdict& verdict, std::span<double> state) {
  Look look;
  if (!read(view, look)) return discard();
  auto& memory = as<Memory>(state);
  const Finding finding = judge_.look(memory, look);
  report(memory, look.time_s, verdict);
  say(finding, verdict);
}

void GraspLesson::say(const Finding& finding, const Verdict& verdict) const {
  // signs
  const Cue held = cue_[static_cast<size_t>(finding.grade)];
  held.valid() ? verdict.cue(needle_object_, held) : verdict.clear_cue(needle_object_);
  finding.too_hard ? verdict.cue(gripper_object_, too_hard_) : verdict.clear_cue(gripper_object_);

  // what happened
  if (finding.dropped) verdict.event(dropped_);
  if (finding.hold_began) verdict.event(hold_began_);
  if (finding.hold_broke) verdict.event(hold_broke_);
  verdict.phase(phase_[static_cast<size_t>(finding.stage)]);

  // the end
  if (finding.end == End::kRunning) return;
  if (finding.end == End::kPassed) return verdict.pass(finding.score);
  const Event reason = failed_[static_cast<size_t>(finding.end)];
  verdict.event(reason);
  verdict.fail(reason, finding.score);
}

void GraspLesson::report(const Memory& m, double time_s, const Verdict& verdict) const {
  const double grasps = std::max(1.0, m.grasps);
  verdict.metric(metric_.time, task_time(m, time_s));
  verdict.metric(metric_.tries, m.tries);
  verdict.metric(metric_.drops, m.drops);
  verdict.metric(metric_.regrasps, m.regrasps);
  verdict.metric(metric_.spot_error, m.spot_error_sum / grasps);
  verdict.metric(metric_.in_zone, m.good_grasps / grasps);
  verdict.metric(metric_.tip_reach, mean(m, m.reach_s));
  verdict.metric(metric_.tilt_axis, mean(m, m.axis_s));
  verdict.metric(metric_.tilt_plane, mean(m, m.plane_s));
  verdict.metric(metric_.balance, mean(m, m.balance_s));
  verdict.metric(metric_.snap, m.snap_sum / grasps);
  verdict.metric(metric_.force, mean(m, m.force_s));
  verdict.metric(metric_.peak, m.peak);
  verdict.metric(metric_.over_time, mean(m, m.over_s));
  verdict.metric(metric_.over_dose, m.over_dose);
  verdict.metric(metric_.path, m.path.length);
  verdict.metric(metric_.hold, std::min(1.0, m.hold_s / judge_.rules().hold_time));
}

}  // namespace swage::lesson_grasp

SWAGE_EXPORT(swage::lesson_grasp::GraspLesson)
