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

/// Names of the instances with a signal, in the order of the lesson file.
std::vector<std::string> owners_of(const Scene& scene, std::string_view signal) {
  std::vector<std::string> owners;
  for (uint32_t i = 0; i < scene->n_signal; ++i)
    if (view(scene->signal[i].id) == signal) owners.emplace_back(view(scene->signal[i].owner));
  return owners;
}

}  // namespace

void InsertionLesson::find_suture(const Scene& scene, Binder& binder) {
  thread_object_ = lessons::find_object(scene, binder, params_.suture);
  if (binder.failed()) return;
  thread_ = StrandPeer(Peer(scene->object[thread_object_].instance));
  if (!thread_.valid()) return binder.error(lessons::say::kNoThread(params_.suture));
  const std::vector<std::string> swages = owners_of(scene, "swage.tension"), pulls = owners_of(scene, "pull.tail");
  if (swages.empty()) return binder.error(say::kNoTie());
  const std::string swage = swages.front(), pull = pulls.empty() ? "" : pulls.front();
  suture_.tension = scene.find_signal(swage, "swage.tension");
  suture_.pulled_off = scene.find_event(swage, "swage.pulled_off");
  if (pull.empty() && (params_.tail + params_.loop > 0 || has_cut())) return binder.error(say::kNoPull());
  if (pull.empty()) return;
  suture_.state = scene.find_signal(pull, "pull.state");
  suture_.tail = scene.find_signal(pull, "pull.tail");
  suture_.cut = scene.find_signal(pull, "pull.cut");
  suture_.back = scene.find_signal(pull, "pull.back");
  suture_.pull = scene.find_signal(has_far() ? pulls.back() : pull, "pull.tension_out");
  suture_.loop = scene.find_signal(pull, "pull.loop");
  suture_.loop_least = scene.find_signal(pull, "pull.loop_least");
  suture_.loop_most = scene.find_signal(pull, "pull.loop_most");
  suture_.through = scene.find_event(pull, "pull.went_through");
  if (has_cut()) find_cut(scene, binder, pulls);
}

/// Of two edges the coupling of the near one comes first.
void InsertionLesson::find_cut(const Scene& scene, Binder& binder, const std::vector<std::string>& pulls) {
  const auto signal = [&](const std::string& owner, const char* what) {
    const Signal found = scene.find_signal(owner, what);
    if (!found.valid()) binder.missing(scene, "signal", owner, what, lessons::say::kWatched());
    return found;
  };
  suture_.entry = signal(pulls.front(), "pull.drawn");
  suture_.exit = signal(has_far() ? pulls.back() : pulls.front(), "pull.out");
  suture_.parted = scene.find_event(params_.cut, "cut.parted");
  if (!suture_.parted.valid()) binder.missing(scene, "event", params_.cut, "cut.parted", lessons::say::kWatched());
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
  look.suture.pull = std::max(0.0, number(suture_.pull));
  look.suture.loop = number(suture_.loop);
  look.suture.loop_least = number(suture_.loop_least);
  look.suture.loop_most = number(suture_.loop_most);
  if (has_cut()) read_cut(scene, look);
}

void InsertionLesson::read_cut(const View& scene, Look& look) const {
  const auto law = thread_.law(scene.object(thread_object_));
  if (law) look.suture.length = law->length;
  look.suture.entry = scene.signal(suture_.entry);
  look.suture.exit = scene.signal(suture_.exit);
  for (const swage_view_event& event : scene.events())
    if (event.event == suture_.parted) look.suture.parted = true, look.suture.parted_at = event.value;
}

/// Shows the cue of the thread; faults take precedence over the good loop.
void InsertionLesson::say_suture(const Finding& finding, const Verdict& verdict) const {
  const Cue cue = finding.swage_held ? sign(Sign::kSwageHeld)
                  : finding.taut     ? sign(Sign::kTaut)
                  : finding.loop_good ? sign(Sign::kTailGood)
                                      : Cue();
  cue.valid() ? verdict.cue(thread_object_, cue) : verdict.clear_cue(thread_object_);
}

/// Moves the mark to the place of the thread that is to be at the entry in the end; once it is there, to the place of the cut.
void InsertionLesson::show_tail(const View& scene, const Kept& kept, const Verdict& verdict) const {
  const Step thread = scene.object(thread_object_);
  const auto law = thread_.law(thread);
  if (!law) return;
  const SutureState& suture = kept.memory.suture;
  const double end = has_cut() && suture.cut_off.end > 0 ? suture.cut_off.end : law->length;
  const bool to_cut = has_cut() && kept.memory.through != 0 && SutureWatch::drawn(judge_.rules().suture, suture);
  const auto at = thread_.place(thread, (to_cut ? scene.signal(suture_.exit) : end) - params_.tail);
  if (at) verdict.mark(tail_, suture.right_s > 0 ? sign(Sign::kTailGood) : Cue(), &at->p_W);
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
  if (has_cut()) report_tails(m, verdict);
  if (params_.loop <= 0 || m.suture.loop_most <= 0) return;
  tell(Measure::kLoopLeast, m.suture.loop_least);
  tell(Measure::kLoopMost, m.suture.loop_most);
}

void InsertionLesson::report_tails(const Memory& m, const Verdict& verdict) const {
  const auto tell = [&](Measure measure, double value) { verdict.metric(metric_[index(measure)], value); };
  tell(Measure::kCutsAstray, m.suture.cut_off.astray);
  if (m.suture.cut_off.most <= 0) return;
  tell(Measure::kTailLeast, m.suture.cut_off.least);
  tell(Measure::kTailMost, m.suture.cut_off.most);
}

/// Reports the points deducted for several stitches and their thread.
void InsertionLesson::report_running(const Points& lost, const Verdict& verdict) const {
  const auto tell = [&](Measure measure, double value) { verdict.metric(metric_[index(measure)], value); };
  if (params_.stitches > 2) tell(Measure::kPointsEven, lost.even);
  if (params_.stitches > 1 || has_far()) tell(Measure::kPointsBites, lost.bites);
  if (has_far()) tell(Measure::kPointsStep, lost.step);
  if (params_.stitches > 1) tell(Measure::kPointsOblique, lost.oblique);
  if (params_.loop > 0) tell(Measure::kPointsLoops, lost.loops);
  if (has_cut()) tell(Measure::kPointsTails, lost.tails);
  if (params_.tension > 0) tell(Measure::kPointsTension, lost.tension);
}

}  // namespace swage::lesson_insertion
