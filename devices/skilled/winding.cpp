// SPDX-License-Identifier: Apache-2.0
//
// The acts "wind", tips around another gripper with the thread kept taut, and "draw", along a path until the thread is taut.
#include <algorithm>
#include <numbers>

#include "skilled.hpp"

namespace swage::skilled {
namespace {

constexpr double kNearest = 0.5e-3;  // m, half the width of a pair of jaws: nearer the tips would be in the other gripper
// s, in which a hand that feels the thread changes its speed. Less: it starts and stops within a step, and the thread slides by jerks. More: it overshoots.
constexpr double kChanges = 5e-3;
// s, in which it becomes quicker again by a factor of e after it has turned back. Less: on a taut thread it goes to and fro.
constexpr double kForgets = 0.1;
constexpr double kSlowest = 1.0 / 64;  // share of its speed that is left after it has turned back again and again

}  // namespace

/// Pose after a share of a winding: about the other gripper's axis, at its present radius.
Pose Skilled::wound(const Act& act, double u) const {
  const Vec3 d = from_.p - about_W_, along = d.dot(about_axis_W_) * about_axis_W_, out = (d - along).normalized();
  const Quat q = toolkit::exp_rotation(u * act.turns * 2 * std::numbers::pi * about_axis_W_);
  const Quat own = toolkit::exp_rotation(u * act.roll * Vec3::UnitX());
  const Vec3 gone = act.follows ? Vec3(seen_.tip_W - about_W_) : Vec3(Vec3::Zero());
  return {about_W_ + gone + along + u * act.along * about_axis_W_ + std::max(kNearest, radius_ - u * act.in) * (q * out), ((act.rolls ? Quat(q * from_.q) : from_.q) * own).normalized()};
}

/// Moves outwards while the felt tension is too small and inwards while it is too large; never into the other gripper. Each time it turns back it goes half as
/// quickly: in a millisecond at 20 mm/s a hand changes the tension of a taut thread of 200 N/m by 4 mN, more than lies between the two limits.
void Skilled::feel(const Act& act, double dt) {
  const double way = seen_.signal < act.more ? 1 : seen_.signal > act.less ? -1 : 0;
  if (way * way_ < 0) pace_ = std::max(kSlowest, 0.5 * pace_);
  if (way != 0) way_ = way;
  pace_ = std::min(1.0, pace_ * (1 + dt / kForgets));
  outwards_ += std::min(1.0, dt / kChanges) * (way * pace_ * act.by - outwards_);
  radius_ = std::max(kNearest, radius_ + outwards_ * dt);
}

/// Advances by `share` of its path, more slowly from half of the signal limit on, and back above the limit at no more than half speed.
void Skilled::draw(const Act& act, double share) {
  const double pace = std::clamp(2 * (1 - seen_.signal / act.less), -0.5, 1.0);
  drawn_share_ = std::clamp(drawn_share_ + pace * share, 0.0, 1.0);
}

}  // namespace swage::skilled
