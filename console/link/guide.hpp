// SPDX-License-Identifier: LGPL-3.0-or-later
//
// Live help: an expert plays the same lesson, with the same targets, on a thread of its own, and a ghost of the instruments goes that
// way at the trainee's pace. The way grows while the attempt runs; an expert without a clock is far ahead of any trainee.
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

/// An expert at a lesson, to be wound forward only; nullptr and problems where the lesson has none.
using ExpertOpener = std::function<std::unique_ptr<Player>(const session::Options& options, base::Problems& problems)>;

/// How far trainee and ghost are, m of the expert's way.
struct GuidePosition {
  double progress_way_m = 0, shown_way_m = 0;
};

/// GUI thread, but for the thread that it has.
class Guide {
 public:
  explicit Guide(std::unique_ptr<Player> expert);
  ~Guide();
  Guide(const Guide&) = delete;
  Guide& operator=(const Guide&) = delete;

  const snapshot::SceneCard& card() const { return card_; }
  /// Poses of the ghost beside this trainee, body by body as in card(); none before the expert has begun, or when it has failed.
  const std::vector<swage_pose>& beside(const snapshot::Snapshot& trainee);
  GuidePosition position() const;
  /// The expert has come to its end. Where it did not pass nobody should go its way.
  bool done() const { return done_; }
  bool failed() const { return failed_; }

 private:
  struct Made {
    double time_s = 0;
    uint32_t phase = 0;
    std::vector<swage_pose> X_WB;
  };
  void run();

  const std::unique_ptr<Player> expert_;  // of the thread, while it runs
  const snapshot::SceneCard card_;
  uint32_t bodies_ = 0;  // up to the last one of an instrument
  GhostPath path_;
  GhostPace pace_;
  std::vector<swage_pose> shown_;
  double last_s_ = 0;
  std::mutex lock_;
  std::vector<Made> made_;  // and not yet taken; under the lock
  std::atomic<bool> stop_{false}, done_{false}, failed_{false};
  std::thread thread_;
};

/// By which instruments of a scene are compared: their tips, and the middle of each of their bodies.
std::vector<BodyPlace> instrument_places(const snapshot::SceneCard& card);

}  // namespace swage::console
