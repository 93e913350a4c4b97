// SPDX-License-Identifier: Apache-2.0
//
// Polyhedron against polyhedron: a jaw against the tray, the pad, the other jaw. Room-internal; README.md states the method.
#pragma once

#include "contact/narrow_phase.hpp"

namespace swage::contact {

/// Contacts of two polyhedra, added to `out`.
void collide_convex_convex(const Solid& a, const Frame& X_WA, const Solid& b, const Frame& X_WB,
                           const Query& query, Separation& memory, Manifold& out) noexcept;

}  // namespace swage::contact
