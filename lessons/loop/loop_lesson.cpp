// SPDX-License-Identifier: Apache-2.0
#include "loop_lesson.hpp"

#include <algorithm>

#include "common/declare.hpp"
#include "common/report.hpp"
#include "common/rules.hpp"
#include "common/sentences.hpp"

namespace swage::lesson_loop {

using lessons::index;
using toolkit::vec;

void LoopLesson::build(const P& params, LessonBuilder& builder) {
  lessons::require_ordered(builder, "force", params.force);
  if (params.holder == params.winder) builder.error("winder", lessons::say::kTwoGrippers());
  builder.state<Memory>();
  lessons::declare_card(builder, kCues, cue_, kMetrics, metric_);
  // instruments that have the names of the defaults are called by them: of two, only one counts as the winder
  const bool named = params.holder == P().holder && params.winder == P().winder;
  phase_[index(Stage::kTake)] = builder.phase("take", named ? "Close the needleholder. Then take the thread near its free end with the forceps."
                                                            : "Take the thread with one instrument.");
  phase_[index(Stage::kWind)] =
      builder.phase("wind", named ? "Wind it about the closed tips of the needleholder." : "Wind it about the tips of the other.");
  phase_[index(Stage::kHold)] = builder.phase("hold", "Keep it drawn.");
  phase_[index(Stage::kDone)] = builder.phase("done", "The attempt is over.");
  slipped_ = builder.event("loop.slipped", "A turn has slid off the instrument or was unwound.");
  dropped_ = builder.event("thread.dropped", "The thread has got out of the jaws that held it.");
  failed_[index(End::kPassage)] = builder.event(
      "failed.passage", "The simulation has let the thread go through itself or the instrument: what was wound is not to be trusted.");
  failed_[index(End::kBroken)] = builder.event("failed.broken", "The thread has broken.");
  failed_[index(End::kDropped)] = builder.event("failed.dropped", "The thread got out of the jaws too often.");
  failed_[index(End::kTooHard)] = builder.event("failed.too_hard", "The thread was gripped too hard for too long.");
  failed_[index(End::kOutOfTime)] = builder.event("failed.out_of_time", "Time ran out before the thread was wound and kept drawn.");
}

void LoopLesson::bind(const Scene& scene, Binder& binder) {
  const P& p = params();
  holder_ = lessons::find_gripper(scene, binder, p.holder, holder_object_);
  winder_ = lessons::find_gripper(scene, binder, p.winder, winder_object_);
  thread_object_ = lessons::find_object(scene, binder, p.thread);
  grasp_ = lessons::find_grasp(scene, binder, p.grasp);
  const auto signal = [&](const std::string& owner, const char* wanted) {
    const Signal found = scene.find_signal(owner, wanted);
    if (!found.valid()) binder.missing(scene, "signal", owner, wanted, lessons::say::kWatched());
    return found;
  };
  turns_ = signal(p.winding, "winding.turns");
  whole_ = signal(p.winding, "winding.whole");
  behind_ = signal(p.winding, "winding.behind");
  through_ = signal(p.winding, "winding.passages");
  through_itself_ = signal(p.thread, "thread.passed");
  draw_ = signal(p.touch, "contact.force");
  tension_ = signal(p.thread, "thread.tension_first");
  parted_ = signal(p.thread, "thread.parted");
}

void LoopLesson::activate(double dt_s) {
  const P& p = params();
  Rules rules;
  lessons::set_common_rules(p, is_practice(), rules);
  rules.turns = p.turns;
  rules.sense = p.sense == Sense::kEither ? 0 : p.sense == Sense::kRight ? 1 : -1;
  rules.least_draw = p.least_draw;
  rules.tension = p.tension;
  judge_ = Judge(rules, dt_s);
}

bool LoopLesson::read(const View& view, Look& look) const {
  look.time_s = view.time();
  look.dt_s = view.dt();
  const auto holder = holder_.describe(view.object(holder_object_)), winder = winder_.describe(view.object(winder_object_));
  if (!holder || !winder) return false;
  look.tip_W[0] = vec(holder->tip_W);
  look.tip_W[1] = vec(winder->tip_W);
  look.held = view.signal(grasp_.held) != 0;
  look.force = view.signal(grasp_.force);
  look.turns = view.signal(turns_);
  look.whole = view.signal(whole_);
  look.behind = view.signal(behind_);
  look.draw = view.signal(draw_);
  look.tension = view.signal(tension_);
  look.parted = view.signal(parted_);
  look.passages = view.signal(through_) + view.signal(through_itself_);
  return true;
}

void LoopLesson::observe(const View& view, const Verdict& verdict, std::span<double> state) {
  Look look;
  auto& memory = as<Memory>(state);
  if (!read(view, look)) return discard();
  const Finding finding = judge_.look(memory, look);
  report(memory, look, verdict);
  if (finding.end == End::kPassed) report_points(finding.lost, verdict);
  say(finding, verdict);
}

void LoopLesson::say(const Finding& finding, const Verdict& verdict) const {
  const auto show = [&](uint32_t object, bool is, Sign sign) {
    is ? verdict.cue(object, cue_[index(sign)]) : verdict.clear_cue(object);
  };
  show(thread_object_, finding.held, finding.taut ? Sign::kTaut : Sign::kHeld);
  show(winder_object_, finding.too_hard, Sign::kTooHard);
  const Sign turns = finding.end == End::kPassed ? Sign::kDone : finding.too_many ? Sign::kTooMany : Sign::kOn;
  show(holder_object_, finding.on || finding.too_many, turns);
  if (finding.slipped) verdict.event(slipped_);
  if (finding.dropped) verdict.event(dropped_);
  verdict.phase(phase_[index(finding.stage)]);

  if (finding.end == End::kRunning) return;
  if (finding.end == End::kPassed) return verdict.pass(finding.score);
  const Event reason = failed_[index(finding.end)];
  verdict.event(reason);
  verdict.fail(reason, finding.score);
}

void LoopLesson::report(const Memory& m, const Look& look, const Verdict& verdict) const {
  tell(verdict, Measure::kTime, Judge::task_time(m, look.time_s));
  tell(verdict, Measure::kSuccess, m.passed);
  tell(verdict, Measure::kTurns, look.turns);
  tell(verdict, Measure::kMostTurns, m.most_turns);
  tell(verdict, Measure::kSlips, m.slips);
  tell(verdict, Measure::kDrops, m.drops);
  tell(verdict, Measure::kPath, m.path[0].length + m.path[1].length);
  lessons::report_smoothness(verdict, metric_[index(Measure::kSparc)], metric_[index(Measure::kLdlj)], m.path);
  tell(verdict, Measure::kHold, std::min(1.0, m.hold_s / judge_.rules().hold_time));
  tell(verdict, Measure::kPassages, m.passages);
  if (m.on_s > 0) tell(verdict, Measure::kPlace, m.behind_s / m.on_s);
  if (m.held_s > 0) report_held(m, verdict);
}

// Metrics without a value before the thread was held are not reported.
void LoopLesson::report_held(const Memory& m, const Verdict& verdict) const {
  tell(verdict, Measure::kTension, judge_.pull().peak(m.pull));
  tell(verdict, Measure::kTaut, m.taut_s / m.held_s);
  tell(verdict, Measure::kForce, lessons::GripWatch::mean(m.grip));
  tell(verdict, Measure::kPeak, judge_.grip().peak(m.grip));
  tell(verdict, Measure::kOverTime, m.over_s / m.held_s);
}

void LoopLesson::report_points(const Points& lost, const Verdict& verdict) const {
  tell(verdict, Measure::kPointsSlips, lost.slips);
  tell(verdict, Measure::kPointsDrops, lost.drops);
  tell(verdict, Measure::kPointsTension, lost.tension);
  tell(verdict, Measure::kPointsForce, lost.force);
  tell(verdict, Measure::kPointsTime, lost.time);
}

}  // namespace swage::lesson_loop

SWAGE_EXPORT(swage::lesson_loop::LoopLesson)
