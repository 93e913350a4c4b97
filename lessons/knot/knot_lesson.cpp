// SPDX-License-Identifier: Apache-2.0
#include "knot_lesson.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>

#include "common/declare.hpp"
#include "common/report.hpp"
#include "common/rules.hpp"
#include "common/sentences.hpp"

namespace swage::lesson_knot {

using lessons::index;
using toolkit::vec;

namespace {

// m, from the middle of the grasp towards the stitch: outside of tips of 0.3 mm and one segment of 0.4 mm on. Nearer, the bend in the jaws counts as a pull.
constexpr double kBeside = 0.8e-3;
constexpr double kMarkRadius = 60e-6;  // m, drawn: somewhat thicker than 8-0
constexpr double kInside = 0.5e-3;     // m, from a cut: a thread of segments of 0.4 mm is parted by a whole one. With less the mark goes with what is cut off
constexpr double kTangled = 5;  // knot.kind of a thread with any other knot

/// Reads throws such as "2 -1 1". False for any other text.
bool read_word(std::string_view text, Word& word) {
  word = {};
  while (true) {
    while (!text.empty() && text.front() == ' ') text.remove_prefix(1);
    if (text.empty()) return word.throws > 0;
    int turns = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), turns);
    if (error != std::errc() || turns == 0 || std::abs(turns) > 9 || word.throws == kThrows) return false;
    word.turns[static_cast<size_t>(word.throws)] = turns;
    word.throws += 1;
    text.remove_prefix(static_cast<size_t>(end - text.data()));
  }
}

}  // namespace

void KnotLesson::build(const P& params, LessonBuilder& builder) {
  lessons::require_ordered(builder, "force", params.force);
  if (params.holder == params.winder) builder.error("winder", lessons::say::kTwoGrippers());
  if (params.left == params.right) builder.error("right", "a wound has two edges, not one");
  if (!read_word(params.word, asked_)) builder.error("word", "a word is one to six whole numbers that are not 0, such as \"1 -1\"");
  builder.state<Kept>();
  const auto shows = [&](size_t i) { return i != index(Sign::kTailGood) || has_cut(); };
  const auto tells = [&](size_t i) {
    return has_cut() || (i != index(Measure::kTailLeast) && i != index(Measure::kTailMost) && i != index(Measure::kPointsTails));
  };
  lessons::declare_card(builder, kCues, cue_, kMetrics, metric_, shows, tells);
  const auto phase = [&](Stage stage, const char* key, const char* doc) { phase_[index(stage)] = builder.phase(key, doc); };
  // instruments that have the names of the defaults are called by them: of two, only one counts as the winder
  const bool named = params.holder == P().holder && params.winder == P().winder;
  phase(Stage::kTake, "take",
        named ? "Take the long end of the thread with the forceps." : "Take the long end of the thread with one instrument.");
  phase(Stage::kWind, "wind", named ? "Wind it about the tips of the needleholder." : "Wind it about the tips of the other.");
  phase(Stage::kTail, "tail", named ? "Take the tail with the needleholder." : "Take the tail with that one.");
  phase(Stage::kDraw, "draw", "Draw the tail through the loop.");
  phase(Stage::kLay, "lay", "Lay the throw down flat, each end to the other side, until the edges come together.");
  phase(Stage::kHold, "hold", "Keep it so.");
  if (has_cut()) phase(Stage::kCutEnds, "cut", "Cut both ends with the scissors, as long as the marks show.");
  phase(Stage::kDone, "done", "The attempt is over.");
  dropped_ = builder.event("thread.dropped", "The thread has got out of the jaws that wind it.");
  undone_ = builder.event("knot.came_undone", "A throw that was tied has come undone.");
  if (has_cut()) cut_off_ = builder.event("suture.cut_off", "An end was cut; value: what is left of it at the knot, m.");
  const auto failed = [&](End end, const char* key, const char* doc) { failed_[index(end)] = builder.event(key, doc); };
  failed(End::kPassage, "failed.passage",
         "The simulation has let the thread go through itself or the instrument: what was tied is not to be trusted.");
  failed(End::kBroken, "failed.broken", "The thread has broken.");
  failed(End::kDrawnOut, "failed.drawn_out", "The thread was drawn out of the tissue.");
  failed(End::kCut, "failed.cut", "The thread has cut through the tissue.");
  failed(End::kDropped, "failed.dropped", "The thread got out of the jaws too often.");
  failed(End::kTooHard, "failed.too_hard", "The thread was gripped too hard for too long.");
  failed(End::kWrong, "failed.wrong", "Another knot was tied than the one that is asked for.");
  failed(End::kOutOfTime, "failed.out_of_time", "Time ran out before the knot was tied and drawn down.");
  if (!has_cut()) return;
  failed(End::kSevered, "failed.severed", "The thread was cut in the knot or its loop, or before all throws were tied.");
  failed(End::kTailShort, "failed.tail_short", "An end was cut too near to the knot, which slips.");
}

