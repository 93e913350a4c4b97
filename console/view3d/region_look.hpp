// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Sizes of the mark of a region on a wire: a sleeve over its length, a collar at either end.
#pragma once

namespace swage::console {

// factors on a wire's radius: large enough that the surfaces do not flicker through each other
constexpr double kSleeve = 1.06, kCollarGrow = 1.12;
// factors on a thread's radius, larger because a thread is about one pixel wide
constexpr double kThreadSleeve = 1.6, kThreadCollarGrow = 2.4;

}  // namespace swage::console
