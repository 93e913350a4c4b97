// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A recorded attempt that can be played to any step, and the functions that open it; tests put doubles behind both.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/problem.hpp"
#include "console/link/knot_puller.hpp"
#include "record/recorder.hpp"
#include "record/store.hpp"
#include "snapshot/scene_card.hpp"
#include "snapshot/snapshot.hpp"

namespace swage::console {

/// GUI thread only.
class Player {
 public:
  virtual ~Player() = default;
  virtual const snapshot::SceneCard& card() const = 0;
  virtual uint64_t at() const = 0;     // steps made: the state that fill() writes
  virtual uint64_t count() const = 0;  // steps of the recording
  /// Plays towards a step, by at most `most` steps; true when it is reached.
  virtual bool toward(uint64_t target, uint64_t most) = 0;
  virtual void fill(snapshot::Snapshot& out) const = 0;
  /// First step whose state differs from the recorded attempt's; count() while all are equal bit for bit.
  virtual uint64_t first_difference() const = 0;
  /// Copies the knot as it is at this step into the pull test. nullptr, and why in `problems`, where there is none that can be pulled.
  virtual std::unique_ptr<KnotPuller> pull_knot(const PullWish&, base::Problems&) { return nullptr; }
};

/// Reads the recording of an attempt. On failure false, and `error` as a sentence.
using RecordingReader =
    std::function<bool(const std::string& attempt_id, record::Recording& out, std::string& error)>;
/// Opens a file as a read-only store; nullptr and `error` when it is no store.
using FileOpener = std::function<std::unique_ptr<record::Store>(const std::string& file, std::string& error)>;
using FileReader =
    std::function<bool(const std::string& file, const std::string& attempt_id, record::Recording& out, std::string& error)>;
/// Builds the scene of a recording; nullptr and problems when a plugin is missing. The recording outlives the player.
using PlayerOpener =
    std::function<std::unique_ptr<Player>(const record::Recording& recording, base::Problems& problems)>;

}  // namespace swage::console