void KnotLesson::bind(const Scene& scene, Binder& binder) {
  const P& p = params();
  gripper_[0] = lessons::find_gripper(scene, binder, p.winder, gripper_object_[0]);
  gripper_[1] = lessons::find_gripper(scene, binder, p.holder, gripper_object_[1]);
  thread_object_ = lessons::find_object(scene, binder, p.thread);
  if (thread_object_ != kNone) strand_ = StrandPeer(Peer(scene->object[thread_object_].instance));
  grasp_[0] = lessons::find_grasp(scene, binder, p.grasp);
  grasp_[1] = lessons::find_grasp(scene, binder, p.tail_grasp);
  side_[0].tissue = lessons::find_object(scene, binder, p.left);
  side_[1].tissue = lessons::find_object(scene, binder, p.right);
  find_knot(scene, binder);
  if (binder.failed()) return;
  strand_ = StrandPeer(Peer(scene->object[thread_object_].instance));
  for (Side& side : side_)
    if (scene->object[side.tissue].n_body > 0) side.body = scene->object[side.tissue].first_body;
}

void KnotLesson::find_knot(const Scene& scene, Binder& binder) {
  const P& p = params();
  const auto signal = [&](const std::string& owner, const std::string& wanted) {
    const Signal found = scene.find_signal(owner, wanted.c_str());
    if (!found.valid()) binder.missing(scene, "signal", owner, wanted.c_str(), lessons::say::kWatched());
    return found;
  };
  const std::string tissue[2] = {p.left, p.right}, stitch[2] = {p.left_stitch, p.right_stitch};
  for (size_t i = 0; i < 2; ++i) {
    side_[i].shift = signal(tissue[i], "tissue.shift");
    side_[i].state = signal(stitch[i], "pull.state");
    side_[i].tail = signal(stitch[i], "pull.tail");
    side_[i].tension = signal(stitch[i], i == 0 ? "pull.tension_tail" : "pull.tension_out");
    side_[i].cut = signal(stitch[i], "pull.cut");
    side_[i].out = signal(stitch[i], "pull.out");
  }
  turns_ = signal(p.winding, "winding.turns");
  through_ = signal(p.winding, "winding.passages");
  throws_ = signal(p.knot, "knot.throws");
  for (int i = 0; i < kThrows; ++i) throw_[i] = signal(p.knot, "knot.throw_" + std::to_string(i + 1));
  kind_ = signal(p.knot, "knot.kind");
  sliding_ = signal(p.knot, "knot.sliding");
  loop_ = signal(p.knot, "knot.loop");
  from_ = signal(p.knot, "knot.from");
  to_ = signal(p.knot, "knot.to");
  loosest_ = signal(p.knot, "knot.loosest");
  through_itself_ = signal(p.thread, "thread.passed");
  parted_ = signal(p.thread, "thread.parted");
  squeeze_ = scene.find_signal(p.winder, "grip.command");
  if (!has_cut()) return;
  cut_ = scene.find_event(p.cut, "cut.parted");
  if (!cut_.valid()) binder.missing(scene, "event", p.cut, "cut.parted", lessons::say::kWatched());
  for (Mark& end : end_) end = binder.mark_point({0, 0, 0}, kMarkRadius, "tail.point");
}

