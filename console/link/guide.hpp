// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Live help: an expert plays the same lesson, with the same targets, on a thread of its own, and a ghost of the instruments follows the
// expert's path at the trainee's pace. The path grows during the attempt; the expert runs faster than real time, far ahead of any trainee.
#pragma once

#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>
#include <vector>

#include "console/link/player.hpp"
#include "console/models/ghost_path.hpp"
#include "session/session.hpp"

namespace swage::console {

/// Opens an expert for a lesson, to be stepped forward only; nullptr and problems where the lesson has none.
using ExpertOpener = std::function<std::unique_ptr<Player>(const session::Options& options, base::Problems& problems)>;

/// Positions of trainee and ghost, as path length along the expert's path, m.
struct GuidePosition {
  double progress_way_m = 0, shown_way_m = 0;
};

/// For the GUI thread. Owns the expert's thread.
class Guide {
 public:
  explicit Guide(std::unique_ptr<Player> expert);
  ~Guide();
  Guide(const Guide&) = delete;
  Guide& operator=(const Guide&) = delete;

  const snapshot::SceneCard& card() const { return card_; }
  /// Poses of the ghost for this state of the trainee, body by body as in card(); empty before the expert has begun, or when it has failed.
  const std::vector<swage_pose>& beside(const snapshot::Snapshot& trainee);
  GuidePosition position() const;
  /// True when the expert has finished. failed(): the expert did not pass, and no ghost is shown.
  bool done() const { return done_; }
  bool failed() const { return failed_; }

 private:
  struct Made {
    double time_s = 0;
    uint32_t phase = 0;
    std::vector<swage_pose> X_WB;
  };
  void run();

  const std::unique_ptr<Player> expert_;  // used by thread_ alone while it runs
  const snapshot::SceneCard card_;
  uint32_t bodies_ = 0;  // up to the last body of an instrument
  GhostPath path_;
  GhostPace pace_;
  std::vector<swage_pose> shown_;
  double last_s_ = 0;
  std::mutex lock_;
  std::vector<Made> made_;  // frames not yet taken; guarded by lock_
  std::atomic<bool> stop_{false}, done_{false}, failed_{false};
  std::thread thread_;
};

/// The points by which instruments are compared: their tips, and the centre of each of their bodies.
std::vector<BodyPlace> instrument_places(const snapshot::SceneCard& card);

}  // namespace swage::console
