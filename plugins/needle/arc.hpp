// SPDX-License-Identifier: Apache-2.0
//
// The needle as a piece of a torus: a round wire of constant thickness, bent to a circular arc. Closed forms
// only.
//
// Circle frame A: origin at the circle's centre, z its normal, x towards the middle of the wire, y towards
// the swage. The wire runs from angle -sweep/2 (the point, s = 0) to +sweep/2 (the swage, s = 1).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "toolkit/math.hpp"

namespace swage::needle {

using toolkit::Vec3;

/// Geometry to which a needle is made.
struct Arc {
  double radius = 2.706e-3;      // m, of the centre line
  double sweep = 2.3561944902;   // rad
  double wire_radius = 0.05e-3;  // m, below `radius`

  double length() const { return radius * sweep; }                       // m, of the centre line
  double chord() const { return 2 * radius * std::sin(0.5 * sweep); }    // m, point to swage
  double angle(double s) const { return (s - 0.5) * sweep; }             // rad, in A
  double coordinate(double angle) const { return 0.5 + angle / sweep; }  // inverse of angle()
};

inline Arc arc_of_length(double sweep, double length, double wire_radius) {
  return {length / sweep, sweep, wire_radius};
}
inline Arc arc_of_chord(double sweep, double chord, double wire_radius) {
  return {0.5 * chord / std::sin(0.5 * sweep), sweep, wire_radius};
}

/// Mass, position of the centre of mass in the plane of A, and inertia about it in the axes of A. Without a thickness that changes
/// along the wire, the axes of A are principal and the centre of mass is on x.
struct ArcMass {
  double mass = 0;              // kg
  double centre = 0;            // m, on x
  double along = 0;             // m, on y
  Vec3 inertia = Vec3::Zero();  // kg m2, diagonal
  double product = 0;           // kg m2, integral of x y dm about the centre

  /// Angle of the principal axes about z [rad], in (-pi/4, pi/4).
  double principal() const {
    return product == 0 ? 0.0 : 0.5 * std::atan(2 * product / (inertia.y() - inertia.x()));
  }
  /// Moments about the principal axes.
  Vec3 principal_inertia() const {
    const double mean = 0.5 * (inertia.x() + inertia.y()), half = 0.5 * (inertia.x() - inertia.y());
    const double reach = product == 0 ? half : std::copysign(std::hypot(half, product), half);
    return product == 0 ? inertia : Vec3(mean + reach, mean - reach, inertia.z());
  }
};

/// Integrals over the bent round section, without its rounded ends. With the distance from the circle's axis
/// rho = R + r' cos(psi) and the volume element rho d(angle) dA:
///   V = pi r^2 R sweep,  <rho> = R + r^2/(4R),  <rho^2> = R^2 + 3 r^2/4,  <z^2> = r^2/4
/// where < > is the mean over the volume across the wire. The ends that `shape` rounds off would add a share
/// of 4 r / (3 R sweep) of the mass, about 1 % for a 0.1 mm wire of 6 mm; a real point is ground thinner by
/// about as much.
inline ArcMass mass_of(const Arc& arc, double density) {
  const double R = arc.radius, r2 = arc.wire_radius * arc.wire_radius, half = 0.5 * arc.sweep;
  const double mean_rho = R + r2 / (4 * R);
  const double mean_rho2 = R * R + 0.75 * r2;
  const double mean_z2 = 0.25 * r2;
  // means of cos and cos^2 over the sweep
  const double c1 = std::sin(half) / half;
  const double c2 = 0.5 * (1 + std::sin(arc.sweep) / arc.sweep);

  ArcMass m;
  m.mass = density * std::numbers::pi * r2 * R * arc.sweep;
  m.centre = mean_rho * c1;
  const double x2 = mean_rho2 * c2 - m.centre * m.centre;
  const double y2 = mean_rho2 * (1 - c2);
  m.inertia = m.mass * Vec3(y2 + mean_z2, x2 + mean_z2, x2 + y2);
  return m;
}

/// Nearest place on the centre line, in A.
struct ArcPlace {
  double s = 0;                  // 0 at the point .. 1 at the swage
  Vec3 p = Vec3::Zero();         // m
  Vec3 tangent = Vec3::UnitY();  // unit, towards the swage
};

inline ArcPlace place_at(const Arc& arc, double s) {
  const double a = arc.angle(s);
  const Vec3 radial(std::cos(a), std::sin(a), 0);
  return {s, arc.radius * radial, Vec3(-radial.y(), radial.x(), 0)};
}

/// On the circle's axis all places are equally near; the result is then the middle of the wire.
inline ArcPlace nearest_place(const Arc& arc, const Vec3& p_A) {
  const double half = 0.5 * arc.sweep, angle = std::atan2(p_A.y(), p_A.x());
  const double far = std::sqrt(p_A.x() * p_A.x() + p_A.y() * p_A.y());
  if (!(far > 0) || std::abs(angle) > half)
    return place_at(arc, arc.coordinate(std::clamp(angle, -half, half)));
  const double c = p_A.x() / far, s = p_A.y() / far;
  return {arc.coordinate(angle), arc.radius * Vec3(c, s, 0), Vec3(-s, c, 0)};
}

}  // namespace swage::needle
