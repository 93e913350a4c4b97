// SPDX-License-Identifier: Apache-2.0
//
// Where two solids touch: the contact points of one pair of shapes, in a fixed order, exact to rounding.
//
// Wires (sphere, capsule, arc) are a point, segment or arc thickened by a radius. Against a polyhedron the
// curve is cut where it passes from one Voronoi region to the next; inside a region the distance is one
// closed form. See README.md.
//
// Units: m. Frames: A and B the two bodies. Threads: any; nothing allocates or throws.
#pragma once

#include <array>
#include <cstdint>

#include "contact/candidate.hpp"
#include "contact/solid.hpp"

namespace swage::contact {

/// Parameters of a search for contacts.
struct Query {
  double margin = 0;     // m, report features with a gap below this
  double length = 1e-3;  // m, characteristic length of the scene
  /// A stretch of wire whose gap varies by less than flatness * length counts as lying on the face: it becomes a
  /// line contact of line_points points. 2 um for a 1 mm scene: the indentation of a needle in a firm grip (1 to
  /// 2 N). Zero: every contact is a point, and neither a wire nor a ball (cap.hpp) on a face has a friction
  /// moment.
  double flatness = 2e-3;
  int line_points = 4;  // even, 2..8
  /// The wire continues before its start as another solid, which reports a minimum at the joint.
  bool goes_on = false;
  bool goes_on_after = false;  // the same at its end, whose minimum this solid reports
  bool piece = false;  // the wire is one of the pieces of a chain
  bool piece_before = false, piece_after = false;  // the chain has another one before its start, after its end
};

/// The contact points of one pair of shapes. A needle against a jaw has 1 to 6.
struct Manifold {
  static constexpr int kCapacity = 24;
  std::array<Candidate, kCapacity> candidate;
  int count = 0;
  int dropped = 0;  // found beyond the capacity

  void clear() { count = dropped = 0; }
  /// Adds a candidate for a contact of this gap [m] and returns it, or null without room. Beyond the capacity the deepest stay.
  Candidate* add(double gap);
};

/// Memory between two calls for the same pair: a direction along which they were apart. It saves time and never changes the answer.
/// Part of the saved state.
struct Separation {
  Vec3 n_B = Vec3::Zero();  // unit, from b to a, in b; zero: none known
};

/// Contact points of a and b, found at the given poses of their bodies, into `out`, which is
/// cleared first. Returns their number.
int collide(const Solid& a, const Frame& X_WA, const Solid& b, const Frame& X_WB, const Query& query,
            Separation& memory, Manifold& out) noexcept;

}  // namespace swage::contact
