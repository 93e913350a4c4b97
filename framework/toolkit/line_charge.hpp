// SPDX-License-Identifier: Apache-2.0
//
// Electrostatics of a thread that is charged evenly along its length: the field of straight pieces, from Coulomb's law integrated
// along each of them (Jackson, Classical Electrodynamics, 1.5). With q the charge per length, r1 and r2 the vectors from the ends of
// a piece to a point, u its direction and rho the part of r1 across it:
//
//   E = q / (4 pi e0) [ (1/|r2| - 1/|r1|) u + (u.r1/|r1| - u.r2/|r2|) rho / rho^2 ]
//
// Two long parallel threads at a distance d repel each other by q^2 / (2 pi e0 d) per length. An earthed metal plane at the distance h
// attracts like a thread of the opposite charge at 2 h, its mirror image: q^2 / (4 pi e0 h).
// Units SI. Header-only, pure, [rt].
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "toolkit/math.hpp"

namespace swage::toolkit {

inline constexpr double kVacuumPermittivity = 8.8541878128e-12;  // F/m (CODATA 2018)

/// Field [V/m] at p of the piece from a to b with q [C/m]. It stops growing within `least` [m] of the piece's line, the thread's thickness.
inline Vec3 charged_piece_field(const Vec3& a, const Vec3& b, double q, const Vec3& p, double least) {
  const Vec3 u = (b - a).normalized(), r1 = p - a, r2 = p - b, rho = r1 - r1.dot(u) * u;
  const double across2 = std::max(rho.squaredNorm(), least * least);
  const auto norm = [&](const Vec3& r) { return std::sqrt(std::max(r.squaredNorm(), least * least)); };
  const double d1 = norm(r1), d2 = norm(r2);
  return q / (4 * std::numbers::pi * kVacuumPermittivity) *
         ((1 / d2 - 1 / d1) * u + (u.dot(r1) / d1 - u.dot(r2) / d2) / across2 * rho);
}

}  // namespace swage::toolkit
