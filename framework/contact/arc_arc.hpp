// SPDX-License-Identifier: Apache-2.0
//
// Bent wire against bent wire. Room-internal; README.md states the method.
#pragma once

#include "contact/narrow_phase.hpp"

namespace swage::contact {

/// Contacts of two arcs, added to `out`: one at each local minimum of their distance.
void collide_arc_arc(const Solid& a, const Frame& X_WA, const Solid& b, const Frame& X_WB, const Query& query,
                     Manifold& out) noexcept;

}  // namespace swage::contact
