// SPDX-License-Identifier: Apache-2.0
#include "judge.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/measures.hpp"

namespace swage::lesson_insertion {
namespace {

// Wound, in radii of the wire, that careful hands leave at most.
constexpr double kGoodWound = 2;
// Share of the needle between the surface and the jaws from which a second grasp counts as one on the other side.
constexpr double kOtherSide = 0.02;
// m along the needle between the surface and the middle of the jaws. 0.6 mm behind their tips the jaws of the sewing lessons are 0.4 mm wide:
// from 0.2 mm on they push on the tissue. With less the trainee is told too late, with more while there is still way to go.
constexpr double kJawsReach = 0.35e-3;

// Points deducted for an exit wound in radii of the wire, of 15: none up to what careful hands leave, all from the greatest entry wound on.
double exit_points(const Rules& rules, double wound) {
  if (rules.task != Task::kStitch || wound <= kGoodWound) return 0;
  return 15 * std::min(1.0, (wound - kGoodWound) / std::max(1e-9, rules.max_wound - kGoodWound));
}

double along_surface(const Vec3& way, const Vec3& normal) { return (way - way.dot(normal) * normal).norm(); }

}  // namespace

Judge::Judge(const Rules& rules, double dt)
    : rules_(rules), path_(dt), drop_(rules.drop_distance), grip_(rules.force_high, dt) {}

Finding Judge::look(Memory& memory, const Look& look) const noexcept {
  Finding finding;
  if (memory.begun == 0) {
    memory.begun = 1;
    DropWatch::rest(memory.drop, look.needle_W);
  }
  path_.look(memory.path, look.tip_W, look.time_s);
  follow_entry(memory, look, finding);
  if (rules_.far.there) follow_far(memory, look, finding);
  integrate(memory, look);
  grip_.look(memory.grip, look.force, look.held, look.time_s, look.dt_s);
  if (look.held) memory.reach_s += look.tip_reach * look.dt_s;
  memory.bending = std::max(memory.bending, look.bending);
  follow_twist(memory.twist, look);
  finding.too_hard = GripWatch::too_hard(memory.grip);
  follow_needle(memory, look, finding);
  finding.damaged = SutureWatch::look(rules_.suture, memory.suture, look.suture, look.held, look.grip_s, look.length, look.dt_s,
                                       memory.through != 0 && memory.retaken != 0);
  finding.cut_off = rules_.suture.cut && look.suture.parted;
  finding.cut_tail = memory.suture.cut_off.tail;
  follow_stitch(memory, look, finding);
  finding.swage_held = memory.suture.grasped != 0;
  finding.taut = rules_.suture.tension > 0 && look.suture.tension > rules_.suture.tension;
  finding.loop_good = rules_.suture.loop > 0 && memory.suture.right_s > 0;
  finding.stage = stage(memory, look);
  finding.grip = how_held(look);
  decide(memory, look, finding);
  return finding;
}

// Deflections within kApart count once, as of a point that skips along a surface or its side.
void Judge::count_deflection(Memory& memory, const Look& look, bool deflected) noexcept {
  constexpr double kApart = 1;  // s
  if (!deflected || look.time_s - memory.deflected_s < kApart) return;
  memory.deflections += 1;
  memory.deflected_s = look.time_s;
}

void Judge::follow_entry(Memory& memory, const Look& look, Finding& finding) const noexcept {
  count_deflection(memory, look, look.deflected);
  if (look.entered) {
    memory.entries += 1;
    memory.entry_distance = along_surface(look.entry_W - look.target_W, look.normal_W);
    memory.entry_angle = look.angle;
    memory.wall = look.hole.wall;
    memory.missed = memory.entry_distance > rules_.tolerance ? 1 : 0;
    memory.tracked = 0;
    memory.deepest = 0;
    finding.missed = memory.missed != 0;
    Stitches::enter(memory.stitch, look.hole);
  }
  if (look.exited && !rules_.far.there) {
    memory.exited = 1;
    memory.exit_angle = look.exit_angle;
    memory.exit_distance = along_surface(look.hole.p_W - look.exit_target_W, look.hole.normal_W);
    Stitches::exit(memory.stitch, look.hole, 2 * look.diameter);
  }
  if (look.passed && !rules_.far.there) memory.through = 1;

  // the point is above the place of the entry
  const Vec3 ahead = look.point_W - look.target_W;
  finding.near = !inside(look) && look.held && ahead.norm() < 4 * rules_.tolerance &&
                 along_surface(ahead, look.normal_W) < rules_.tolerance;
  finding.exit_near = rules_.exit_mark && memory.exited != 0 && memory.exit_distance < rules_.tolerance;
}

/// Follows the bite out of the near edge, into the far edge and out of it. A point that goes back begins that part anew.
void Judge::follow_far(Memory& memory, const Look& look, Finding& finding) const noexcept {
  FarState& far = memory.far;
  if (look.entered) far.near_out = far.near_passed = 0;
  if (look.exited) far.near_out = 1, far.near_edge = look.hole.edge;
  if (look.passed) far.near_passed = 1;
  if (!look.in_tissue && far.near_passed == 0) far.near_out = 0;
  count_deflection(memory, look, look.far.deflected);
  if (look.far.entered) finding.far_first = FarEdge::enter(far, look.far, look.in_tissue);
  if (look.far.exited && far.in != 0) {
    memory.exited = 1;
    memory.exit_angle = look.far.exit_angle;
    memory.exit_distance = along_surface(look.far.hole.p_W - look.exit_target_W, look.far.hole.normal_W);
    Stitches::exit(memory.stitch, look.far.hole, 2 * look.diameter);
  }
  if (look.far.passed) far.passed = far.in;
  if (!look.far.in_tissue && far.passed == 0 && far.in != 0) far.in = memory.exited = memory.let_go = memory.retaken = 0;
  if (far.near_passed != 0 && far.passed != 0) memory.through = 1;
}

// Angles are weighted by the travel of the needle through its entry, so that waiting changes no mean.
void Judge::integrate(Memory& memory, const Look& look) const noexcept {
  const auto add = [&](double& tracked, double& last_s, double s, double angle, double cosine, double arc_error) {
    const double way = tracked != 0 ? std::abs(s - last_s) * look.length : 0;
    last_s = s;
    tracked = 1;
    memory.travel += way;
    if (angle <= rules_.in_angle) memory.travel_in += way;
    memory.angle2 += angle * angle * way;
    memory.arc2 += arc_error * arc_error * way;
    memory.inside_s += look.dt_s;
    memory.cosine_s += cosine * look.dt_s;
  };
  const FarLook& far = look.far;
  if (!look.in_tissue) memory.tracked = 0;
  if (!far.in_tissue) memory.far.tracked = 0;
  if (look.in_tissue) {
    add(memory.tracked, memory.last_s, look.s, look.angle, look.cosine, look.arc_error);
    memory.deepest = std::max(memory.deepest, look.s);
    memory.pull_s += look.pull * look.dt_s;
  }
  if (far.in_tissue) {
    add(memory.far.tracked, memory.far.last_s, far.s, far.angle, far.cosine, far.arc_error);
    memory.pull_s += far.pull * look.dt_s;
  }
}

void Judge::follow_twist(TwistState& twist, const Look& look) noexcept {
  if (!look.held) twist.from = 0;
  if (!look.held || !look.touching) return;
  if (twist.from == 0) twist.axis = look.tilt_axis, twist.plane = look.tilt_plane;
  twist.from = twist.told = 1;
  twist.most = std::max({twist.most, std::abs(look.tilt_axis - twist.axis), std::abs(look.tilt_plane - twist.plane)});
}

void Judge::follow_needle(Memory& memory, const Look& look, Finding& finding) const noexcept {
  // a needle that sticks in the tissue has not been dropped
  finding.dropped = drop_.look(memory.drop, look.needle_W, look.held || inside(look));
  if (finding.dropped) memory.drops += 1;
  follow_jaws(memory, look);
  const bool asked = memory.reached != 0 || (memory.exited != 0 && rules_.task == Task::kStitch);
  finding.stuck = inside(look) && !look.held && !asked;
  finding.angle_off = (look.in_tissue && look.angle > rules_.in_angle) || (look.far.in_tissue && look.far.angle > rules_.in_angle);
  finding.angle_good = inside(look) && !finding.angle_off && (look.held || !asked);
  finding.torn = wound(look) > kGoodWound;

  // the other side: let go once the point is out, and grasped again beyond the exit
  const double crossed = rules_.far.there ? look.far.s : look.s;
  if (memory.exited != 0 && !look.held) memory.let_go = 1;
  if (memory.let_go != 0 && look.held && look.grip_s < crossed - kOtherSide) memory.retaken = 1;
}

/// Notes jaws that are at the tissue before the needle is in far enough, or out: it must be taken again further back.
void Judge::follow_jaws(Memory& memory, const Look& look) const noexcept {
  if (!inside(look)) memory.reached = 0;
  if (!look.in_tissue || !look.held || memory.exited != 0) return;
  const bool more = rules_.task == Task::kStitch || look.s < rules_.drive;
  const double room = (look.grip_s - look.s) * look.length;  // m
  if (more && room < kJawsReach) memory.reached = 1;
  if (room > 2 * kJawsReach) memory.reached = 0;
}

void Judge::follow_stitch(Memory& memory, const Look& look, Finding& finding) const noexcept {
  follow_stray(memory.stray, look.needle_astray || look.far.needle_astray, look.jaws_astray || look.far.jaws_astray, look.dt_s);
  if (rules_.task != Task::kStitch || memory.through == 0 || memory.retaken == 0) return;
  if (memory.missed != 0 || !SutureWatch::done(rules_.suture, memory.suture)) return;
  Stitches::finish(memory.stitch);
  SutureWatch::finish(rules_.suture, memory.suture);
  memory.worst_entry = std::max(memory.worst_entry, memory.entry_distance);
  memory.worst_wound = std::max(memory.worst_wound, look.wound);
  memory.worst_exit = std::max(memory.worst_exit, exit_wound(look, rules_.far));
  if (memory.stitch.count >= rules_.stitches) return;
  memory.exited = memory.let_go = memory.retaken = memory.through = memory.reached = 0;
  FarEdge::finish(memory.far, look.far.wound);
  SutureWatch::go_on(rules_.suture, memory.suture);
  finding.stitched = true;
}

Stage Judge::stage(const Memory& memory, const Look& look) const noexcept {
  if (memory.retaken != 0 && memory.through == 0) return Stage::kPull;
  if (memory.retaken != 0 && !SutureWatch::drawn(rules_.suture, memory.suture)) return Stage::kDraw;
  if (memory.retaken != 0) return rules_.suture.cut ? Stage::kCutOff : Stage::kPull;
  if (memory.let_go != 0 && rules_.task == Task::kStitch) return Stage::kRetake;
  if (memory.exited != 0 && rules_.task == Task::kStitch) return Stage::kRelease;
  if (memory.reached != 0) return Stage::kRegrasp;
  if (memory.far.near_out != 0) return Stage::kCross;
  if (inside(look)) return Stage::kDrive;
  return look.held ? Stage::kAim : Stage::kTake;
}

Grip Judge::how_held(const Look& look) const noexcept {
  if (!look.held || inside(look) || rules_.region_high <= rules_.region_low) return Grip::kNone;
  const bool place = look.grip_s >= rules_.region_low && look.grip_s <= rules_.region_high;
  const bool tips = look.tip_reach >= rules_.tip_low && look.tip_reach <= rules_.tip_high;
  if (place) return tips ? Grip::kGood : Grip::kPointOnly;
  return tips ? Grip::kTipsOnly : Grip::kWrong;
}

void Judge::decide(const Memory& memory, const Look& look, Finding& finding) const noexcept {
  const bool done = rules_.task == Task::kInsert ? look.in_tissue && look.s >= rules_.drive
                                                 : memory.through != 0 && memory.retaken != 0 &&
                                                       SutureWatch::done(rules_.suture, memory.suture);
  const double widest = std::max({wound(look), memory.worst_wound, memory.far.worst_wound});
  if (done)
    finding.end = memory.missed != 0                               ? End::kMissed
                  : widest > rules_.max_wound                      ? End::kTorn
                  : FarEdge::uneven(rules_.far, memory.far)        ? End::kStep
                  : in_angle_share(memory) < rules_.least_in_angle ? End::kOffAngle
                                                                   : End::kPassed;
  else if (rules_.ends && wound(look) > rules_.max_wound)
    finding.end = End::kTorn;
  else if (rules_.ends && memory.drops > rules_.max_drops)
    finding.end = End::kDropped;
  else if (rules_.ends && memory.deflections > rules_.max_deflections)
    finding.end = End::kDeflected;
  else if (rules_.ends && !look.held && !inside(look) && (look.needle_W - look.target_W).norm() > rules_.lost_distance)
    finding.end = End::kLost;
  else if (memory.suture.off != 0)
    finding.end = End::kPulledOff;
  else if (memory.suture.lost != 0)
    finding.end = End::kTailLost;
  else if (rules_.ends && look.time_s >= rules_.max_time)
    finding.end = End::kOutOfTime;
  if (finding.end == End::kRunning) return;
  finding.stage = Stage::kDone;
  finding.lost = points(memory, look);
  finding.score = score(memory, finding.lost, finding.end == End::kPassed);
}

Points Judge::points(const Memory& memory, const Look& look) const noexcept {
  const double late = task_time(memory, look.time_s) / rules_.par_time - 1;
  Points lost;
  lost.wound = 30 * std::clamp((std::max({wound(look), memory.worst_wound, memory.far.worst_wound}) - 1) / 2, 0.0, 1.0);
  lost.exit = exit_points(rules_, std::max(memory.worst_exit, exit_wound(look, rules_.far)));
  lost.angle = 30 * std::clamp(angle_rms(memory) / (0.25 * std::numbers::pi), 0.0, 1.0);
  lost.entry = 15 * std::clamp(std::max(memory.entry_distance, memory.worst_entry) / rules_.tolerance, 0.0, 1.0);
  lost.bending = lessons::bending_points(memory.bending);
  lost.refused = 8 * std::clamp(memory.deflections, 0.0, 3.0);
  lost.drops = 15 * memory.drops;
  lost.suture = SutureWatch::points(memory.suture);
  lost.time = 15 * std::clamp(late, 0.0, 1.0);
  lost.loops = 15 * std::clamp(2 * SutureWatch::unlike_loops(rules_.suture, memory.suture), 0.0, 1.0);
  lost.tension = 15 * std::clamp(SutureWatch::over_tension(rules_.suture, memory.suture), 0.0, 1.0);
  if (rules_.suture.cut) lost.tails = CutWatch::points(memory.suture.cut_off, rules_.suture.tail_tolerance);
  lost.step = FarEdge::points(rules_.far, memory.far);
  if (rules_.far.there) lost.bites = 10 * std::clamp(Stitches::asymmetry(memory.stitch), 0.0, 1.0);
  if (rules_.stitches < 2) return lost;
  lost.even = 10 * std::clamp(2 * Stitches::unevenness(memory.stitch), 0.0, 1.0);
  lost.bites = 10 * std::clamp(Stitches::unequal(memory.stitch), 0.0, 1.0);
  lost.oblique = 10 * std::clamp(memory.stitch.most_oblique / (0.25 * std::numbers::pi), 0.0, 1.0);
  return lost;
}

double Judge::score(const Memory& memory, const Points& lost, bool passed) const noexcept {
  // an attempt that did not pass scores at most 40: the completed share, if the entry was within the tolerance
  const double share = (memory.stitch.count + std::min(1.0, memory.deepest / rules_.drive)) / rules_.stitches;
  if (!passed) return memory.missed != 0 ? 0 : 40 * std::min(1.0, share);
  return std::clamp(100 - lost.sum(), 40.0, 100.0);
}

}  // namespace swage::lesson_insertion
