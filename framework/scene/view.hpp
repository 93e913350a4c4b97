// SPDX-License-Identifier: Apache-2.0
//
// One object's part of the world, as plugins see it: pointers into the world's arrays, valid while the scene
// lives.
#pragma once

#include "scene/world.hpp"

namespace swage::scene {

/// The contiguous ranges that one object owns. Index i of the object is `first + i` of the world.
struct Slices {
  Range body, particle, shape, hinge, state, signal;
};

/// The object's own index of a global one, or kNone when the object does not own it.
inline uint32_t local(const Range& range, uint32_t global) {
  return global - range.first < range.count ? global - range.first : kNone;
}

/// The view that goes to the object's callbacks; `input` and times are those of the current step. [rt]
swage_object_step view(World& world, const Slices& slices, const swage_input* input) noexcept;

}  // namespace swage::scene
