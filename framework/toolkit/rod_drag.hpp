// SPDX-License-Identifier: Apache-2.0
//
// Drag of a fluid on a thin thread that moves across its axis: force per length over speed. Header-only, pure.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace swage::toolkit {

struct RodFluid {
  double density = 0;    // kg/m3; water 998, air 1.2
  double viscosity = 0;  // Pa s; water 1.0e-3, air 1.8e-5; 0: no fluid
  double carried = 0;    // kg/m3, density of the fluid that counts as added mass across the axis; 0: none
};

/// Greatest Reynolds number of which a drag is computed: a viscosity that is rounded to nothing would make it infinite. Far above any of a
/// scene: 250 at 10 m/s for 0.4 mm in air, 4e3 in water.
inline constexpr double kMostReynolds = 1e9;

/// Drag of a cylinder across its axis, per length and speed [N s/m2]. Lamb 1911 up to Re = 0.7, where it meets White's fit of
/// measurements (Viscous Fluid Flow, C_D = 1 + 10 Re^-2/3) raised by 11 %; Lamb's own law is infinite at Re = 7.4. Along the axis
/// a slender body has half of it.
inline double rod_drag(const RodFluid& fluid, double diameter, double speed) {
  if (!(fluid.viscosity > 0)) return 0;
  constexpr double kJoined = 0.7;
  // at rest the law has no limit but zero: below Re = 1e-6 it is that of 1e-6, 0.8 um/s in water for 25 um
  const double Re = std::min(std::max(fluid.density * speed * diameter / fluid.viscosity, 1e-6), kMostReynolds);
  if (Re <= kJoined) return 4 * std::numbers::pi * fluid.viscosity / (0.5 - 0.5772156649 - std::log(Re / 8));
  const double third = std::cbrt(Re);
  return 0.5 * fluid.viscosity * Re * 1.11 * (1 + 10 / (third * third));
}

}  // namespace swage::toolkit
