// SPDX-License-Identifier: Apache-2.0
//
// The world as plugins see it, one object's part or all of it: pointers into the world's arrays, valid while the scene lives.
#pragma once

#include <span>

#include "scene/world.hpp"
#include "swage/abi/lesson.h"

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

/// The whole world, for lessons and for devices that receive it; `object` is the view of each object, `event` the events since
/// their last view. [rt]
swage_view view(const World& world, std::span<const swage_object_step> object,
                std::span<const swage_view_event> event) noexcept;

}  // namespace swage::scene
