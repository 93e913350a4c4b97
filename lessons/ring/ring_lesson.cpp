// SPDX-License-Identifier: Apache-2.0
#include "ring_lesson.hpp"

#include <algorithm>

#include "common/declare.hpp"
#include "common/names.hpp"
#include "common/report.hpp"
#include "common/rules.hpp"
#include "common/sentences.hpp"

namespace swage::lesson_ring {

using lessons::index;
using toolkit::vec;

void RingLesson::build(const RingParams& params, LessonBuilder& builder) {
  params_ = params;
  lessons::require_ordered(builder, "course", params.course);
  lessons::require_ordered(builder, "force", params.force);
  if (lessons::names_in(params.posts).size() > kMostPosts) builder.error("posts", "at most four names are allowed");
  builder.state<Memory>();
  lessons::declare_card(builder, kCues, cue_, kMetrics, metric_);

  phase_[index(Stage::kTake)] = builder.phase("take", "Grasp the ring by its rim and lift it off the wire.");
  phase_[index(Stage::kCarry)] = builder.phase("carry", "Carry it along the wire; the wire stays in its middle.");
  phase_[index(Stage::kPost)] = builder.phase("post", "Lower it over the marked post.");
  phase_[index(Stage::kDone)] = builder.phase("done", "The attempt is over.");

  dropped_ = builder.event("ring.dropped", "The ring has left where it was held or lay.");
  touched_ = builder.event("ring.touched", "The ring or the instrument has touched what it should not; value: the force.");
  post_done_ = builder.event("ring.post", "The ring has been over a post; value: which, from 1.");
  const auto failure = [&](End end, const char* event, const char* doc) {
    failed_[index(end)] = builder.event(event, doc);
  };
  failure(End::kTouched, "failed.touched", "The wire or a post was touched too often.");
  failure(End::kDropped, "failed.dropped", "The ring was dropped too often.");
  failure(End::kTooHard, "failed.too_hard", "The ring was held too hard for too long.");
  failure(End::kOutOfTime, "failed.out_of_time", "Time ran out before the ring was over the last post.");
  failure(End::kLost, "failed.lost", "The ring has gone where nobody can reach it.");
}

RingLesson::Thing RingLesson::find_thing(const Scene& scene, Binder& binder, const std::string& called) const {
  Thing thing;
  thing.object = lessons::find_object(scene, binder, called);
  if (thing.object == kNone) return thing;
  thing.peer = Peer(scene->object[thing.object].instance);
  if (!thing.peer.graspable())
    binder.error("\"" + called + "\" cannot be asked where it is nearest to the ring");
  return thing;
}

void RingLesson::find_touches(const Scene& scene, Binder& binder) {
  touch_.clear();
  for (const std::string& owner : lessons::names_in(params_.touches)) {
    const Signal force = scene.find_signal(owner, "contact.force");
    if (!force.valid()) binder.missing(scene, "signal", owner, "contact.force", lessons::say::kWatched());
    touch_.push_back(force);
  }
  if (touch_.empty())
    binder.error("\"touches\" names no coupling; without one nothing tells that the ring has touched");
}

void RingLesson::bind(const Scene& scene, Binder& binder) {
  gripper_ = lessons::find_gripper(scene, binder, params_.gripper, gripper_object_);
  ring_ = find_thing(scene, binder, params_.ring);
  wire_ = find_thing(scene, binder, params_.wire);
  posts_.clear();
  for (const std::string& post : lessons::names_in(params_.posts)) posts_.push_back(find_thing(scene, binder, post));
  find_touches(scene, binder);
  const std::vector<std::string> owners = lessons::grasp_owners(scene);
  if (owners.empty()) binder.error(lessons::say::kNoGrasp());
  if (binder.failed()) return;
  grasp_ = lessons::find_grasp(scene, binder, owners.front());
  if (scene->object[ring_.object].n_body == 0) return binder.error(lessons::say::kNotTaken(params_.ring));
  ring_body_ = scene->object[ring_.object].first_body;
  constexpr double kMark = 0.3e-3;  // m, drawn on top of the post
  if (!posts_.empty()) target_ = binder.mark_point({0, 0, 0}, kMark, "target.point");
}

void RingLesson::activate(double dt_s) {
  const RingParams& p = params_;
  Rules rules;
  lessons::set_common_rules(p, is_practice(), rules);
  rules.course_low = p.course.low;
  rules.course_high = p.course.high;
  rules.posts = static_cast<int>(posts_.size());
  rules.max_touches = p.max_touches;
  judge_ = Judge(rules, dt_s);
}

/// Finds the nearest place of a wire or post.
bool RingLesson::see(const View& view, const Thing& thing, const Vec3& axis_W, Look& look, Line& line) const {
  const auto place = thing.peer.locate(view.object(thing.object), toolkit::raw(look.ring_W));
  if (!place) return false;
  line.s = place->s;
  line.distance = (vec(place->p_W) - look.ring_W).norm();
  line.cosine = std::abs(axis_W.dot(vec(place->tangent_W)));
  if (&line == &look.wire) look.wire_length = place->length;
  return true;
}

bool RingLesson::read(const View& view, const Memory& memory, Look& look) const {
  const auto jaws = gripper_.describe(view.object(gripper_object_));
  if (!jaws) return false;
  look.time_s = view.time();
  look.dt_s = view.dt();
  look.held = view.signal(grasp_.held) != 0;
  look.taken = view.happened(grasp_.taken);
  look.force = view.signal(grasp_.force);
  look.tip_W = vec(jaws->tip_W);
  look.ring_W = vec(view.pose(ring_body_).p);
  for (const Signal& touch : touch_) look.touch += view.signal(touch);
  // any place on the centre line gives the ring's radius
  const auto rim = ring_.peer.locate(view.object(ring_.object), toolkit::raw(look.ring_W));
  if (!rim) return false;
  look.ring_radius = (vec(rim->p_W) - look.ring_W).norm();
  const Vec3 axis_W = vec(rim->normal_W);
  const auto post = static_cast<size_t>(memory.posts);
  if (post < posts_.size() && !see(view, posts_[post], axis_W, look, look.post)) return false;
  return see(view, wire_, axis_W, look, look.wire);
}

/// Where the course of the wire ends: walks along its tangents from the place nearest to `from_W`.
Vec3 RingLesson::end_of_wire(const View& view, const Vec3& from_W) const {
  constexpr double kStride = 0.5e-3;  // m, below the radius of any bend
  constexpr int kStrides = 200;       // 0.1 m of wire
  Vec3 at = from_W, end = from_W;
  double s = -1;
  for (int i = 0; i < kStrides; ++i) {
    const auto place = wire_.peer.locate(view.object(wire_.object), toolkit::raw(at));
    if (!place || place->s <= s) break;
    end = vec(place->p_W);
    if (place->s >= params_.course.high) break;
    s = place->s;
    at = end + kStride * vec(place->tangent_W);
  }
  return end;
}

/// Where the ring goes next: to the end of the wire, and from there to the top of the next post, or of the last one.
bool RingLesson::next_place(const View& view, const Memory& memory, swage_vec3& p_W) const {
  if (memory.free == 0) return p_W = toolkit::raw(Vec3(Eigen::Map<const Vec3>(memory.wire_end))), true;
  const Thing& post = posts_[std::min(static_cast<size_t>(memory.posts), posts_.size() - 1)];
  constexpr double kFarUp = 1;  // m, height from which the top is the nearest place
  const auto top = post.peer.locate(view.object(post.object), toolkit::raw(Vec3(0, 0, kFarUp)));
  if (top) p_W = top->p_W;
  return top.has_value();
}

void RingLesson::observe(const View& view, const Verdict& verdict, std::span<double> state) {
  auto& memory = as<Memory>(state);
  Look look;
  if (!read(view, memory, look)) return discard();
  if (memory.begun == 0) Eigen::Map<Vec3>(memory.wire_end) = end_of_wire(view, look.ring_W);
  const Finding finding = judge_.look(memory, look);
  report(memory, look.time_s, verdict);
  if (finding.end == End::kPassed) report_points(finding.lost, verdict);
  if (finding.touched) verdict.event(touched_, look.touch);
  if (finding.dropped) verdict.event(dropped_);
  if (finding.post_done) verdict.event(post_done_, memory.posts);
  say(view, memory, finding, verdict);
}

void RingLesson::say(const View& view, const Memory& memory, const Finding& finding, const Verdict& verdict) const {
  const auto sign = [&](Sign s) { return cue_[index(s)]; };
  if (finding.carried)
    verdict.cue(ring_.object, sign(finding.touching ? Sign::kTouching : Sign::kClear));
  else
    verdict.clear_cue(ring_.object);
  finding.too_hard ? verdict.cue(gripper_object_, sign(Sign::kTooHard)) : verdict.clear_cue(gripper_object_);
  swage_vec3 p_W{};
  if (!posts_.empty() && next_place(view, memory, p_W)) {
    Cue cue = finding.over_post ? sign(Sign::kNear) : Cue();
    if (finding.end == End::kPassed) cue = sign(Sign::kDone);
    verdict.mark(target_, cue, &p_W);
  }
  verdict.phase(phase_[index(finding.stage)]);

  if (finding.end == End::kRunning) return;
  if (finding.end == End::kPassed) return verdict.pass(finding.score);
  const Event reason = failed_[index(finding.end)];
  verdict.event(reason);
  verdict.fail(reason, finding.score);
}

// Metrics without a value before the ring was carried are not reported.
void RingLesson::report(const Memory& m, double time_s, const Verdict& verdict) const {
  const auto tell = [&](Measure measure, double value) { verdict.metric(metric_[index(measure)], value); };
  tell(Measure::kTime, task_time(m, time_s));
  tell(Measure::kSuccess, m.passed);
  tell(Measure::kTouches, m.touches);
  tell(Measure::kDrops, m.drops);
  tell(Measure::kRegrasps, std::max(0.0, m.grasps - 1));
  tell(Measure::kPath, m.path.length);
  lessons::report_smoothness(verdict, metric_[index(Measure::kSparc)], metric_[index(Measure::kLdlj)], {&m.path, 1});
  tell(Measure::kProgress, m.free != 0 ? 1 : m.reached);
  tell(Measure::kPosts, m.posts);
  if (m.grip.held_s > 0) {
    tell(Measure::kForce, GripWatch::mean(m.grip));
    tell(Measure::kPeak, judge_.grip().peak(m.grip));
    tell(Measure::kOverTime, over_share(m));
  }
  if (m.carried_s > 0) {
    tell(Measure::kTouchTime, touch_share(m));
    tell(Measure::kTouchPeak, m.touch_peak);
    tell(Measure::kTremor, lessons::TremorWatch::rms(m.tremor));
  }
  if (m.travel > 0) {
    tell(Measure::kOffCentre, by_way(m, m.off2));
    tell(Measure::kTilt, by_way(m, m.tilt2));
  }
}

void RingLesson::report_points(const Points& lost, const Verdict& verdict) const {
  const auto tell = [&](Measure measure, double value) { verdict.metric(metric_[index(measure)], value); };
  tell(Measure::kPointsTouches, lost.touches);
  tell(Measure::kPointsTouchTime, lost.touch_time);
  tell(Measure::kPointsDrops, lost.drops);
  tell(Measure::kPointsForce, lost.force);
  tell(Measure::kPointsTime, lost.time);
}

}  // namespace swage::lesson_ring

SWAGE_EXPORT(swage::lesson_ring::RingLesson)
