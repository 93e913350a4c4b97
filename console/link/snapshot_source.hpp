// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Turns a thousand steps per second into a steady picture: takes the newest snapshot at display rate and
// interpolates.
#pragma once

#include <memory>

#include "snapshot/snapshot.hpp"

namespace swage::console {

/// Poses at the fraction `a` between `from` and `to`; all other data from `to`.
void interpolate(const snapshot::Snapshot& from, const snapshot::Snapshot& to, double a,
                 snapshot::Snapshot& out);

/// Shows the scene delayed by the usual interval between snapshots, 2 ms at 1 kHz,
/// so that a late snapshot causes no jerk. GUI thread only.
class SnapshotSource {
 public:
  SnapshotSource();
  void clear();
  /// Adds a snapshot read at `wall_s`; one with the step of the last is ignored.
  void push(const snapshot::Snapshot& newest, double wall_s);
  /// The snapshot to show at `wall_s`; nullptr before the first.
  const snapshot::Snapshot* sample(double wall_s);
  const snapshot::Snapshot* newest() const { return have_ > 0 ? to_.get() : nullptr; }
  double delay_s() const { return delay_s_; }

 private:
  std::unique_ptr<snapshot::Snapshot> from_, to_, shown_;
  int have_ = 0;  // 0, 1 or 2 snapshots
  double to_wall_s_ = 0, last_poll_s_ = 0;
  double delay_s_ = 0;  // behind the newest snapshot, in simulated time
};

}  // namespace swage::console
