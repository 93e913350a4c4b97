// SPDX-License-Identifier: Apache-2.0
//
// A free solid in the fluid of the lesson's environment: drag and buoyancy. Without a medium there is neither.
#include <numbers>

#include "solids.hpp"
#include "toolkit/fluid_drag.hpp"

namespace swage::solids {

using toolkit::Vec3;

namespace {
// Number of straight pieces of a cylinder, which rotates, and of a ring: half as many differ by 1 %.
constexpr int kCuts = 8, kRingCuts = 24;
}  // namespace

void SolidObject::forces(const Step& step) {
  if (fixed_ || environment_.medium == SWAGE_MEDIUM_UNSET) return;
  const toolkit::Pose X_WB(step.pose(body_));
  const toolkit::RigidMotion V{toolkit::vec(step.twist(body_).v), toolkit::vec(step.twist(body_).w)};
  toolkit::FluidDrag drag({environment_.density, environment_.viscosity}, V);
  if (ring_ > 0) {
    for (int k = 0; k < kRingCuts; ++k) {
      const double a = 2 * std::numbers::pi * k / kRingCuts;
      const Vec3 out(std::cos(a), std::sin(a), 0), along(-out.y(), out.x(), 0);
      drag.add_piece(X_WB.q * Vec3(ring_ * out), X_WB.q * along, extent_ / kRingCuts, thickness_);
    }
  } else if (length_ > 0) {
    const Vec3 axis = X_WB.q * Vec3::UnitZ();
    for (int k = 0; k < kCuts; ++k) drag.add_piece(((k + 0.5) / kCuts - 0.5) * length_ * axis, axis, length_ / kCuts, thickness_);
  } else {
    drag.add_sphere(thickness_);
  }
  const toolkit::Mat3 R = X_WB.q.toRotationMatrix();
  const double borne = environment_.density / density_;
  const Vec3 weight = mass_.mass * toolkit::vec(step.gravity());
  const auto after = drag.after(mass_.mass, R * toolkit::vec(mass_.inertia).asDiagonal() * R.transpose(), (1 - borne) * weight, step.dt());
  const auto F = drag.force(after);
  step.add_force(body_, toolkit::raw(Vec3(F.head<3>() - borne * weight)));
  step.add_torque(body_, toolkit::raw(Vec3(F.tail<3>())));
}

}  // namespace swage::solids
