// SPDX-License-Identifier: Apache-2.0
//
// Wires against a convex polyhedron, or against a capsule or a sphere, whose axis or centre counts as a polyhedron of one edge
// or one vertex. Room-internal; README.md states the method.
#pragma once

#include "contact/narrow_phase.hpp"

namespace swage::contact {

/// Contacts of wire a (sphere, capsule, arc) with solid b (polyhedron, capsule, sphere), added to `out`.
void collide_wire_convex(const Solid& a, const Frame& X_WA, const Solid& b, const Frame& X_WB,
                         const Query& query, Separation& memory, Manifold& out) noexcept;

}  // namespace swage::contact
