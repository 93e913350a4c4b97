// SPDX-License-Identifier: Apache-2.0
//
// A finite element: a brick of eight corners without locking in bending or at constant volume.
//
// Hybrid stress element of Pian and Tong (Int. J. Numer. Meth. Engng. 22, 1986, 173): displacements trilinear, stresses
//   sxx: 1 y z yz   syy: 1 x z xz   szz: 1 x y xy   sxy: 1 z   syz: 1 x   szx: 1 y
// in equilibrium within the brick. Rectangular bricks bend exactly; of the pressure modes only the constant one resists a
// change of volume.
#pragma once

#include <array>

namespace swage::tissue {

/// Poisson's ratio of nearly incompressible tissue. A half space of the same shear modulus is displaced by 0.2 % more than
/// at 1/2; nearer to 1/2 digits are lost.
inline constexpr double kPoisson = 0.499;

/// Stiffness [N/m]. Corner c is at x = c & 1, y = c >> 1 & 1, z = c >> 2; unknown 3 c + component.
using BrickStiffness = std::array<std::array<double, 24>, 24>;

/// Brick of edges [m] and Young's modulus [Pa]. [main]
BrickStiffness brick(const std::array<double, 3>& edge, double young, double poisson = kPoisson);

}  // namespace swage::tissue
