// SPDX-License-Identifier: Apache-2.0
//
// Capacities of a step: one table per scene, chosen on [main] from what the objects of the scene declare,
// and published to plugins (SWAGE_HOST_CAPACITIES). What does not fit is counted (base/solver_health.hpp).
#pragma once

#include <algorithm>
#include <cstdint>

namespace swage::scene {

struct Capacities {
  uint32_t contacts = 256;  // found in a step; a needle in two jaws has 10 to 40
  uint32_t ties = 64;       // links of couplings in a step; a pierced needle has 5 to 20
  uint32_t points = 96;     // contact points of one flexible body; a held needle has 10 to 30, a thread in a knot 60 to 100
  uint32_t rows = 128;      // contacts and ties of one island with flexible bodies: its matrix has (3 rows)^2 numbers

  friend bool operator==(const Capacities&, const Capacities&) = default;
};

/// The most that a scene can ask for: matrices of 19 MB each (3 * 512 squared).
inline constexpr Capacities kLargest{1024, 64, 256, 512};

/// Makes room for one more flexible body that may touch at `points` points at once. Each point may be a contact of two flexible
/// bodies, and both may be in one island.
inline void make_room(Capacities& room, uint32_t points) {
  points = std::min(points, kLargest.points);
  if (points <= Capacities{}.points) return;
  room.points = std::max(room.points, points);
  room.rows = std::max(room.rows, std::min(kLargest.rows, 2 * points));
  room.contacts = std::min(kLargest.contacts, room.contacts + 2 * points);
}

}  // namespace swage::scene
