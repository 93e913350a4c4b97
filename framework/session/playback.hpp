// SPDX-License-Identifier: Apache-2.0
//
// Playback of a recorded attempt: the scene is stepped again on the recorded samples and commands, and can be rewound.
// Threads: [main]; no clock is used.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "base/problem.hpp"
#include "host/rig.hpp"
#include "record/recorder.hpp"
#include "snapshot/snapshot.hpp"
#include "step/step.hpp"

namespace swage::session {

class Playback {
 public:
  /// Builds the scene from the recording's own descriptor. nullptr and `problems` when it cannot be built (a plugin is
  /// missing). Devices need not be installed: their samples are recorded. `recording` outlives the playback.
  static std::unique_ptr<Playback> open(const record::Recording& recording,
                                        const std::vector<std::string>& plugin_dirs,
                                        base::Problems& problems);
  ~Playback();

  const snapshot::SceneCard& card() const { return rig_->card; }
  const host::Rig& rig() const { return *rig_; }
  const step::Engine& engine() const { return *engine_; }

  /// Steps done so far: the displayed state is that after this number of steps. 0 is the start.
  uint64_t at() const { return at_; }
  /// Steps that can be displayed: all, or those up to the first that was not recorded.
  uint64_t count() const { return count_; }

  /// One step forward. False at the end.
  bool step();
  /// Steps towards the state after `target` steps, by at most `most` steps, so that a window stays responsive; true when it is reached.
  /// Backwards it starts from the last stored state before the target.
  bool toward(uint64_t target, uint64_t most);
  void fill(snapshot::Snapshot& out) const { engine_->fill(out); }

  /// The first step whose hash differs from the recorded one; count() when none was found so far. Another version of a plugin
  /// gives other bits: the display from there on resembles the attempt, but is not the attempt.
  uint64_t first_difference() const { return first_difference_; }

 private:
  class Port;
  class Unpacked;
  struct Kept {
    uint64_t at = 0;
    std::vector<std::byte> image;
  };
  Playback(const record::Recording& recording, std::vector<std::string> plugin_dirs);
  bool build(base::Problems& problems);
  void push_commands();
  void back_to(uint64_t target);
  bool live_change_between(uint64_t from, uint64_t to) const;

  const record::Recording& recording_;
  const std::vector<std::string> plugin_dirs_;
  std::unique_ptr<Unpacked> files_;  // of the recording; the rig names their places
  std::unique_ptr<host::Rig> rig_;
  std::vector<std::unique_ptr<Port>> ports_;
  std::unique_ptr<step::Engine> engine_;
  std::vector<Kept> kept_;
  uint64_t at_ = 0, count_ = 0, first_difference_ = 0;
  std::size_t command_ = 0;
};

}  // namespace swage::session
