// SPDX-License-Identifier: Apache-2.0
#include "judge.hpp"

#include <algorithm>
#include <numbers>

namespace swage::lesson_grasp {
namespace {

// Opening of the jaws between two grasp attempts, at least, rad.
constexpr double kReopened = 0.035;
// Rotation of the needle on grasping is measured this long after both jaws hold it, s.
constexpr double kSnapTime = 0.1;

// Distance from its start at which a held needle counts as lifted, m.
constexpr double kLifted = 0.2e-3;
// Points deducted for each interrupted hold at the target, and how many are counted.
constexpr double kBreakCosts = 5, kMostBreaks = 3;

}  // namespace

Judge::Judge(const Rules& rules, double dt)
    : rules_(rules),
      path_(dt),
      drop_(rules.drop_distance),
      grip_(rules.force_high, dt),
      target_(rules.target),
      tremor_(dt) {}

bool Judge::square(const Memory& memory, const Look& look) const {
  constexpr double kLeaves = 1.1;
  const double most = (memory.holding != 0 ? kLeaves : 1.0) * rules_.max_tilt;
  return rules_.max_tilt <= 0 || std::max(std::abs(look.tilt_axis), std::abs(look.tilt_plane)) <= most;
}

/// Whether the cue shows a tilt: above max_tilt; where any tilt is allowed, above kTold, the limit of other lessons.
bool Judge::tilted(const Memory& memory, const Look& look) const {
  constexpr double kTold = std::numbers::pi / 9;  // rad, 20 deg
  if (rules_.max_tilt > 0) return !square(memory, look);
  return std::max(std::abs(look.tilt_axis), std::abs(look.tilt_plane)) > kTold;
}

double Judge::spot_error(double s) const {
  return std::max({0.0, rules_.region_low - s, s - rules_.region_high});
}

Finding Judge::look(Memory& memory, const Look& look) const noexcept {
  Finding finding;
  if (memory.begun == 0) begin(memory, look);
  path_.look(memory.path, look.tip_W, look.time_s);
  count(memory, look);
  integrate(memory, look);
  finding.too_hard = GripWatch::too_hard(memory.grip);
  follow_drop(memory, look, finding);
  follow_hold(memory, look, finding);
  measure(memory, look, finding);
  decide(memory, look, finding);
  return finding;
}

void Judge::begin(Memory& memory, const Look& look) const noexcept {
  memory.begun = 1;
  Eigen::Map<Vec3>(memory.start) = Eigen::Map<Vec3>(memory.taken) = look.needle_W;
  DropWatch::rest(memory.drop, look.needle_W);
}

void Judge::count(Memory& memory, const Look& look) const noexcept {
  // a grasp attempt is one closing of the jaws that touches; counted up to the first correct grasp
  memory.least_opening = std::min(memory.least_opening, look.opening);
  if (look.opening > memory.least_opening + kReopened) memory.tried = 0;
  if (look.touched && memory.tried == 0 && memory.good_grasps == 0) {
    memory.tries += 1;
    memory.tried = 1;
    memory.least_opening = look.opening;
  }

  if (look.touched) {
    if (memory.touched_s < 0) memory.touched_s = look.time_s;
    memory.engaged = 1;
    const Quat& q = look.q_WN;
    const double now[4] = {q.w(), q.x(), q.y(), q.z()};
    std::copy(now, now + 4, memory.touch_q);
  }
  if (look.taken) {
    memory.engaged = 1;
    Eigen::Map<Vec3>(memory.taken) = look.needle_W;
    if (memory.good_grasps > 0) memory.regrasps += 1;
    memory.grasps += 1;
    memory.spot_error_sum += spot_error(look.s);
    if (in_region(look.s)) memory.good_grasps += 1;
    memory.snap_wait_s = kSnapTime;
  }

  // rotation of the needle from the first touch until kSnapTime after the grasp
  if (memory.snap_wait_s <= 0) return;
  memory.snap_wait_s -= look.dt_s;
  if (memory.snap_wait_s > 0) return;
  const Quat before(memory.touch_q[0], memory.touch_q[1], memory.touch_q[2], memory.touch_q[3]);
  memory.snap_sum += toolkit::log_rotation(look.q_WN * before.conjugate()).norm();
}

void Judge::integrate(Memory& memory, const Look& look) const noexcept {
  grip_.look(memory.grip, look.force, look.held, look.time_s, look.dt_s);
  if (!look.held) return;
  memory.reach_s += look.tip_reach * look.dt_s;
  memory.axis_s += std::abs(look.tilt_axis) * look.dt_s;
  memory.plane_s += std::abs(look.tilt_plane) * look.dt_s;
  memory.balance_s += look.balance * look.dt_s;
  if (memory.grip.now > rules_.force_high) {
    memory.over_s += look.dt_s;
    memory.over_dose += (memory.grip.now - rules_.force_high) * look.dt_s;
  }
}

void Judge::follow_drop(Memory& memory, const Look& look, Finding& finding) const noexcept {
  // the signal of a hold outlasts the hold, and by then a dropped object has landed: the force shows a drop at once
  finding.dropped = drop_.look(memory.drop, look.needle_W, look.held && look.force > 0);
  if (finding.dropped) {
    memory.drops += 1;
    memory.engaged = 0;
  }
  if (look.reset) {
    memory.resets += 1;
    DropWatch::rest(memory.drop, look.needle_W);
  }
  // the needle was put back to its start
  const Vec3 start = Eigen::Map<const Vec3>(memory.start);
  if (memory.drop.armed == 0 && (look.needle_W - start).norm() < 0.1 * rules_.drop_distance) {
    DropWatch::rest(memory.drop, look.needle_W);
  }
}

bool Judge::grasped_well(const Memory& memory, const Look& look, const Finding& finding) const noexcept {
  const Vec3 taken = Eigen::Map<const Vec3>(memory.taken);
  const bool lifted = rules_.lift <= 0 || (look.needle_W - taken).norm() >= rules_.lift;
  const bool measured = look.force >= rules_.force_low && !finding.too_hard;
  const bool tips = in_tips(look.tip_reach) || !rules_.tips_needed;
  return look.held && in_region(look.s) && tips && square(memory, look) && lifted && measured;
}

void Judge::follow_hold(Memory& memory, const Look& look, Finding& finding) const noexcept {
  const bool spot = in_region(look.s), tips = in_tips(look.tip_reach);
  if (look.held && spot) finding.grade = !tips ? Grade::kPointOnly : tilted(memory, look) ? Grade::kTilted : Grade::kGood;
  if (look.held && !spot) finding.grade = tips ? Grade::kTipsOnly : Grade::kWrong;
  memory.wrong_s = look.held && !spot ? memory.wrong_s + look.dt_s : 0;

  const bool carry = rules_.target.carry, well = grasped_well(memory, look, finding);
  finding.near_target =
      carry && target_.look(memory.target, look.held ? look.target_distance : 1e9, look.time_s, look.dt_s);
  const bool good = well && (!carry || finding.near_target);
  const bool was = memory.hold_s > 0 && memory.holding != 0;
  finding.hold_began = good && !was;
  finding.hold_broke = !good && was;
  memory.holding = good ? 1 : 0;
  if (finding.hold_began && memory.hold_s == 0) memory.target.hold_began_s = look.time_s;
  if (finding.hold_broke) memory.target.breaks += 1;
  if (good) {
    memory.hold_s += look.dt_s;
    Target::hold(memory.target, look.target_distance, look.dt_s);
  } else if (!carry || rules_.target.leave != Leave::kPause) {
    memory.hold_s = 0;
  }
  memory.best_hold_s = std::max(memory.best_hold_s, memory.hold_s);
  finding.stage = good                                 ? Stage::kHold
                  : carry && well                      ? Stage::kCarry
                  : look.held && !spot && !rules_.ends ? Stage::kRegrasp
                  : memory.engaged != 0                ? Stage::kGrasp
                  : memory.drop.armed == 0             ? Stage::kDropped
                                                       : Stage::kApproach;
}

void Judge::measure(Memory& memory, const Look& look, const Finding& finding) const noexcept {
  const bool holds = finding.stage == Stage::kHold;
  memory.phase_s[static_cast<size_t>(finding.stage)] += look.dt_s;
  memory.bending = std::max(memory.bending, look.bending);
  const bool at_work = memory.path.set_off_s >= 0 && !holds;
  idle_.look(memory.idle, Eigen::Map<const Vec3>(memory.path.last), look.opening, memory.grip.now, look.dt_s, at_work);
  tremor_.look(memory.tremor, look.tip_W, holds);
  const Vec3 start = Eigen::Map<const Vec3>(memory.start);
  if (!look.held || (look.needle_W - start).norm() < kLifted) return;
  memory.lifted_s += look.dt_s;
  if (look.force < rules_.force_low) memory.timid_s += look.dt_s;
  lessons::spread(memory.spread, memory.grip.now, look.dt_s);
}

void Judge::decide(Memory& memory, const Look& look, Finding& finding) const noexcept {
  const Vec3 start = Eigen::Map<const Vec3>(memory.start);
  if (memory.hold_s >= rules_.hold_time)
    finding.end = End::kPassed;
  else if (rules_.ends && memory.drops > rules_.max_drops)
    finding.end = End::kDropped;
  else if (rules_.ends && memory.over_s > rules_.max_over_time)
    finding.end = End::kTooHard;
  else if (rules_.ends && rules_.max_wrong_time > 0 && memory.wrong_s > rules_.max_wrong_time)
    finding.end = End::kWrongGrasp;
  else if (rules_.ends && rules_.target.carry && rules_.target.leave == Leave::kFail && finding.hold_broke)
    finding.end = End::kLeftTarget;
  else if (rules_.ends && !look.held && (look.needle_W - start).norm() > rules_.lost_distance)
    finding.end = End::kLost;
  else if (rules_.ends && look.time_s >= rules_.max_time)
    finding.end = End::kOutOfTime;
  if (finding.end == End::kRunning) return;
  memory.passed = finding.end == End::kPassed ? 1 : 0;
  finding.stage = Stage::kDone;
  finding.lost = points(memory, look.time_s);
  finding.score = score(memory, finding.lost, finding.end == End::kPassed);
}

Points Judge::points(const Memory& memory, double time_s) const noexcept {
  const double late = task_time(memory, time_s) / rules_.par_time - 1;
  const double tilt = 0.5 * (mean(memory, memory.axis_s) + mean(memory, memory.plane_s));  // rad
  Points lost;
  lost.tries = 8 * std::clamp(memory.tries - 1, 0.0, 5.0);
  lost.drops = 15 * (memory.drops + memory.resets);
  if (rules_.target.carry) lost.hold = kBreakCosts * std::min(memory.target.breaks, kMostBreaks);
  lost.force = 40 * mean(memory, memory.over_s);
  lost.tilt = 20 * std::min(1.0, tilt / (0.25 * std::numbers::pi));
  lost.bending = lessons::bending_points(memory.bending);
  lost.time = 15 * std::clamp(late, 0.0, 1.0);
  return lost;
}

double Judge::score(const Memory& memory, const Points& lost, bool passed) const noexcept {
  // an attempt that did not pass scores at most 40: the share of the hold that was reached
  if (!passed) return 40 * std::min(1.0, memory.best_hold_s / rules_.hold_time);
  return std::clamp(100 - lost.sum(), 40.0, 100.0);
}

}  // namespace swage::lesson_grasp