void KnotLesson::activate(double dt_s) {
  const P& p = params();
  Rules rules;
  lessons::set_common_rules(p, is_practice(), rules);
  rules.asked = asked_;
  rules.most_gap = p.most_gap;
  rules.most_loop = p.most_loop;
  rules.most_throw = p.most_throw;
  rules.most_sliding = p.most_sliding;
  rules.cut = has_cut();
  rules.tail = p.tail;
  rules.tail_tolerance = p.tail_tolerance;
  rules.tension = p.tension;
  rules.most_cut = p.most_cut;
  rules.wrong_time = p.wrong_time;
  rules.slack = p.slack;
  rules.retake_time = p.retake_time;
  judge_ = Judge(rules, dt_s);
}

void KnotLesson::read_knot(const View& view, Look& look) const {
  look.word.throws = std::min(view.signal(throws_), double{kThrows});
  for (int i = 0; i < kThrows; ++i) look.word.turns[i] = view.signal(throw_[i]);
  look.tangled = view.signal(kind_) == kTangled;
  look.sliding = view.signal(sliding_);
  look.loop = view.signal(loop_);
  look.from = view.signal(from_);
  look.to = view.signal(to_);
  look.loosest = view.signal(loosest_);
  if (has_cut())
    for (const swage_view_event& event : view.events())
      if (event.event == cut_) look.cut_at = event.value;
  look.passages = view.signal(through_) + view.signal(through_itself_);
}

/// Tension of the long end beside the jaws of the winder, on the side of the stitch.
double KnotLesson::long_tension(const View& view) const {
  const Step thread = view.object(thread_object_);
  const auto law = strand_.law(thread);
  if (!law) return 0;
  const auto place = strand_.place(thread, view.signal(grasp_[0].s) * law->length + kBeside);
  return place ? place->tension : 0;
}

bool KnotLesson::read(const View& view, Look& look) const {
  look.time_s = view.time();
  look.dt_s = view.dt();
  look.gap = params().gap;
  for (int i = 0; i < 2; ++i) {
    const auto jaws = gripper_[i].describe(view.object(gripper_object_[i]));
    if (!jaws) return false;
    look.tip_W[i] = vec(jaws->tip_W);
    look.held[i] = view.signal(grasp_[i].held) != 0;
    look.grip[i] = view.signal(grasp_[i].force);
    look.gap -= view.signal(side_[i].shift);
    look.tension = std::max(look.tension, view.signal(side_[i].tension));
    look.cut = std::max(look.cut, view.signal(side_[i].cut));
    look.through = look.through && view.signal(side_[i].state) == 2;
  }
  look.tail = view.signal(side_[0].tail);
  look.turns = view.signal(turns_);
  look.parted = view.signal(parted_);
  look.tension_grip = long_tension(view);
  if (squeeze_.valid()) look.squeeze = view.signal(squeeze_);
  read_knot(view, look);
  return true;
}

void KnotLesson::observe(const View& view, const Verdict& verdict, std::span<double> state) {
  Look look;
  auto& kept = as<Kept>(state);
  if (!read(view, look)) return discard();
  const Finding finding = judge_.look(kept.memory, look);
  follow_work(view, look, kept);
  report(kept.memory, look, verdict);
  report_work(kept.work, verdict);
  if (finding.end == End::kPassed) report_points(finding.lost, verdict);
  if (finding.cut) verdict.event(cut_off_, kept.memory.end[look.cut_at < look.from ? 0 : 1]);
  if (has_cut()) show_ends(view, look, kept.memory, verdict);
  say(finding, verdict);
}

