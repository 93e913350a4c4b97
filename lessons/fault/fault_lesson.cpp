// SPDX-License-Identifier: Apache-2.0
#include "fault_lesson.hpp"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "common/declare.hpp"
#include "common/rules.hpp"
#include "common/sentences.hpp"

namespace swage::lesson_fault {

using lessons::index;
using toolkit::raw;
using toolkit::vec;

namespace {

constexpr double kShownRadius = 1e-3, kAnswerRadius = 0.3e-3;  // m, drawn
constexpr const char* kAnswers[] = {"answer.square", "answer.granny", "answer.sliding", "answer.loose"};
static_assert(std::size(kAnswers) == kKnots);

}  // namespace

void FaultLesson::build(const P& params, LessonBuilder& builder) {
  std::istringstream names(params.threads);
  for (std::string one; names >> one;) names_.push_back(one);
  if (names_.empty()) builder.error("threads", "no thread is named");
  if (params.least_right > static_cast<int>(names_.size())) builder.error("least_right", "there are not so many knots");
  if (!(vec(params.answer_step).norm() > params.answer_reach)) builder.error("answer_step", "two answers are nearer than answer_reach");
  builder.state<Memory>();
  lessons::declare_card(builder, kCues, cue_, kMetrics, metric_);
  const auto phase = [&](Stage stage, const char* key, const char* doc) { phase_[index(stage)] = builder.phase(key, doc); };
  phase(Stage::kShow, "show", "Look at the knot at the mark.");
  phase(Stage::kAsk, "ask", "Which is it? Close the jaws at a mark, from far to near: square, granny, sliding, loose first throw.");
  constexpr std::pair<const char*, const char*> kNamed[] = {
      {"pull.square", "It is a square knot. Its loop is pulled."},
      {"pull.granny", "It is a granny. Its loop is pulled."},
      {"pull.sliding", "It is a sliding knot. Its loop is pulled."},
      {"pull.loose", "Its first throw is loose. Its loop is pulled."},
  };
  for (size_t i = 0; i < kKnots; ++i) pulled_[i] = builder.phase(kNamed[i].first, kNamed[i].second);
  phase(Stage::kTell, "tell", "Open the jaws again.");
  phase(Stage::kDone, "done", "The attempt is over.");
  answered_ = builder.event("fault.answered", "An answer was given; value: 1 square, 2 granny, 3 sliding, 4 loose.");
  held_ = builder.event("fault.held", "The knot has borne the load; value: opening of its loop, m.");
  gave_way_ = builder.event("fault.gave_way", "The knot has given way; value: most that it has borne, N.");
  failed_[index(End::kWrong)] = builder.event("failed.wrong", "Too few answers were right.");
  failed_[index(End::kOutOfTime)] = builder.event("failed.out_of_time", "Time ran out before the questions were answered.");
}

Vec3 FaultLesson::answer_W(size_t i) const { return vec(params().answer_place) + static_cast<double>(i) * vec(params().answer_step); }

void FaultLesson::bind(const Scene& scene, Binder& binder) {
  gripper_ = lessons::find_gripper(scene, binder, params().gripper, gripper_object_);
  assistant_ = lessons::find_gripper(scene, binder, params().assistant, assistant_object_);
  specimen_.clear();
  for (const std::string& thread : names_) {
    Specimen& one = specimen_.emplace_back();
    one.object = lessons::find_object(scene, binder, thread);
    if (one.object == kNone) continue;
    one.strand = StrandPeer(Peer(scene->object[one.object].instance));
    for (const auto& [wanted, signal] : {std::pair{"thread.tension", &one.tension}, {"thread.shape", &one.shape}}) {
      *signal = scene.find_signal(thread, wanted);
      if (!signal->valid()) binder.missing(scene, "signal", thread, wanted, lessons::say::kWatched());
    }
    if (!one.strand.valid()) binder.error(lessons::say::kNoThread(thread));
  }
  shown_ = binder.mark_point({0, 0, 0}, kShownRadius, "shown.point");
  pull_ = binder.mark_point({0, 0, 0}, kAnswerRadius, "pull.point");  // the assisting hand that pulls waits until this mark moves
  for (size_t i = 0; i < kKnots; ++i) answer_[i] = binder.mark_point(raw(answer_W(i)), kAnswerRadius, kAnswers[i]);
}

void FaultLesson::activate(double dt_s) {
  const P& p = params();
  Rules rules;
  lessons::set_common_rules(p, is_practice(), rules);
  rules.questions = static_cast<int>(names_.size());
  rules.least_right = p.least_right;
  rules.show_time = p.show_time;
  rules.tell_time = p.tell_time;
  rules.reach = p.answer_reach;
  rules.load = p.load;
  rules.pull_time = p.pull_time;
  rules.most_opening = p.most_opening;
  judge_ = Judge(rules, dt_s);
}

bool FaultLesson::read(const View& view, const Memory& memory, Look& look) const {
  const auto jaws = gripper_.describe(view.object(gripper_object_)), puller = assistant_.describe(view.object(assistant_object_));
  if (!jaws || !puller) return false;
  const Specimen& asked = specimen_[std::min(Judge::question(memory), specimen_.size() - 1)];
  look.time_s = view.time();
  look.tip_W = vec(jaws->tip_W);
  look.opening = jaws->opening;
  for (size_t i = 0; i < kKnots; ++i) look.answer_W[i] = answer_W(i);
  look.knot = std::clamp(static_cast<int>(std::lround(view.signal(asked.shape))) - 1, 0, static_cast<int>(kKnots) - 1);
  look.tension = view.signal(asked.tension);
  look.puller_W = vec(puller->tip_W);
  return true;
}

void FaultLesson::observe(const View& view, const Verdict& verdict, std::span<double> state) {
  auto& memory = as<Memory>(state);
  Look look;
  if (!read(view, memory, look)) return discard();
  const Finding finding = judge_.look(memory, look);
  report(memory, finding, look.time_s, verdict);
  show(view, memory, look, finding, verdict);
  say(memory, look, finding, verdict);
}

/// Moves the mark of the shown knot to its loop, and the mark of the pull to the tips that pull: the assisting hands wait for these marks.
void FaultLesson::show(const View& view, const Memory& memory, const Look& look, const Finding& finding, const Verdict& verdict) const {
  if (finding.answered) {
    const swage_vec3 at = raw(look.puller_W);
    verdict.mark(pull_, Cue(), &at);
  }
  if (!finding.next) return;
  const Specimen& asked = specimen_[Judge::question(memory)];
  const Step step = view.object(asked.object);
  const auto law = asked.strand.law(step);
  if (!law) return;
  if (const auto place = asked.strand.place(step, 0.25 * law->length)) verdict.mark(shown_, Cue(), &place->p_W);
}

void FaultLesson::say(const Memory& memory, const Look& look, const Finding& finding, const Verdict& verdict) const {
  const uint32_t thread = specimen_[std::min(Judge::question(memory), specimen_.size() - 1)].object;
  if (finding.stage == Stage::kTell) {
    verdict.cue(thread, cue_[index(memory.right != 0 ? Sign::kRight : Sign::kWrong)]);
    verdict.cue(assistant_object_, cue_[index(memory.held != 0 ? Sign::kHolds : Sign::kGivesWay)]);
  } else if (finding.next) {
    for (const Specimen& one : specimen_) verdict.clear_cue(one.object);
    verdict.clear_cue(assistant_object_);
  }
  if (finding.answered) verdict.event(answered_, finding.answer + 1);
  if (finding.pulled) verdict.event(memory.held != 0 ? held_ : gave_way_, finding.result);
  verdict.phase(finding.stage == Stage::kPull ? pulled_[look.knot] : phase_[index(finding.stage)]);
  if (finding.end == End::kRunning) return;
  if (finding.end == End::kPassed) return verdict.pass(finding.score);
  const Event reason = failed_[index(finding.end)];
  verdict.event(reason);
  verdict.fail(reason, finding.score);
}

void FaultLesson::report(const Memory& m, const Finding& finding, double time_s, const Verdict& verdict) const {
  tell(verdict, Measure::kTime, m.path.set_off_s < 0 ? 0 : time_s - m.path.set_off_s);
  tell(verdict, Measure::kSuccess, finding.end == End::kPassed ? 1 : 0);
  tell(verdict, Measure::kRight, m.rights);
  tell(verdict, Measure::kFalseAlarms, m.false_alarms);
  tell(verdict, Measure::kMissed, m.missed);
  tell(verdict, Measure::kAnswers, m.answers);
  tell(verdict, Measure::kPath, m.path.length);
  if (m.answers > 0) tell(verdict, Measure::kAnswerTime, m.answer_s / m.answers);
  for (size_t i = 0; i < kKnots; ++i) {
    const Pulled& pulled = m.pulled[i];
    if (pulled.count == 0) continue;
    verdict.metric(metric_[index(Measure::kSquareBears) + i], pulled.borne);
    verdict.metric(metric_[index(Measure::kSquareOpens) + i], pulled.opening);
  }
  if (finding.end != End::kPassed) return;
  tell(verdict, Measure::kPointsWrong, finding.lost.wrong);
  tell(verdict, Measure::kPointsMissed, finding.lost.missed);
  tell(verdict, Measure::kPointsTime, finding.lost.time);
}

}  // namespace swage::lesson_fault

SWAGE_EXPORT(swage::lesson_fault::FaultLesson)
