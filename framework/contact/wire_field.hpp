// SPDX-License-Identifier: Apache-2.0
//
// Wires against a height field. Room-internal; README.md states the method.
#pragma once

#include "contact/narrow_phase.hpp"

namespace swage::contact {

/// Contacts of wire a (sphere, capsule, arc) with the height field b, added to `out`.
void collide_wire_field(const Solid& a, const Frame& X_WA, const Solid& b, const Frame& X_WB,
                        const Query& query, Manifold& out) noexcept;

}  // namespace swage::contact
