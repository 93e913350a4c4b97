// SPDX-License-Identifier: Apache-2.0
//
// The first touch of a wire and a convex solid. Room-internal; README.md states the method.
#pragma once

#include "contact/sweep.hpp"

namespace swage::contact {

/// As first_touch(), for a wire a (sphere, capsule, arc) and a solid b (polyhedron, capsule, sphere).
FirstTouch first_touch_wire(const Solid& a, const Motion& motion_a, const Solid& b, const Motion& motion_b,
                            double tolerance, Separation& memory) noexcept;

}  // namespace swage::contact
