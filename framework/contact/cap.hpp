// SPDX-License-Identifier: Apache-2.0
//
// A ball pressed into a face touches it on a disc, not in a point, and therefore resists twist about the normal: without
// that a ball between two jaws that are not quite parallel rolls out sideways. Room-internal.
#pragma once

#include <cmath>
#include <numbers>

#include "contact/narrow_phase.hpp"

namespace swage::contact {

/// Hertz: two bodies of which one is flat overlap by `depth` on a disc of radius a = sqrt(R depth). Slipping all over it,
/// the pressure 3 N / (2 pi a^2) sqrt(1 - r^2 / a^2) has the moment 3 pi / 16 mu N a about the normal, as if the whole force
/// acted on a ring of this radius [m].
inline double cap_ring(double radius, double depth) {
  return depth > 0 ? 3 * std::numbers::pi / 16 * std::sqrt(radius * depth) : 0.0;
}

/// Turns each contact of ball `a` with a face of `b` into three points of a third of its weight on that ring. Each keeps the gap of
/// the middle. Their directions in the face are fixed, so that friction memory carries over.
inline void spread_caps(const Solid& a, const Frame& X_BA, const Frame& X_WB, Manifold& out) {
  const int n = out.count;
  for (int i = 0; i < n; ++i) {
    const Candidate middle = out.candidate[static_cast<size_t>(i)];
    if (middle.b.kind != Feature::kPlane || middle.a.kind != Feature::kPoint) continue;
    const double ring = cap_ring(a.radius, -middle.touch.gap);

    // two directions in the face; the face's normal does not move in b, so neither do they
    const Vec3& normal = middle.n_B;
    const Vec3 across = std::abs(normal.x()) < 0.6 ? Vec3::UnitX() : Vec3::UnitY();
    const Vec3 t1 = normal.cross(across).normalized(), t2 = normal.cross(t1);
    const double s = 0.5 * std::numbers::sqrt3;
    const Vec3 place_B[3] = {ring * t1, ring * (-0.5 * t1 + s * t2), ring * (-0.5 * t1 - s * t2)};
    for (int k = 0; k < 3; ++k) {
      Candidate* c = k == 0 ? &out.candidate[static_cast<size_t>(i)] : out.add(HUGE_VAL);
      if (!c) break;
      *c = middle;
      c->a.p += X_BA.turn_back(place_B[k]);
      c->touch.p_W += X_WB.turn(place_B[k]);
      c->feature += static_cast<uint64_t>(k);
      c->weight = middle.weight / 3;
    }
  }
}

}  // namespace swage::contact
