// SPDX-License-Identifier: Apache-2.0
#include "angles_lesson.hpp"

#include "common/declare.hpp"
#include "common/rules.hpp"

namespace swage::lesson_angles {

using lessons::index;
using toolkit::raw;
using toolkit::vec;

namespace {

constexpr double kMarkRadius = 0.3e-3;  // m, drawn
// Distance of the mark from the place, along the axis that the shown object is to take, m: less than a pixel, so that it hides the answer.
constexpr double kBeside = 10e-6;

}  // namespace

void AnglesLesson::build(const AnglesParams& params, LessonBuilder& builder) {
  params_ = params;
  if (!(vec(params.sight).norm() > 0)) builder.error("sight", "the direction has no length");
  if (params.questions % static_cast<int>(kTracks) != 0)
    builder.error("questions", "must be divisible by four: there are four staircases");
  builder.state<Memory>();
  lessons::declare_card(builder, kCues, cue_, kMetrics, metric_);
  phase_[index(Stage::kShow)] = builder.phase("show", "Look at the angle.");
  phase_[index(Stage::kAsk)] = builder.phase("ask", "Close the jaws at the mark on the side to which it tilts.");
  phase_[index(Stage::kTell)] = builder.phase("tell", "Open the jaws again.");
  phase_[index(Stage::kDone)] = builder.phase("done", "The attempt is over.");
  answered_ = builder.event("angle.answered",
                            "An answer was given; value: the tilt to the right or away, rad.");
  failed_[index(End::kBiased)] =
      builder.event("failed.biased", "The bias is greater than the limit.");
  failed_[index(End::kUnsure)] = builder.event("failed.unsure", "The just-noticeable difference is greater than the limit.");
  failed_[index(End::kOutOfTime)] =
      builder.event("failed.out_of_time", "Time ran out before the questions were answered.");
}

void AnglesLesson::bind(const Scene& scene, Binder& binder) {
  gripper_ = lessons::find_gripper(scene, binder, params_.gripper, gripper_object_);
  assistant_ = lessons::find_gripper(scene, binder, params_.assistant, assistant_object_);
  needle_object_ = lessons::find_object(scene, binder, params_.needle);
  if (params_.between == Between::kSurface)
    tissue_object_ = lessons::find_object(scene, binder, params_.tissue);
  if (binder.failed()) return;
  needle_ = Peer(scene->object[needle_object_].instance);
  if (!needle_.has(SWAGE_TRAIT_PIERCING) || !needle_.graspable())
    binder.error("\"" + params_.needle + "\" is no needle: it must pierce and be graspable");
  if (params_.between == Between::kSurface) {
    tissue_ = Peer(scene->object[tissue_object_].instance);
    if (!tissue_.has(SWAGE_TRAIT_PIERCEABLE))
      binder.error("\"" + params_.tissue + "\" has no surface that could be pierced");
  }
  if (binder.failed()) return;
  point_ = binder.mark_point({0, 0, 0}, kMarkRadius, "shown.point");  // the assisting hand waits until this mark moves
  one_ = binder.mark_point(params_.answer_place, kMarkRadius, "answer.one");
  other_ = binder.mark_point(params_.answer_place, kMarkRadius, "answer.other");
}

void AnglesLesson::activate(double dt_s) {
  const AnglesParams& p = params_;
  Rules rules;
  lessons::set_common_rules(p, is_practice(), rules);
  rules.questions = p.questions;
  rules.start = p.start;
  rules.least = p.least;
  rules.show_time = p.show_time;
  rules.tell_time = p.tell_time;
  rules.reach = 0.8 * p.answer_reach;
  rules.max_bias = p.max_bias;
  rules.max_jnd = p.max_jnd;
  judge_ = Judge(rules, dt_s);
  const int32_t eyes = swage::eyes(host());
  stereo_ = eyes == SWAGE_EYES_NONE ? p.stereo : eyes == SWAGE_EYES_STEREO;
}

/// Reads the reference, the axes, and the true direction of the shown object, from its point or tips to its other end.
bool AnglesLesson::see(const View& scene, Frame& frame, Vec3& up_W) const {
  if (params_.between == Between::kSurface) {
    const auto point = needle_.place(scene.object(needle_object_), 0);
    const auto under = tissue_.inside(scene.object(tissue_object_), params_.place);
    if (!point || !under) return false;
    up_W = vec(point->tangent_W);
    frame.square = vec(under->normal_W);
  } else {
    const auto jaws = assistant_.describe(scene.object(assistant_object_));
    const auto spot = needle_.locate(scene.object(needle_object_), params_.place);
    if (!jaws || !spot) return false;
    up_W = -vec(jaws->axis_W);
    frame.square = vec(spot->normal_W);
    if (frame.square.dot(up_W) < 0) frame.square = -frame.square;
  }
  const Vec3 sight = vec(params_.sight), flat = sight - sight.dot(frame.square) * frame.square;
  frame.axis[index(Axis::kDepth)] = flat.norm() > 0 ? Vec3(flat.normalized()) : frame.square.unitOrthogonal();
  frame.axis[index(Axis::kSide)] = frame.axis[index(Axis::kDepth)].cross(frame.square);
  return true;
}

void AnglesLesson::observe(const View& scene, const Verdict& verdict, std::span<double> state) {
  auto& memory = as<Memory>(state);
  const auto jaws = gripper_.describe(scene.object(gripper_object_));
  Frame frame;
  Vec3 up_W;
  if (!jaws || !see(scene, frame, up_W)) return discard();
  Look look;
  look.time_s = scene.time();
  look.dt_s = scene.dt();
  look.tip_W = vec(jaws->tip_W);
  look.opening = jaws->opening;
  for (size_t i = 0; i < kAxes; ++i) look.lean[i] = std::asin(std::clamp(up_W.dot(frame.axis[i]), -1.0, 1.0));
  const Vec3 middle = vec(params_.answer_place);
  const Vec3 aside = params_.answer_reach * frame.axis[Judge::axis_of(memory)];
  look.one_W = middle - aside;
  look.other_W = middle + aside;

  const Finding finding = judge_.look(memory, look);
  if (finding.draw) judge_.draw(memory, random(), look.time_s);
  report(memory, finding, look.time_s, verdict);
  show(memory, finding, frame, verdict);
  say(memory, finding, verdict);
}

void AnglesLesson::show(const Memory& memory, const Finding& finding, const Frame& frame,
                        const Verdict& verdict) const {
  const size_t axis = Judge::axis_of(memory);
  const double lean = Judge::lean_of(memory);
  // a new question moves the mark of the shown object; outside the answer time both answer marks are at one place
  if (finding.draw) {
    const Vec3 up = std::cos(lean) * frame.square + std::sin(lean) * frame.axis[axis];
    const swage_vec3 way = raw(Vec3(vec(params_.place) - kBeside * up));
    verdict.mark(point_, Cue(), &way);
  }
  const bool asked = finding.stage == Stage::kAsk;
  const Vec3 middle = vec(params_.answer_place);
  const Vec3 aside = asked ? Vec3(params_.answer_reach * frame.axis[axis]) : Vec3(Vec3::Zero());
  const swage_vec3 one = raw(Vec3(middle - aside)), other = raw(Vec3(middle + aside));
  verdict.mark(one_, Cue(), &one);
  verdict.mark(other_, Cue(), &other);
}

void AnglesLesson::say(const Memory& memory, const Finding& finding, const Verdict& verdict) const {
  const uint32_t shown = params_.between == Between::kSurface ? needle_object_ : assistant_object_;
  if (finding.stage == Stage::kTell)
    verdict.cue(shown, cue_[index(memory.right != 0 ? Sign::kRight : Sign::kWrong)]);
  else
    verdict.clear_cue(shown);
  if (finding.answered) verdict.event(answered_, finding.lean);
  verdict.phase(phase_[index(finding.stage)]);
  if (finding.end == End::kRunning) return;
  if (finding.end == End::kPassed) return verdict.pass(finding.score);
  const Event reason = failed_[index(finding.end)];
  verdict.event(reason);
  verdict.fail(reason, finding.score);
}

void AnglesLesson::report(const Memory& m, const Finding& finding, double time_s,
                          const Verdict& verdict) const {
  const auto tell = [&](Measure measure, double value) { verdict.metric(metric_[index(measure)], value); };
  tell(Measure::kTime, m.path.set_off_s < 0 ? 0 : time_s - m.path.set_off_s);
  tell(Measure::kSuccess, finding.end == End::kPassed ? 1 : 0);
  tell(Measure::kStereo, stereo_ ? 1 : 0);
  tell(Measure::kPath, m.path.length);
  const double answers = Judge::answers(m);
  tell(Measure::kAnswers, answers);
  if (finding.end == End::kPassed) {
    tell(Measure::kPointsBias, finding.lost.bias);
    tell(Measure::kPointsJnd, finding.lost.jnd);
    tell(Measure::kPointsTime, finding.lost.time);
  }
  if (answers == 0) return;
  tell(Measure::kRight, m.rights / answers);
  tell(Measure::kAnswerTime, m.answer_s / answers);
  const AnswersState &side = m.axis[index(Axis::kSide)], &depth = m.axis[index(Axis::kDepth)];
  if (side.n > 0) {
    tell(Measure::kBiasSide, side.bias);
    tell(Measure::kJndSide, Answers::jnd(side));
  }
  if (depth.n > 0) {
    tell(Measure::kBiasDepth, depth.bias);
    tell(Measure::kJndDepth, Answers::jnd(depth));
  }
}

}  // namespace swage::lesson_angles

SWAGE_EXPORT(swage::lesson_angles::AnglesLesson)
