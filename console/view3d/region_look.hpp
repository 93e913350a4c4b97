// SPDX-License-Identifier: LGPL-3.0-or-later
//
// How a marked region is drawn on what it marks: a sleeve over its length, a collar at either end.
#pragma once

namespace swage::console {

// times the radius of a wire: enough that neither flickers through the other
constexpr double kSleeve = 1.06, kCollarGrow = 1.12;
// times the radius of a thread, which is so thin that a share of it is no pixel
constexpr double kThreadSleeve = 1.6, kThreadCollarGrow = 2.4;

}  // namespace swage::console
