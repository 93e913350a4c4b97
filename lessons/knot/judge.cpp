// SPDX-License-Identifier: Apache-2.0
#include "judge.hpp"

#include <algorithm>
#include <cmath>

namespace swage::lesson_knot {
namespace {

// Share of the least force below which the jaws have let go: a grasp that is out of balance for a moment still holds.
constexpr double kLetGo = 0.5;
// Turns from which the thread counts as wound about the holder; the hand that moves aside adds the rest of the turn.
constexpr double kWound = 0.7;
// s, after the last turn has slid off, in which the throw may still be told with the turns it had before: a reading takes 0.05 to 0.3 s and is told
// once it has been the same for 0.05 s. Shorter: a double throw counts as a single one in between. Longer: a single one is told as wrong later.
constexpr double kRead = 1;

}  // namespace

int Word::like(const Word& asked) const {
  const int n = std::min({static_cast<int>(throws), static_cast<int>(asked.throws), kThrows});
  int same = 0;
  const double side = n > 0 && turns[0] * asked.turns[0] < 0 ? -1 : 1;
  while (same < n && turns[same] == side * asked.turns[same]) ++same;
  return same;
}

bool Word::begins_throw_of(const Word& asked) const {
  const int last = static_cast<int>(throws) - 1;
  if (last < 0 || last >= std::min(kThrows, static_cast<int>(asked.throws)) || like(asked) != last) return false;
  const double side = last > 0 && turns[0] * asked.turns[0] < 0 ? -1 : 1, left = last > 0 ? side * turns[last] / asked.turns[last] : std::abs(turns[0] / asked.turns[0]);
  return left > 0 && left < 1;
}

Finding Judge::look(Memory& memory, const Look& look) const noexcept {
  Finding finding;
  follow_hands(memory, look, finding);
  follow_force(memory, look, finding);
  follow_cut(memory, look, finding);
  follow_knot(memory, look, finding);
  decide(memory, look, finding);
  return finding;
}

double Judge::task_time(const Memory& memory, double time_s) { return lessons::time_since_set_off(memory.path, time_s); }

void Judge::follow_hands(Memory& memory, const Look& look, Finding& finding) const noexcept {
  for (int i = 0; i < 2; ++i) {
    const bool had = memory.has[i] != 0;
    memory.has[i] = look.grip[i] > kLetGo * rules_.force_low && (look.held[i] || had) ? 1 : 0;
    path_.look(memory.path[i], look.tip_W[i], look.time_s);
    grip_.look(memory.grip[i], look.grip[i], memory.has[i] != 0, look.time_s, look.dt_s);
    finding.too_hard[i] = GripWatch::too_hard(memory.grip[i]);
    if (i == 0) finding.dropped = drops(memory, look, had);
  }
  memory.drops += finding.dropped;
  finding.held = memory.has[0] != 0;
}

/// True in the step in which the winder loses the thread. What the hand lets go of when all is tied is no drop. Neither is a long end that it
/// lets go of between two throws, slack and with nothing wound, once it has it again in time.
bool Judge::drops(Memory& memory, const Look& look, bool had) const noexcept {
  if (look.word.throws >= rules_.asked.throws) memory.let_go = 0;
  if (memory.has[0] != 0) {
    memory.regrasps += memory.let_go;
    memory.let_go = 0;
    memory.long_tension = look.tension_grip;
  }
  if (had && memory.has[0] == 0 && look.word.throws < rules_.asked.throws) {
    const bool opened = look.squeeze < rules_.force_low;
    const bool between = look.word.throws > 0 && std::abs(look.turns) < kWound;
    const bool laid = opened && between && memory.long_tension < rules_.slack;
    memory.let_go = laid ? 1 : 0, memory.let_go_s = 0;
    return !laid;
  }
  if (memory.let_go == 0) return false;
  memory.let_go_s += look.dt_s;
  if (memory.let_go_s < rules_.retake_time) return false;
  memory.let_go = 0;
  return true;
}

void Judge::follow_force(Memory& memory, const Look& look, Finding& finding) const noexcept {
  const bool holds = memory.has[0] != 0 || memory.has[1] != 0;
  pull_.look(memory.pull, look.tension, holds, look.time_s, look.dt_s);
  finding.taut = holds && GripWatch::too_hard(memory.pull);
  memory.cut = std::max(memory.cut, look.cut);
  memory.tail = look.tail;
  if (!holds) return;
  memory.held_s += look.dt_s;
  if (std::max(memory.grip[0].now, memory.grip[1].now) > rules_.force_high) memory.over_s += look.dt_s;
  if (memory.pull.now > rules_.tension) memory.taut_s += look.dt_s;
}

bool Judge::end_good(const Memory& memory, int end) const noexcept {
  return memory.end[end] > 0 && std::abs(memory.end[end] - rules_.tail) <= rules_.tail_tolerance;
}

/// An end that is still too long may be cut again. What was kept before counts no more: the knot is to keep by itself.
void Judge::follow_cut(Memory& memory, const Look& look, Finding& finding) const noexcept {
  if (!rules_.cut || look.cut_at < 0) return;
  memory.cuts += 1;
  memory.hold_s = 0;
  const bool tied = look.word.throws >= rules_.asked.throws, long_end = look.cut_at < look.from;
  finding.cut = tied && (long_end || look.cut_at > look.to);
  if (!finding.cut) return void(memory.severed = 1);
  memory.end[long_end ? 0 : 1] = long_end ? look.from - look.cut_at : look.cut_at - look.to;
}

void Judge::follow_knot(Memory& memory, const Look& look, Finding& finding) const noexcept {
  const int like = look.word.like(rules_.asked);
  const int throws = static_cast<int>(look.word.throws);
  memory.passages = look.passages;
  memory.unwound_s = std::abs(look.turns) >= kWound ? 0 : memory.unwound_s + look.dt_s;
  // a throw whose turn still lies on the holder is told as tied one time and not the next: it is tied, and can come undone, once the turn has left
  finding.undone = throws < memory.laid;
  memory.undone += finding.undone;
  memory.laid = memory.unwound_s >= kRead ? throws : std::min(memory.laid, static_cast<double>(throws));
  memory.throws = throws;
  memory.most_like = std::max(memory.most_like, static_cast<double>(like));
  // turns that slide off one by one tie a throw of two as one of one first
  const bool slides_off = memory.unwound_s < kRead && look.word.begins_throw_of(rules_.asked);
  finding.wrong = look.tangled || (like < throws && !slides_off);
  memory.wrong += finding.wrong && memory.is_wrong == 0;
  memory.is_wrong = finding.wrong ? 1 : 0;
  // a wrong throw can be undone until all throws are there
  const bool another = finding.wrong && throws >= static_cast<int>(rules_.asked.throws);
  memory.wrong_s = another ? memory.wrong_s + look.dt_s : 0;
  finding.tied = !look.tangled && look.word.is(rules_.asked);
  // the ends are cut off a knot that was flat while hands drew it: ends that are slack, or short and bent, tell no form
  const bool was_flat = rules_.cut && memory.flat != 0;
  finding.sliding = throws > 0 && look.sliding > rules_.most_sliding && !was_flat;
  finding.loose = finding.tied && look.loosest > rules_.most_throw;
  finding.together = look.gap <= rules_.most_gap;
  memory.least_gap = std::min(memory.least_gap, look.gap);

  const bool snug = look.loop <= rules_.most_loop;
  const bool hard = finding.too_hard[0] || finding.too_hard[1];
  const bool good = finding.tied && !finding.sliding && !finding.loose && finding.together && snug && !finding.taut && !hard;
  memory.hold_s = good ? memory.hold_s + look.dt_s : 0;
  memory.best_hold_s = std::max(memory.best_hold_s, memory.hold_s);
  if (memory.hold_s >= rules_.hold_time) memory.flat = 1;
  finding.stage = stage(memory, look, finding, good);
}

Stage Judge::stage(const Memory& memory, const Look& look, const Finding& finding, bool good) const noexcept {
  const bool to_cut = memory.best_hold_s >= rules_.hold_time && !ends_good(memory);
  if (look.word.throws >= rules_.asked.throws) return !good ? Stage::kLay : to_cut ? Stage::kCutEnds : Stage::kHold;
  if (!finding.held) return Stage::kTake;
  if (look.held[1]) return Stage::kDraw;
  return std::abs(look.turns) >= kWound ? Stage::kTail : Stage::kWind;
}

End Judge::end(const Memory& memory, const Look& look) const noexcept {
  if (look.passages > 0) return End::kPassage;  // the thread passed through itself: the knot is no longer valid
  if (memory.hold_s >= rules_.hold_time && ends_good(memory)) return End::kPassed;
  if (memory.severed != 0) return End::kSevered;
  for (const double end : memory.end)
    if (end > 0 && end < rules_.tail - rules_.tail_tolerance) return End::kTailShort;
  if (look.parted > memory.cuts) return End::kBroken;
  if (!look.through) return End::kDrawnOut;
  if (memory.cut > rules_.most_cut) return End::kCut;
  if (rules_.ends && memory.drops > rules_.max_drops) return End::kDropped;
  if (rules_.ends && memory.over_s > rules_.max_over_time) return End::kTooHard;
  if (rules_.ends && memory.wrong_s >= rules_.wrong_time) return End::kWrong;
  return rules_.ends && look.time_s >= rules_.max_time ? End::kOutOfTime : End::kRunning;
}

void Judge::decide(Memory& memory, const Look& look, Finding& finding) const noexcept {
  finding.end = end(memory, look);
  if (finding.end == End::kRunning) return;
  finding.stage = Stage::kDone;
  finding.lost = points(memory, look.time_s);
  memory.passed = finding.end == End::kPassed ? 1 : 0;
  // an attempt that did not pass scores at most 40: the share of the throws, of the hold and of the ends that was reached
  const double throws = memory.most_like / rules_.asked.throws, hold = std::min(1.0, memory.best_hold_s / rules_.hold_time);
  const double ends = 0.5 * (end_good(memory, 0) + end_good(memory, 1));
  const double share = rules_.cut ? (throws + hold + ends) / 3 : 0.5 * (throws + hold);
  finding.score = memory.passed != 0 ? std::clamp(100 - finding.lost.sum(), 40.0, 100.0) : 40 * share;
}

Points Judge::points(const Memory& memory, double time_s) const noexcept {
  Points lost;
  lost.undone = 10 * std::min(memory.undone + memory.wrong, 3.0);
  lost.drops = 15 * memory.drops;
  lost.tension = memory.held_s > 0 ? 40 * memory.taut_s / memory.held_s : 0;
  lost.force = memory.held_s > 0 ? 40 * memory.over_s / memory.held_s : 0;
  lost.cut = 20 * std::min(1.0, memory.cut / rules_.most_cut);
  double off = 0;
  for (const double end : memory.end) off = std::max(off, end > 0 ? std::abs(end - rules_.tail) : 0);
  lost.tails = rules_.cut ? 10 * std::clamp(2 * off / rules_.tail_tolerance - 1, 0.0, 1.0) : 0;
  lost.time = 15 * std::clamp(task_time(memory, time_s) / rules_.par_time - 1, 0.0, 1.0);
  return lost;
}

}  // namespace swage::lesson_knot