/// Moves the marks to where the ends are to be cut: beyond the knot, as long as there is none beyond the edges.
void KnotLesson::show_ends(const View& view, const Look& look, const Memory& memory, const Verdict& verdict) const {
  const Step thread = view.object(thread_object_);
  const auto law = strand_.law(thread);
  if (!law) return;
  const bool knot = look.word.throws > 0;
  const double from = knot ? look.from : view.signal(side_[1].out), to = knot ? look.to : law->length - look.tail;
  const auto length = [&](int end) { return memory.end[end] > 0 ? std::min(params().tail, memory.end[end] - kInside) : params().tail; };
  const double s[2] = {from - length(0), to + length(1)};
  for (int i = 0; i < 2; ++i) {
    const auto place = strand_.place(thread, std::clamp(s[i], 0.0, law->length));
    if (place) verdict.mark(end_[i], judge_.end_good(memory, i) ? cue_[index(Sign::kTailGood)] : Cue(), &place->p_W);
  }
}

void KnotLesson::follow_work(const View& view, const Look& look, Kept& kept) const {
  const Memory& m = kept.memory;
  const bool counts = Judge::task_time(m, look.time_s) > 0 && m.hold_s == 0;
  for (int i = 0; i < 2; ++i) {
    const auto jaws = gripper_[i].describe(view.object(gripper_object_[i]));
    if (!jaws) continue;
    WorkWatch::look(kept.work, i, m.has[i] != 0, Eigen::Map<const Vec3>(m.path[i].last), jaws->opening, m.grip[i].now, look.dt_s, counts);
  }
  kept.work.gap = look.word.throws > 0 && look.through ? air_gap(view, look.loop) : -1;
}

/// m; negative where the thread or the tissue cannot say it. The long end leaves the right edge, the tail the left one.
double KnotLesson::air_gap(const View& view, double length) const {
  const Step thread = view.object(thread_object_);
  const auto law = strand_.law(thread);
  if (!law || side_[0].body == kNone || side_[1].body == kNone) return -1;
  Loop loop;
  loop.exit = view.signal(side_[1].out);
  loop.entry = law->length - view.signal(side_[0].tail);
  loop.length = length;
  loop.diameter = 2 * law->radius;
  Vec3 out = Vec3::Zero();
  for (const Side& side : side_) out += toolkit::Pose(view.pose(side.body)).q * Vec3::UnitZ();
  loop.out_W = out.normalized();
  return lesson_knot::air_gap(loop, [&](double s) {
    const auto place = strand_.place(thread, s);
    return place ? vec(place->p_W) : Vec3(Vec3::Zero());
  });
}

void KnotLesson::say(const Finding& finding, const Verdict& verdict) const {
  const auto show = [&](uint32_t object, bool is, Sign sign) {
    is ? verdict.cue(object, cue_[index(sign)]) : verdict.clear_cue(object);
  };
  const bool wrong = finding.wrong || finding.sliding;
  const Sign thread = finding.taut ? Sign::kTaut : wrong ? Sign::kWrong : finding.loose ? Sign::kLoose : finding.tied ? Sign::kTied : Sign::kHeld;
  show(thread_object_, finding.held || finding.taut || wrong || finding.tied, thread);
  show(gripper_object_[0], finding.too_hard[0], Sign::kTooHard);
  const bool on = finding.stage == Stage::kTail;
  show(gripper_object_[1], finding.too_hard[1] || on, finding.too_hard[1] ? Sign::kTooHard : Sign::kOn);
  const Sign edges = finding.end == End::kPassed ? Sign::kDone : Sign::kTogether;
  for (const Side& side : side_) show(side.tissue, finding.together, edges);
  if (finding.dropped) verdict.event(dropped_);
  if (finding.undone) verdict.event(undone_);
  verdict.phase(phase_[index(finding.stage)]);
  if (finding.end != End::kRunning) tell_end(finding, verdict);
}

