// SPDX-License-Identifier: Apache-2.0
//
// The thread of the lesson: signals of its couplings, the mark on it, and its metrics.
#include <algorithm>

#include "common/sentences.hpp"
#include "insertion_lesson.hpp"
#include "sentences.hpp"

namespace swage::lesson_insertion {

using lessons::index;

namespace {

/// Name of the first instance with a signal, "" when there is none.
std::string owner_of(const Scene& scene, std::string_view signal) {
  for (uint32_t i = 0; i < scene->n_signal; ++i)
    if (view(scene->signal[i].id) == signal) return std::string(view(scene->signal[i].owner));
  return "";
}

}  // namespace

void InsertionLesson::find_suture(const Scene& scene, Binder& binder) {
  thread_object_ = lessons::find_object(scene, binder, params_.suture);
  if (binder.failed()) return;
  thread_ = StrandPeer(Peer(scene->object[thread_object_].instance));
  if (!thread_.valid()) return binder.error(lessons::say::kNoThread(params_.suture));
  const std::string swage = owner_of(scene, "swage.tension"), pull = owner_of(scene, "pull.tail");
  if (swage.empty()) return binder.error(say::kNoTie());
  suture_.tension = scene.find_signal(swage, "swage.tension");
  suture_.pulled_off = scene.find_event(swage, "swage.pulled_off");
  if (pull.empty() && params_.tail + params_.loop > 0) return binder.error(say::kNoPull());
  if (pull.empty()) return;
  suture_.state = scene.find_signal(pull, "pull.state");
  suture_.tail = scene.find_signal(pull, "pull.tail");
  suture_.cut = scene.find_signal(pull, "pull.cut");
  suture_.back = scene.find_signal(pull, "pull.back");
  suture_.force = scene.find_signal(pull, "pull.force");
  suture_.loop = scene.find_signal(pull, "pull.loop");
  suture_.loop_least = scene.find_signal(pull, "pull.loop_least");
  suture_.loop_most = scene.find_signal(pull, "pull.loop_most");
  suture_.through = scene.find_event(pull, "pull.went_through");
}

void InsertionLesson::read_suture(const View& scene, Look& look) const {
  const auto number = [&](Signal signal) { return signal.valid() ? scene.signal(signal) : 0.0; };
  look.suture.tension = number(suture_.tension);
  look.suture.pulled_off = suture_.pulled_off.valid() && scene.happened(suture_.pulled_off);
  look.suture.through = suture_.through.valid() && scene.happened(suture_.through);
  look.suture.state = number(suture_.state);
  look.suture.tail = number(suture_.tail);
  look.suture.cut = number(suture_.cut);
  look.suture.back = number(suture_.back);
  look.suture.force = number(suture_.force);
  look.suture.loop = number(suture_.loop);
  look.suture.loop_least = number(suture_.loop_least);
  look.suture.loop_most = number(suture_.loop_most);
}

/// Shows the cue of the thread; faults take precedence over the good loop.
void InsertionLesson::say_suture(const Finding& finding, const Verdict& verdict) const {
  const Cue cue = finding.swage_held ? sign(Sign::kSwageHeld)
                  : finding.taut     ? sign(Sign::kTaut)
                  : finding.loop_good ? sign(Sign::kTailGood)
                                      : Cue();
  cue.valid() ? verdict.cue(thread_object_, cue) : verdict.clear_cue(thread_object_);
}

/// Moves the mark to the place of the thread that is to be at the entry in the end.
void InsertionLesson::show_tail(const View& scene, const Kept& kept, const Verdict& verdict) const {
  const Step thread = scene.object(thread_object_);
  const auto law = thread_.law(thread);
  if (!law) return;
  const auto at = thread_.place(thread, law->length - params_.tail);
  if (at) verdict.mark(tail_, kept.memory.suture.right_s > 0 ? sign(Sign::kTailGood) : Cue(), &at->p_W);
}

void InsertionLesson::report_suture(const Memory& m, const Verdict& verdict) const {
  const auto tell = [&](Measure measure, double value) { verdict.metric(metric_[index(measure)], value); };
  tell(Measure::kTension, m.suture.peak);
  tell(Measure::kSwageGrasps, m.suture.grasps);
  if (m.suture.drawn == 0) return;
  tell(Measure::kThreadPull, m.suture.pull_s);
  tell(Measure::kTail, m.suture.tail);
  tell(Measure::kCut, m.suture.cut);
  tell(Measure::kSawn, m.suture.back);
  if (params_.loop <= 0 || m.suture.loop_most <= 0) return;
  tell(Measure::kLoopLeast, m.suture.loop_least);
  tell(Measure::kLoopMost, m.suture.loop_most);
}

/// Reports the points deducted for several stitches and their thread.
void InsertionLesson::report_running(const Points& lost, const Verdict& verdict) const {
  const auto tell = [&](Measure measure, double value) { verdict.metric(metric_[index(measure)], value); };
  if (params_.stitches > 2) tell(Measure::kPointsEven, lost.even);
  if (params_.stitches > 1 || has_far()) tell(Measure::kPointsBites, lost.bites);
  if (has_far()) tell(Measure::kPointsStep, lost.step);
  if (params_.stitches > 1) tell(Measure::kPointsOblique, lost.oblique);
  if (params_.loop > 0) tell(Measure::kPointsLoops, lost.loops);
  if (params_.tension > 0) tell(Measure::kPointsTension, lost.tension);
}

}  // namespace swage::lesson_insertion
