// SPDX-License-Identifier: Apache-2.0
#include "judge.hpp"

#include <algorithm>

namespace swage::lesson_ring {
namespace {

// Least force of a touch, N: the noise of the solver is below 1 uN, the weight of a steel ring is 15 uN.
constexpr double kTouchForce = 1e-4;
// Least time between two touches, s, as for stray touches of tissue.
constexpr double kApart = 0.15;
// Distance from its start at which a held ring counts as lifted, m.
constexpr double kLifted = 0.2e-3;
// A line passes through the ring within this share of its radius, at less than 60 deg (cosine 0.5) to its axis.
constexpr double kHole = 0.95, kUpright = 0.5;
// Place on a post, 0 foot to 1 top, below which a ring is over the post.
constexpr double kOver = 0.85;
// Shares of the wire: place that counts as its end, and length after which a ring that never came clear counts as carried.
constexpr double kAtEnd = 0.97, kSetOff = 0.03;
// Time that a ring must rest on the last post after it was let go, s.
constexpr double kRest = 0.3;

}  // namespace

Judge::Judge(const Rules& rules, double dt)
    : rules_(rules), path_(dt), drop_(rules.drop_distance), grip_(rules.force_high, dt), tremor_(dt) {}

bool Judge::threaded(const Line& line, double ring_radius) {
  return line.distance < kHole * ring_radius && line.cosine > kUpright;
}

double Judge::progress(const Memory& memory) const { return memory.free != 0 ? 1 : memory.reached; }

Finding Judge::look(Memory& memory, const Look& look) const noexcept {
  Finding finding;
  if (memory.begun == 0) {
    memory.begun = 1;
    Eigen::Map<Vec3>(memory.start) = look.ring_W;
    DropWatch::rest(memory.drop, look.ring_W);
  }
  path_.look(memory.path, look.tip_W, look.time_s);
  grip_.look(memory.grip, look.force, look.held, look.time_s, look.dt_s);
  finding.too_hard = GripWatch::too_hard(memory.grip);
  if (look.taken) memory.grasps += 1;
  if (look.held && memory.grip.now > rules_.force_high) memory.over_s += look.dt_s;
  follow_touch(memory, look, finding);
  follow_wire(memory, look);
  follow_posts(memory, look, finding);
  follow_ring(memory, look, finding);
  decide(memory, look, finding);
  return finding;
}

// The ring lies on the wire when it is taken: touches count once it has come clear, or has moved along the wire by kSetOff.
void Judge::follow_touch(Memory& memory, const Look& look, Finding& finding) const noexcept {
  const bool touches = look.touch > kTouchForce;
  memory.untouched_s = touches ? 0 : memory.untouched_s + look.dt_s;
  const bool clear = memory.untouched_s >= kApart && (look.ring_W - Eigen::Map<const Vec3>(memory.start)).norm() > kLifted;
  if (look.held && (clear || (memory.first_s >= 0 && memory.reached > memory.first_s + kSetOff))) memory.lifted = 1;
  finding.carried = look.held && memory.lifted != 0;
  tremor_.look(memory.tremor, look.tip_W, finding.carried);
  if (memory.untouched_s >= kApart) memory.touching = 0;
  if (!finding.carried) return;
  memory.carried_s += look.dt_s;
  finding.touching = touches;
  if (!touches) return;
  memory.touch_s += look.dt_s;
  memory.touch_peak = std::max(memory.touch_peak, look.touch);
  finding.touched = memory.touching == 0;
  if (finding.touched) memory.touches += 1;
  memory.touching = 1;
}

void Judge::follow_wire(Memory& memory, const Look& look) const noexcept {
  if (memory.free != 0 || !look.held) return;
  const bool round = threaded(look.wire, look.ring_radius);
  const double length = rules_.course_high - rules_.course_low;
  const double at = std::clamp((look.wire.s - rules_.course_low) / length, 0.0, 1.0);
  if (memory.first_s < 0) memory.first_s = at, memory.last_s = look.wire.s;
  if (!round) {
    // past the end the wire no longer passes through the ring
    if (memory.reached >= kAtEnd) memory.free = 1;
    return;
  }
  const double way = std::abs(look.wire.s - memory.last_s) * look.wire_length;
  memory.last_s = look.wire.s;
  memory.reached = std::max(memory.reached, at);
  if (memory.lifted == 0) return;
  memory.travel += way;
  memory.off2 += look.wire.distance * look.wire.distance * way;
  const double angle = std::acos(std::min(1.0, look.wire.cosine));
  memory.tilt2 += angle * angle * way;
}

void Judge::follow_posts(Memory& memory, const Look& look, Finding& finding) const noexcept {
  if (memory.free == 0 || memory.posts >= rules_.posts) return;
  finding.over_post = threaded(look.post, look.ring_radius) && look.post.s < kOver;
  const bool last = memory.posts + 1 >= rules_.posts;
  memory.rest_s = finding.over_post && !look.held ? memory.rest_s + look.dt_s : 0;
  finding.post_done = last ? memory.rest_s >= kRest : finding.over_post;
  if (finding.post_done) memory.posts += 1;
}

void Judge::follow_ring(Memory& memory, const Look& look, Finding& finding) const noexcept {
  // a ring that is let go over the last post slides down the post
  const bool safe = finding.over_post && memory.posts + 1 >= rules_.posts;
  finding.dropped = drop_.look(memory.drop, look.ring_W, (look.held && look.force > 0) || safe);
  if (finding.dropped) memory.drops += 1;
  finding.stage = memory.free != 0          ? Stage::kPost
                  : memory.first_s >= 0     ? Stage::kCarry
                                            : Stage::kTake;
}

void Judge::decide(Memory& memory, const Look& look, Finding& finding) const noexcept {
  const bool done = memory.free != 0 && memory.posts >= rules_.posts;
  const Vec3 start = Eigen::Map<const Vec3>(memory.start);
  if (done)
    finding.end = End::kPassed;
  else if (rules_.ends && memory.touches > rules_.max_touches)
    finding.end = End::kTouched;
  else if (rules_.ends && memory.drops > rules_.max_drops)
    finding.end = End::kDropped;
  else if (rules_.ends && memory.over_s > rules_.max_over_time)
    finding.end = End::kTooHard;
  else if (rules_.ends && !look.held && (look.ring_W - start).norm() > rules_.lost_distance)
    finding.end = End::kLost;
  else if (rules_.ends && look.time_s >= rules_.max_time)
    finding.end = End::kOutOfTime;
  if (finding.end == End::kRunning) return;
  finding.stage = Stage::kDone;
  memory.passed = done ? 1 : 0;
  finding.lost.touches = 4 * std::min(memory.touches, 10.0);
  finding.lost.touch_time = 20 * std::min(1.0, touch_share(memory) / 0.2);
  finding.lost.drops = 15 * memory.drops;
  finding.lost.force = 20 * over_share(memory);
  finding.lost.time = 15 * std::clamp(task_time(memory, look.time_s) / rules_.par_time - 1, 0.0, 1.0);
  // an attempt that did not pass scores at most 40: the completed share of wire and posts
  const double share = (progress(memory) + memory.posts) / (1 + rules_.posts);
  finding.score = done ? std::clamp(100 - finding.lost.sum(), 40.0, 100.0) : 40 * share;
}

}  // namespace swage::lesson_ring
