// SPDX-License-Identifier: Apache-2.0
#include "judge.hpp"

#include <algorithm>

namespace swage::lesson_pass {
namespace {

// Share of the least force below which a gripper has let go. The jaws of two hands with tremor are rarely in balance:
// a grasp that is out of balance still holds.
constexpr double kLetGo = 0.5;

bool has(const Memory& memory, int hand) { return memory.has[hand] != 0; }

}  // namespace

Finding Judge::look(Memory& memory, const Look& look) const noexcept {
  Finding finding;
  if (memory.begun == 0) {
    memory.begun = 1;
    Eigen::Map<Vec3>(memory.start) = look.needle_W;
    DropWatch::rest(memory.drop, look.needle_W);
  }
  finding.near_place = look.place_distance <= rules_.place_radius;
  follow_grips(memory, look);
  finding.held = has(memory, 0) || has(memory, 1);
  follow_hands(memory, look, finding);
  follow_owner(memory, look, finding);
  follow_hold(memory, look, finding);
  follow_drop(memory, look, finding);
  decide(memory, look, finding);
  return finding;
}

double Judge::task_time(const Memory& memory, double time_s) { return lessons::time_since_set_off(memory.path, time_s); }

void Judge::follow_grips(Memory& memory, const Look& look) const noexcept {
  for (int i = 0; i < kHands; ++i) {
    const bool firm = look.hand[i].force > kLetGo * rules_.force_low;
    memory.has[i] = firm && (look.hand[i].held || has(memory, i)) ? 1 : 0;
  }
}

void Judge::follow_hands(Memory& memory, const Look& look, Finding& finding) const noexcept {
  bool over = false;
  for (int i = 0; i < kHands; ++i) {
    const Look::Hand& hand = look.hand[i];
    path_.look(memory.path[i], hand.tip_W, look.time_s);
    grip_.look(memory.grip[i], hand.force, has(memory, i), look.time_s, look.dt_s);
    finding.too_hard[i] = GripWatch::too_hard(memory.grip[i]);
    over |= has(memory, i) && memory.grip[i].now > rules_.force_high;
  }
  if (finding.held) memory.held_s += look.dt_s;
  if (over) memory.over_s += look.dt_s;
  memory.bending = std::max(memory.bending, look.bending);
}

// The owner of the needle is the hand that last held it alone. It was passed if both held it in between, at the place and for long enough.
void Judge::follow_owner(Memory& memory, const Look& look, Finding& finding) const noexcept {
  const bool both = has(memory, 0) && has(memory, 1);
  if (both) {
    memory.both_s += look.dt_s;
    if (finding.near_place) memory.place_s += look.dt_s;
    memory.error_s += look.place_distance * look.dt_s;
    memory.shared_all_s += look.dt_s;
    finding.may_let_go = memory.place_s >= rules_.share_time;
    return;
  }
  if (!finding.held) return;
  const double alone = has(memory, 0) ? 1 : 2;
  if (memory.owner != 0 && memory.owner != alone) {
    finding.passed_on = memory.place_s >= rules_.share_time;
    finding.snatched = !finding.passed_on;
    memory.passes += finding.passed_on;
    memory.snatches += finding.snatched;
    if (finding.passed_on) memory.shared_s += memory.both_s;
  }
  memory.owner = alone;
  memory.both_s = memory.place_s = 0;
}

void Judge::follow_hold(Memory& memory, const Look& look, Finding& finding) const noexcept {
  const bool all = memory.passes >= rules_.passes;
  const bool both = has(memory, 0) && has(memory, 1);
  bool good = all && finding.held && !both;
  for (int i = 0; i < kHands; ++i)
    if (has(memory, i)) good = good && look.hand[i].force >= rules_.force_low && !finding.too_hard[i];
  memory.hold_s = good ? memory.hold_s + look.dt_s : 0;
  memory.best_hold_s = std::max(memory.best_hold_s, memory.hold_s);
  finding.stage = all                                             ? Stage::kHold
                  : both || (finding.held && finding.near_place) ? Stage::kPass
                  : memory.owner != 0 && memory.drop.armed != 0  ? Stage::kBring
                                                                 : Stage::kTake;
}

void Judge::follow_drop(Memory& memory, const Look& look, Finding& finding) const noexcept {
  finding.dropped = drop_.look(memory.drop, look.needle_W, finding.held);
  memory.drops += finding.dropped;
  const Vec3 start = Eigen::Map<const Vec3>(memory.start);
  const bool back = memory.drop.armed == 0 && (look.needle_W - start).norm() < 0.1 * rules_.drop_distance;
  memory.resets += look.reset;
  if (finding.dropped || look.reset) memory.owner = memory.both_s = memory.place_s = 0;
  if (look.reset || back) DropWatch::rest(memory.drop, look.needle_W);
}

void Judge::decide(Memory& memory, const Look& look, Finding& finding) const noexcept {
  const Vec3 start = Eigen::Map<const Vec3>(memory.start);
  if (memory.hold_s >= rules_.hold_time)
    finding.end = End::kPassed;
  else if (rules_.ends && memory.drops > rules_.max_drops)
    finding.end = End::kDropped;
  else if (rules_.ends && memory.over_s > rules_.max_over_time)
    finding.end = End::kTooHard;
  else if (rules_.ends && !finding.held && (look.needle_W - start).norm() > rules_.lost_distance)
    finding.end = End::kLost;
  else if (rules_.ends && look.time_s >= rules_.max_time)
    finding.end = End::kOutOfTime;
  if (finding.end == End::kRunning) return;
  finding.stage = Stage::kDone;
  finding.lost = points(memory, look.time_s);
  memory.passed = finding.end == End::kPassed ? 1 : 0;
  // an attempt that did not pass scores at most 40: the share of passes and of the hold that was reached
  const double share = (std::min<double>(memory.passes, rules_.passes) + std::min(1.0, memory.best_hold_s / rules_.hold_time)) /
                       (rules_.passes + 1);
  finding.score = memory.passed != 0 ? std::clamp(100 - finding.lost.sum(), 40.0, 100.0) : 40 * share;
}

Points Judge::points(const Memory& memory, double time_s) const noexcept {
  Points lost;
  lost.drops = 15 * (memory.drops + memory.resets);
  lost.snatches = 10 * std::min(memory.snatches, 3.0);
  lost.force = memory.held_s > 0 ? 40 * memory.over_s / memory.held_s : 0;
  lost.bending = lessons::bending_points(memory.bending);
  lost.time = 15 * std::clamp(task_time(memory, time_s) / rules_.par_time - 1, 0.0, 1.0);
  return lost;
}

}  // namespace swage::lesson_pass
