// SPDX-License-Identifier: Apache-2.0
//
// The loads that a pinched wire bears, by statics and Coulomb's law, for jaws that stand at an angle:
// two jaws that turn on one hinge and hold a wire of radius r at the distance D meet it at +-alpha, sin(alpha) = r / D.
//
// In the plane across the wire, x away from the hinge, the upper and lower faces press with N_u, N_l and rub with f_u, f_l
// along themselves, outwards positive. A face runs through the hinge's axis, so that its friction has no moment about it
// and the drive alone sets N_u = N. Forces on the wire along x and across, and the moment M about its axis:
//
//   (N_u + N_l) sin(alpha) + (f_u + f_l) cos(alpha) = 0      the wedge pushes outwards, friction holds
//   (N_l - N_u) cos(alpha) + (f_u - f_l) sin(alpha) = 0
//   M = r (f_l - f_u)
//
// With F = M / 2r: f_u = -F - n tan(alpha), f_l = F - n tan(alpha), N_u = n - F tan(alpha), N_l = n + F tan(alpha), n the mean.
// The upper contact carries more on less and slips first, |f_u| = mu N_u; with N_u = N that is
//
//   M = 2 r N (mu - tan(alpha)) cos^2(alpha)                  which is 2 mu N r between parallel faces
//
// (for the other sense of M the lower one slips first, at n tan(atan(mu) - alpha): less by 2 mu alpha). Along the wire friction
// has what the wedge leaves: each face holds n tan(alpha) outwards and mu n in all,
//
//   P = 2 N mu sqrt(1 - (tan(alpha) / mu)^2)
//
// About the jaws' normal the wire turns about a place y0 beside its middle, so that friction, mu n / b per length towards x
// on one side of y0 and against it on the other, still holds n tan(alpha): y0 = (b / 2) tan(alpha) / mu, and
//
//   M = 2 (mu n / b) ((b / 2)^2 - y0^2) = (mu n b / 2) (1 - (tan(alpha) / mu)^2)
//
// With r the wire's own radius: at 1 N the contacts overlap by 1 um and act half of that deep, so the arm is 1 % shorter and a
// solver that is exact about the wire reaches 0.99 of this.
#pragma once

#include <cmath>

namespace swage::bench {

/// What a wire of radius r [m] pinched with N [N] over the width b [m] bears between faces at +-alpha [rad].
struct CoulombLimits {
  double mu, N, alpha;

  double along() const {  // N
    const double t = std::tan(alpha) / mu;
    return 2 * mu * N * std::sqrt(1 - t * t);
  }
  double about_wire(double r) const {  // N m
    const double c = std::cos(alpha);
    return 2 * r * N * (mu - std::tan(alpha)) * c * c;
  }
  double about_normal(double b) const {  // N m
    const double t = std::tan(alpha) / mu;
    return 0.5 * mu * N * b * (1 - t * t);
  }
};

}  // namespace swage::bench
