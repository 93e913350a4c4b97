// SPDX-License-Identifier: Apache-2.0
#include "judge.hpp"

#include <algorithm>
#include <cmath>

namespace swage::lesson_loop {
namespace {

// Share of the least force below which the jaws have let go: a grasp that is out of balance for a moment still holds.
constexpr double kLetGo = 0.5;

}  // namespace

Finding Judge::look(Memory& memory, const Look& look) const noexcept {
  Finding finding;
  follow_hands(memory, look, finding);
  follow_turns(memory, look, finding);
  decide(memory, look, finding);
  return finding;
}

double Judge::task_time(const Memory& memory, double time_s) { return lessons::time_since_set_off(memory.path, time_s); }

void Judge::follow_hands(Memory& memory, const Look& look, Finding& finding) const noexcept {
  const bool had = memory.has != 0;
  memory.has = look.force > kLetGo * rules_.force_low && (look.held || had) ? 1 : 0;
  finding.held = memory.has != 0;
  finding.dropped = had && !finding.held;
  memory.drops += finding.dropped;
  for (int i = 0; i < 2; ++i) path_.look(memory.path[i], look.tip_W[i], look.time_s);
  grip_.look(memory.grip, look.force, finding.held, look.time_s, look.dt_s);
  pull_.look(memory.pull, look.tension, finding.held, look.time_s, look.dt_s);
  finding.too_hard = GripWatch::too_hard(memory.grip);
  finding.taut = finding.held && GripWatch::too_hard(memory.pull);
  if (!finding.held) return;
  memory.held_s += look.dt_s;
  if (memory.grip.now > rules_.force_high) memory.over_s += look.dt_s;
  if (memory.pull.now > rules_.tension) memory.taut_s += look.dt_s;
}

/// Whole turns in the required sense; negative in the opposite sense.
double Judge::counted(const Look& look) const noexcept {
  return rules_.sense == 0 ? std::abs(look.whole) : rules_.sense * look.whole;
}

void Judge::follow_turns(Memory& memory, const Look& look, Finding& finding) const noexcept {
  const double now = counted(look);
  memory.passages = look.passages;
  memory.most_turns = std::max(memory.most_turns, std::abs(look.turns));
  finding.on = now == rules_.turns;
  finding.too_many = now > rules_.turns;
  finding.slipped = memory.on != 0 && now < rules_.turns;
  memory.slips += finding.slipped;
  memory.on = finding.on || finding.too_many ? 1 : 0;
  if (finding.on) memory.on_s += look.dt_s, memory.behind_s += look.behind * look.dt_s;

  const bool good = finding.on && finding.held && look.draw >= rules_.least_draw && !finding.taut && !finding.too_hard;
  memory.hold_s = good ? memory.hold_s + look.dt_s : 0;
  memory.best_hold_s = std::max(memory.best_hold_s, memory.hold_s);
  finding.stage = !finding.held ? Stage::kTake : finding.on ? Stage::kHold : Stage::kWind;
}

void Judge::decide(Memory& memory, const Look& look, Finding& finding) const noexcept {
  if (look.passages > 0)  // the thread passed through itself: its turns are no longer valid
    finding.end = End::kPassage;
  else if (memory.hold_s >= rules_.hold_time)
    finding.end = End::kPassed;
  else if (look.parted > 0)
    finding.end = End::kBroken;
  else if (rules_.ends && memory.drops > rules_.max_drops)
    finding.end = End::kDropped;
  else if (rules_.ends && memory.over_s > rules_.max_over_time)
    finding.end = End::kTooHard;
  else if (rules_.ends && look.time_s >= rules_.max_time)
    finding.end = End::kOutOfTime;
  if (finding.end == End::kRunning) return;
  finding.stage = Stage::kDone;
  finding.lost = points(memory, look.time_s);
  memory.passed = finding.end == End::kPassed ? 1 : 0;
  // an attempt that did not pass scores at most 40: the share of the turns and of the hold that was reached
  const double turns = std::min(1.0, std::floor(memory.most_turns + 0.25) / rules_.turns);
  const double share = 0.5 * (turns + std::min(1.0, memory.best_hold_s / rules_.hold_time));
  finding.score = memory.passed != 0 ? std::clamp(100 - finding.lost.sum(), 40.0, 100.0) : 40 * share;
}

Points Judge::points(const Memory& memory, double time_s) const noexcept {
  Points lost;
  lost.slips = 10 * std::min(memory.slips, 3.0);
  lost.drops = 15 * memory.drops;
  lost.tension = memory.held_s > 0 ? 40 * memory.taut_s / memory.held_s : 0;
  lost.force = memory.held_s > 0 ? 40 * memory.over_s / memory.held_s : 0;
  lost.time = 15 * std::clamp(task_time(memory, time_s) / rules_.par_time - 1, 0.0, 1.0);
  return lost;
}

}  // namespace swage::lesson_loop
