// SPDX-License-Identifier: Apache-2.0
//
// The way out of the step: the newest whole snapshot for many readers. The step never waits for any of them.
#pragma once

#include <cstddef>

#include "base/snapshot_ring.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::snapshot {

class Channel {
 public:
  /// What the scene has no particles for is not copied. [rt] wait-free, about 1 us for a scene without
  /// particles
  void publish(const Snapshot& s) noexcept {
    ring_.publish(s, offsetof(Snapshot, particle_p_W) + 3 * sizeof(double) * s.n_particle);
  }

  /// Newest whole snapshot; false before the first. [any]
  bool latest(Snapshot& out) const noexcept { return ring_.latest(out) != 0; }

  /// Number of snapshots so far, to see cheaply whether there is a new one. [any]
  uint64_t published() const noexcept { return ring_.published(); }

 private:
  base::SnapshotRing<Snapshot> ring_;
};

}  // namespace swage::snapshot
