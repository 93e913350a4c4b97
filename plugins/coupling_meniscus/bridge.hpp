// SPDX-License-Identifier: Apache-2.0
//
// Adhesion of a thin thread to a wet surface. A thread that lies in the film has lost the surface energy of its dry surface: per
// length (Young and Dupre; de Gennes et al., Capillarity and Wetting Phenomena, 2004, ch. 2 and 9)
//
//   w = 2 pi r gamma cos(theta)   [J/m = N]
//
// so that w is also the pull of the film on a thread that leaves it (Wilhelmy), 4.98 uN for 10-0 in water, and the energy per length to
// peel it off, F (1 - cos(angle)) = w (Rivlin 1944). A bridge represents a length l of the thread and pulls it to the surface until it is
// lifted by the thickness H of the film, where the film breaks:
//
//   f = min(k g, F),  k = F / e,  F = w l / (H - e/2),  e = kRamp H       the work up to g = H is w l
//
// Header-only, pure, [rt].
#pragma once

#include <cmath>
#include <numbers>

namespace swage::coupling_meniscus {

/// Share of the film thickness over which the pull rises: a spring there, which the solve treats implicitly. Much smaller gives a stiff
/// spring, much larger a soft support of the thread.
inline constexpr double kRamp = 0.25;

/// Returns w [N] of a film of surface tension gamma [N/m] and contact angle [rad] on a thread of radius r [m].
inline double work_of_adhesion(double r, double gamma, double angle) {
  return 2 * std::numbers::pi * r * gamma * std::cos(angle);
}

/// m, sqrt(B / w): the length at which bending of the stiffness B [N m2] costs the energy of adhesion. Peeled off, the thread has the
/// radius of curvature sqrt(B / (2 w)) where it leaves the surface.
inline double elastocapillary_length(double B, double w) { return std::sqrt(B / w); }

struct Bridge {
  double pull = 0;       // N, maximum
  double stiffness = 0;  // N/m, of the ramp
};

/// The bridge of a length l [m] of thread in a film of thickness H [m], w [N] its work of adhesion per length.
inline Bridge bridge(double w, double l, double H) {
  const double pull = w * l / (H * (1 - 0.5 * kRamp));
  return {pull, pull / (kRamp * H)};
}

}  // namespace swage::coupling_meniscus