void KnotLesson::tell_end(const Finding& finding, const Verdict& verdict) const {
  if (finding.end == End::kPassed) return verdict.pass(finding.score);
  const Event reason = failed_[index(finding.end)];
  verdict.event(reason);
  verdict.fail(reason, finding.score);
}

void KnotLesson::report(const Memory& m, const Look& look, const Verdict& verdict) const {
  tell(verdict, Measure::kTime, Judge::task_time(m, look.time_s));
  tell(verdict, Measure::kSuccess, m.passed);
  tell(verdict, Measure::kThrows, m.most_like);
  tell(verdict, Measure::kUndone, m.undone);
  tell(verdict, Measure::kWrong, m.wrong);
  if (m.flat == 0) tell(verdict, Measure::kSliding, look.sliding);  // as it was when it was judged
  if (look.word.throws > 0) {
    tell(verdict, Measure::kLoop, look.loop);
    tell(verdict, Measure::kLoosest, look.loosest);
  }
  tell(verdict, Measure::kGap, look.gap);
  tell(verdict, Measure::kCut, m.cut);
  tell(verdict, Measure::kTail, look.tail);
  tell(verdict, Measure::kDrops, m.drops);
  tell(verdict, Measure::kTakenAnew, m.regrasps);
  tell(verdict, Measure::kPath, m.path[0].length + m.path[1].length);
  lessons::report_smoothness(verdict, metric_[index(Measure::kSparc)], metric_[index(Measure::kLdlj)], m.path);
  tell(verdict, Measure::kHold, std::min(1.0, m.hold_s / judge_.rules().hold_time));
  tell(verdict, Measure::kPassages, m.passages);
  if (m.held_s > 0) report_held(m, verdict);
  if (m.end[0] + m.end[1] <= 0) return;
  const double other = m.end[0] > 0 ? m.end[0] : m.end[1];
  tell(verdict, Measure::kTailLeast, std::min(other, m.end[1] > 0 ? m.end[1] : other));
  tell(verdict, Measure::kTailMost, std::max(m.end[0], m.end[1]));
}

void KnotLesson::report_work(const WorkState& work, const Verdict& verdict) const {
  if (work.gap >= 0) tell(verdict, Measure::kAirGap, work.gap);
  tell(verdict, Measure::kIdle, WorkWatch::idle(work));
  tell(verdict, Measure::kRegrasps, WorkWatch::regrasps(work));
}

// Metrics without a value before the thread was held are not reported. Of the two grips the one with more force counts.
void KnotLesson::report_held(const Memory& m, const Verdict& verdict) const {
  const GripWatch& grip = judge_.grip();
  tell(verdict, Measure::kTension, judge_.pull().peak(m.pull));
  tell(verdict, Measure::kTaut, m.taut_s / m.held_s);
  tell(verdict, Measure::kForce, std::max(GripWatch::mean(m.grip[0]), GripWatch::mean(m.grip[1])));
  tell(verdict, Measure::kPeak, std::max(grip.peak(m.grip[0]), grip.peak(m.grip[1])));
  tell(verdict, Measure::kOverTime, m.over_s / m.held_s);
}

void KnotLesson::report_points(const Points& lost, const Verdict& verdict) const {
  tell(verdict, Measure::kPointsUndone, lost.undone);
  tell(verdict, Measure::kPointsDrops, lost.drops);
  tell(verdict, Measure::kPointsTension, lost.tension);
  tell(verdict, Measure::kPointsForce, lost.force);
  tell(verdict, Measure::kPointsCut, lost.cut);
  if (has_cut()) tell(verdict, Measure::kPointsTails, lost.tails);
  tell(verdict, Measure::kPointsTime, lost.time);
}

}  // namespace swage::lesson_knot

SWAGE_EXPORT(swage::lesson_knot::KnotLesson)
