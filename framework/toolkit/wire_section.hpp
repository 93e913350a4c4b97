// SPDX-License-Identifier: Apache-2.0
//
// Stiffness and strength of a wire of round or flattened section in bending and torsion, in closed form, and the moment-curvature law of
// an elastic, perfectly plastic round section. Header-only, pure functions.
#pragma once

#include <cmath>
#include <numbers>

namespace swage::toolkit {

/// What a wire is made of.
struct WireMaterial {
  double youngs = 195e9;      // Pa
  double poisson = 0.29;      // 1
  double yield = 2.0e9;       // Pa, in tension
  double hardening = 0.01;    // slope beyond yield as a share of Young's modulus, 0..1
  double break_strain = 0.6;  // plastic strain that the outer fibre bears, accumulated over all load cycles
  double density = 7900;      // kg/m3
};

/// Stiffness and strength of one place along a wire. Axes: 0 out of the plane of the needle (turning about the radius),
/// 1 torsion (about the tangent), 2 in the plane (about the normal).
struct WireSection {
  double stiffness[3] = {};  // N m2: EI, GJ, EI
  double yield[3] = {};      // N m: the moment at which the outer fibre yields
  double area = 0;           // m2

  double yield_curvature(int axis) const { return yield[axis] / stiffness[axis]; }  // 1/m
};

/// M_y = pi d^3 sigma / 32 [N m].
inline double yield_moment(double diameter, double yield_stress) {
  return std::numbers::pi * diameter * diameter * diameter * yield_stress / 32;
}
/// M_p = d^3 sigma / 6 [N m]: the whole section yields.
inline double plastic_moment(double diameter, double yield_stress) {
  return diameter * diameter * diameter * yield_stress / 6;
}
/// EI = E pi d^4 / 64 [N m2].
inline double bending_stiffness(double diameter, double youngs) {
  const double d2 = diameter * diameter;
  return youngs * std::numbers::pi * d2 * d2 / 64;
}

/// Section of a wire of `diameter` [m], pressed to an ellipse of equal area whose thickness in the plane of the needle is
/// `flattening` times its width (1: round), with a hole along it of `hole` diameters (0: solid; the swage is drilled).
/// Ellipse with half axes a across, b in the plane: I = pi a b^3/4 and pi a^3 b/4, J = pi a^3 b^3/(a^2 + b^2), first yield at
/// I/b and I/a times sigma; torsion yields by von Mises at sigma/sqrt(3), at the end of the short axis: pi a b^2 tau/2.
inline WireSection wire_section(double diameter, double flattening, double hole, const WireMaterial& m) {
  const double r = 0.5 * diameter, root = std::sqrt(flattening);
  const double a = r / root, b = r * root, pi = std::numbers::pi;
  const double left = 1 - hole * hole * hole * hole;  // share of the stiffness that a tube has
  const double in_plane = 0.25 * pi * a * b * b * b, across = 0.25 * pi * a * a * a * b;
  const double torsion = pi * a * a * a * b * b * b / (a * a + b * b);
  WireSection s;
  s.stiffness[0] = left * m.youngs * across;
  s.stiffness[1] = left * m.youngs / (2 * (1 + m.poisson)) * torsion;
  s.stiffness[2] = left * m.youngs * in_plane;
  s.yield[0] = left * m.yield * across / a;
  s.yield[1] = left * m.yield / std::sqrt(3.0) * 0.5 * pi * a * b * b;
  s.yield[2] = left * m.yield * in_plane / b;
  s.area = pi * r * r * (1 - hole * hole);
  return s;
}

/// M/M_y of a round section bent to c times its yield curvature, without hardening (peers: Roark, Formulas for Stress and
/// Strain, plastic bending of a solid circle). With s = 1/c, the height of the elastic core over the radius:
///   M/M_y = (4/pi) ( (asin s - s sqrt(1-s^2) (1-2 s^2)) / (2 s) + (4/3) (1-s^2)^(3/2) ),   1 for c = 1, 16/(3 pi) for c -> inf
inline double round_moment(double c) {
  const double size = std::abs(c);
  if (size <= 1) return c;
  const double s = 1 / size, q = std::sqrt(1 - s * s);
  const double core = (std::asin(s) - s * q * (1 - 2 * s * s)) / (2 * s);
  return std::copysign(4 / std::numbers::pi * (core + 4.0 / 3.0 * q * q * q), c);
}
/// The same with linear hardening of the fibres: they then carry the share `hardening` as if elastic.
inline double round_moment(double c, double hardening) {
  return (1 - hardening) * round_moment(c) + hardening * c;
}

}  // namespace swage::toolkit
