// SPDX-License-Identifier: Apache-2.0
//
// A setup as a scene of our own rooms. [main]
#pragma once

#include "engine.hpp"
#include "scene/world.hpp"

namespace swage::bench {

enum Body : uint32_t { kNeedle, kUpper, kLower, kBase, kBodies };
enum Object : uint32_t { kNeedleObject, kJawsObject };

/// Lengths per metre inside the world.
inline double unit_of(const Setup& s) { return s.unit > 0 ? s.unit : 1; }

/// Needle, jaws (the upper on a hinge when driven) or plate, at rest at their starts. Shape 0 is the needle's, 1 and 2 the
/// jaws'. Throws std::runtime_error for a jaw that is not convex.
scene::World make_world(const Setup& s);

}  // namespace swage::bench
