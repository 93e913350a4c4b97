// SPDX-License-Identifier: Apache-2.0
#include "needle.hpp"

#include <swage/plugin.hpp>

namespace swage::needle {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kShare[] = {1.0 / 4, 3.0 / 8, 1.0 / 2, 5.0 / 8, 2.0 / 8, 4.0 / 8};

// The smallest radius of the circle in wire radii: below it the inside of the bend would fold into itself
// long before.
constexpr double kTightest = 4;

}  // namespace

void Needle::build(const NeedleParams& params, ObjectBuilder& builder) {
  const double sweep = kTurn * kShare[static_cast<int>(params.arc)];
  const double wire_radius = 0.5 * params.wire_diameter;
  arc_ = params.size_of == SizeOf::kChord ? arc_of_chord(sweep, params.size, wire_radius)
                                          : arc_of_length(sweep, params.size, wire_radius);
  if (arc_.radius < kTightest * wire_radius) {
    builder.error(
        "size", "the needle is too short for so thick a wire: the bend needs a radius of two wire diameters");
    return;
  }

  // B: centre of mass, x away from the circle's centre, z normal to its plane. O: the same axes, in the
  // middle of the wire
  const ArcMass m = mass_of(arc_, params.density);
  centre_B_ = Vec3(-m.centre, 0, 0);
  body_ = builder.dynamic_body("needle", {m.mass, toolkit::raw(m.inertia)}, at(m.centre - arc_.radius, 0, 0));

  // the shape's arc starts on its own +x axis, which therefore points at the needle's point
  const toolkit::Pose X_BA(centre_B_, toolkit::exp_rotation({0, 0, -0.5 * sweep}));
  builder.arc(body_, {X_BA.abi(), arc_.radius, sweep, wire_radius});
}

void Needle::locate(const Step& step, swage_vec3 p_W, swage_graspable_place& out) {
  const toolkit::Pose X_WB(step.pose(body_));
  const Vec3 p_A = X_WB.inverse() * toolkit::vec(p_W) - centre_B_;
  const ArcPlace place = nearest_place(arc_, p_A);
  out.s = place.s;
  out.length = arc_.length();
  out.p_W = toolkit::raw(X_WB * (place.p + centre_B_));
  out.tangent_W = toolkit::raw(X_WB.q * place.tangent);
  out.normal_W = toolkit::raw(X_WB.q * Vec3::UnitZ());
}

}  // namespace swage::needle

SWAGE_EXPORT(swage::needle::Needle)
