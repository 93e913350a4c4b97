// SPDX-License-Identifier: Apache-2.0
//
// The act "wind": the tips about another gripper, the thread kept drawn.
#include <algorithm>
#include <numbers>

#include "skilled.hpp"

namespace swage::skilled {

/// A share of the way of a winding: about the other gripper's line, at the radius that it has now; the tool does not turn.
Pose Skilled::wound(const Act& act, double u) const {
  const Vec3 d = from_.p - about_W_, along = d.dot(about_axis_W_) * about_axis_W_, out = (d - along).normalized();
  const Quat q = toolkit::exp_rotation(u * act.turns * 2 * std::numbers::pi * about_axis_W_);
  return {about_W_ + along + u * act.along * about_axis_W_ + radius_ * (q * out), from_.q};
}

/// Draws the thread while it feels too little of it and gives way while it feels too much; never through the other gripper.
void Skilled::feel(const Act& act, double dt) {
  constexpr double kNearest = 0.5e-3;  // m, half the width of a pair of jaws
  const double way = seen_.signal < act.more ? 1 : seen_.signal > act.less ? -1 : 0;
  radius_ = std::max(kNearest, radius_ + way * act.by * dt);
}

}  // namespace swage::skilled
