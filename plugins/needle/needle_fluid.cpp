// SPDX-License-Identifier: Apache-2.0
//
// The needle in the fluid of the lesson's environment: drag along its arc, and buoyancy. Without a medium there is neither.
#include <algorithm>

#include "needle.hpp"
#include "toolkit/fluid_drag.hpp"

namespace swage::needle {

namespace {
// Straight pieces into which the arc is cut: a half circle has pieces of 15 deg, whose drag differs by 0.3 % from that of twice as many.
constexpr int kCuts = 12;
}  // namespace

/// Drag at the velocity after the step (implicit), as for one rigid body; each piece of a bending needle then bears its own part.
void Needle::forces(const Step& step) {
  if (environment_.medium == SWAGE_MEDIUM_UNSET) return;
  const toolkit::RodFluid fluid{environment_.density, environment_.viscosity};
  const toolkit::Pose X_WB(step.pose(body_));
  const toolkit::RigidMotion V{toolkit::vec(step.twist(body_).v), toolkit::vec(step.twist(body_).w)};
  const int n = std::max(1, bending_.pieces()), cuts = std::max(1, kCuts / n);
  const auto add = [&](int piece, toolkit::FluidDrag& drag) {
    const Stretch& wire = stretch(step, piece);
    for (int k = 0; k < cuts; ++k) {
      const ArcPlace at = place_at(wire.arc, (k + 0.5) / cuts);
      drag.add_piece(wire.X_WA * at.p - X_WB.p, wire.X_WA.turn(at.tangent), wire.arc.length() / cuts, 2 * arc_.wire_radius);
    }
  };
  toolkit::FluidDrag whole(fluid, V);
  for (int i = 0; i < n; ++i) add(i, whole);

  const toolkit::Mat3 R = X_WB.q.toRotationMatrix(), inertia = R * inertia_.asDiagonal() * R.transpose();
  const double borne = environment_.density / form_.material.density;
  const Vec3 weight = mass_ * toolkit::vec(step.gravity());
  const toolkit::RigidMotion after = whole.after(mass_, inertia, (1 - borne) * weight, step.dt());
  step.add_force(body_, toolkit::raw(Vec3(-borne * weight)));
  for (int i = 0; i < n; ++i) {
    toolkit::FluidDrag own(fluid, V);
    add(i, own);
    const auto F = own.force(after);
    const Body body = bends() ? Body{bending_.body_of(i)} : body_;
    const Vec3 f = F.head<3>(), arm = toolkit::vec(step.pose(body).p) - X_WB.p;
    step.add_force(body, toolkit::raw(f));
    step.add_torque(body, toolkit::raw(Vec3(F.tail<3>() - arm.cross(f))));
  }
}

}  // namespace swage::needle
