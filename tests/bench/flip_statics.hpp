// SPDX-License-Identifier: Apache-2.0
//
// The friction that a needle needs whose plane stands at phi off flat between two jaws on one hinge, by statics.
//
// Across the wire, x away from the hinge, z up from the lower face: the upper face presses on the arc in its middle, at c0. The
// lower jaw bears it where its two edges cross the wire, at y = +-b/2, by symmetry alike. There the arc has fallen by the sagitta
// s = R - sqrt(R^2 - b^2/4) in its own plane, so that those places lie -s cos(phi) and -s sin(phi) from c0 along x and z. To first
// order N s cos(phi) rolls the wire flat against 2 mu N r: mu = s cos(phi) / 2r. Three things are not small beside it:
//
//   height   friction below acts r + s sin(phi) under c0, not r                         -2 % (10 deg) to -10 % (70 deg)
//   wedge    the faces stand at asin(r/D) + asin((r + s sin(phi))/D) and push the wire out; friction that holds it
//            is wanting for the couple, first at the upper face (coulomb.hpp)            +6 %          to +19 %
//   edges    at an edge e of the jaw, tapered by 1 : 8, the normal e x t is square to the wire's tangent t, not to the face: it
//            leans away from the hinge as well                                           +1 %          to +13 %
//
// For given N above, balance along x, along z and about the wire's direction y at c0 leaves three unknowns, the friction above, the
// force and the friction below: no stick is left over to share, so what each contact needs is determined. The needle rolls when
// the first of them needs more than mu.
#pragma once

#include "scene.hpp"

namespace swage::bench {

inline double flip_statics(const Needle& n, double off_flat) {
  const double D = Jaw::kGrip, R = n.radius(), r = n.wire_radius();
  const double taper = Jaw::kHalfWidth / Jaw::kLength, half = taper * (Jaw::kHinge + Jaw::kLength - D);
  const double s = R - std::sqrt(R * R - half * half), slope = std::asin(half / R);
  const double across = std::cos(off_flat), up = std::sin(off_flat);

  struct Touch {
    Vec3 p, n, t;  // place from c0, normal into the wire, direction of friction
  };
  const auto moment = [](const Vec3& p, const Vec3& f) { return p.z() * f.x() - p.x() * f.z(); };
  const auto in_face = [](const Vec3& normal) {
    return Vec3(Vec3::UnitX() - normal.x() * normal).normalized();
  };
  Touch above, below;  // of the two below, the one at +b/2; they differ by the sign of y
  const double wedge = std::asin(r / D) + std::asin((r + s * up) / D);
  above.n = {std::sin(wedge), 0, -std::cos(wedge)};
  below.n = Vec3(1, -taper, 0)
                .cross(Vec3(-std::sin(slope) * across, std::cos(slope), -std::sin(slope) * up))
                .normalized();
  above.p = -r * above.n;
  below.p = Vec3(-s * across, half, -s * up) - r * below.n;
  above.t = in_face(above.n), below.t = in_face(below.n);

  // [friction above, force below, friction below] for a force of 1 above
  toolkit::Mat3 A;
  A << above.t.x(), below.n.x(), below.t.x(),  //
      above.t.z(), below.n.z(), below.t.z(),   //
      moment(above.p, above.t), moment(below.p, below.n), moment(below.p, below.t);
  const Vec3 load(above.n.x(), above.n.z(), moment(above.p, above.n));
  const Vec3 f = A.inverse() * -load;
  return std::max(std::abs(f[0]), std::abs(f[2] / f[1]));
}

}  // namespace swage::bench
