// SPDX-License-Identifier: LGPL-3.0-or-later
//
// From a thousand steps a second to a steady picture: takes the newest snapshot at display rate and
// interpolates.
#pragma once

#include <memory>

#include "snapshot/snapshot.hpp"

namespace swage::console {

/// Poses a fraction `a` of the way from `from` to `to`; everything else as in `to`.
void interpolate(const snapshot::Snapshot& from, const snapshot::Snapshot& to, double a,
                 snapshot::Snapshot& out);

/// Shows the scene a little behind the newest snapshot, as long as snapshots take to arrive: 2 ms at 1 kHz,
/// so that a late snapshot makes no jerk. GUI thread only.
class SnapshotSource {
 public:
  SnapshotSource();
  void clear();
  /// A snapshot was read at `wall_s`; one that was seen before is ignored.
  void push(const snapshot::Snapshot& newest, double wall_s);
  /// What to show at `wall_s`; nullptr before the first.
  const snapshot::Snapshot* sample(double wall_s);
  const snapshot::Snapshot* newest() const { return have_ > 0 ? to_.get() : nullptr; }
  double delay_s() const { return delay_s_; }

 private:
  std::unique_ptr<snapshot::Snapshot> from_, to_, shown_;
  int have_ = 0;  // 0, 1 or 2 snapshots
  double to_wall_s_ = 0, last_poll_s_ = 0;
  double delay_s_ = 0;  // behind the newest, simulated
};

}  // namespace swage::console
