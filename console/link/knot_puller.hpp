// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A copy of the knot of a replayed attempt in the pull test, stepped for display; tests put doubles behind it. GUI thread only.
#pragma once

#include <QString>
#include <cstdint>
#include <string>

#include "snapshot/scene_card.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::console {

struct PullWish {
  double load_N = 0.1;
  double friction = 0;  // of the thread on itself; 0: as in the attempt
};

/// The copied knot.
struct PulledKnot {
  QString word;         // its throws with their signs: "2 -1 1"
  double loop_m = 0;    // thread in the loop
  double friction = 0;  // as it is pulled
};

/// The pull so far.
struct PullState {
  bool over = false, holds = false, broke = false;
  double bears_N = 0, slip_m = 0;
  QString health;  // what the solver could not do; "" in a sound scene
};

class KnotPuller {
 public:
  virtual ~KnotPuller() = default;
  virtual const snapshot::SceneCard& card() const = 0;
  virtual PulledKnot knot() const = 0;
  /// By so many steps at most; false when it is over.
  virtual bool step(uint64_t most) = 0;
  virtual PullState state() const = 0;
  virtual void fill(snapshot::Snapshot& out) const = 0;
};

}  // namespace swage::console
