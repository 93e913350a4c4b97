// SPDX-License-Identifier: Apache-2.0
//
// The far edge of the wound: signals of the coupling that pierces it, and its metrics.
#include "insertion_lesson.hpp"
#include "sentences.hpp"

namespace swage::lesson_insertion {

using lessons::index;
using toolkit::vec;

void InsertionLesson::find_far(const Scene& scene, Binder& binder) {
  far_object_ = lessons::find_object(scene, binder, params_.far);
  if (binder.failed()) return;
  far_ = Peer(scene->object[far_object_].instance);
  if (!far_.has(SWAGE_TRAIT_PIERCEABLE)) return binder.error(say::kNotPierced(params_.far));
  far_pierce_ = find_pierce(scene, binder, params_.far_pierce);
}

void InsertionLesson::read_far(const View& scene, const Kept& kept, const swage_gripper_state& jaws, Look& look) const {
  const auto number = [&](Signal signal) { return scene.signal(signal); };
  constexpr double kIn = 2, kOut = 3;  // of pierce.state
  const Step needle = scene.object(needle_object_), edge = scene.object(far_object_);
  FarLook& far = look.far;
  const double state = number(far_pierce_.state);
  far.in_tissue = state >= kIn;
  far.entered = scene.happened(far_pierce_.entered);
  far.passed = scene.happened(far_pierce_.passed);
  far.deflected = scene.happened(far_pierce_.deflected);
  far.exit_angle = exit_angle(scene, far_pierce_);
  far.exited = far.exit_angle >= 0;
  far.angle = number(far_pierce_.angle);
  far.cosine = number(far_pierce_.cosine);
  far.s = number(far_pierce_.s);
  far.wound = number(far_pierce_.wound);
  if (far_pierce_.exit_wound.valid()) far.exit_wound = number(far_pierce_.exit_wound);
  far.pull = number(far_pierce_.pull);
  far.entry_W = place(scene, far_pierce_.entry);
  const Vec3 out_W = place(scene, far_pierce_.exit);
  if (far.entered || far.exited) far.hole = hole(far_, edge, far.exited ? out_W : far.entry_W);

  Region region;
  region.middle[0] = far.in_tissue ? far.entry_W : Vec3(Eigen::Map<const Vec3>(kept.exit));
  region.normal = look.normal_W;
  region.radius = params_.tolerance;
  if (far.in_tissue) {
    region.s_in = far.s;
    if (state >= kOut) region.middle[region.count++] = out_W;
    region.s_out = state >= kOut ? far.s - number(far_pierce_.depth) / look.length : 0;
    if (const auto nearest = needle_.nearest(needle, toolkit::raw(far.entry_W))) far.arc_error = (vec(nearest->p_W) - far.entry_W).norm();
  }
  far.needle_astray = needle_astray(needle_, needle, far_, edge, region);
  const auto origin = [&](uint32_t body) { return vec(scene.pose(gripper_body_ + body).p); };
  far.jaws_astray = jaws_astray(jaws, {origin(jaws.left_body), origin(jaws.right_body)}, far_, edge);
}

void InsertionLesson::report_far(const Look& look, const Memory& m, const Verdict& verdict) const {
  const auto tell = [&](Measure measure, double value) { verdict.metric(metric_[index(measure)], value); };
  if (m.far.near_out != 0) tell(Measure::kInnerNear, m.far.near_edge / look.diameter);
  if (m.far.in == 0) return;
  tell(Measure::kInnerFar, m.far.far_edge / look.diameter);
  tell(Measure::kStep, FarEdge::step(m.far));
  tell(Measure::kFarAngle, m.far.entry_angle);
  tell(Measure::kFarWound, look.far.wound);
}

}  // namespace swage::lesson_insertion
