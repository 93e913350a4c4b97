// SPDX-License-Identifier: LGPL-3.0-or-later
//
// A recorded attempt that can be wound to any step, and how the console gets at it; tests put doubles behind both.
#pragma once

#include <functional>
#include <memory>
#include <string>

#include "base/problem.hpp"
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
  virtual uint64_t at() const = 0;     // steps made: what fill() shows
  virtual uint64_t count() const = 0;  // steps there are
  /// Towards a step, with at most `most` steps of work; true when there.
  virtual bool toward(uint64_t target, uint64_t most) = 0;
  virtual void fill(snapshot::Snapshot& out) const = 0;
  /// From this step on the picture is not the attempt, bit for bit; count() when it is.
  virtual uint64_t first_difference() const = 0;
};

/// Reads what was recorded of an attempt. False and `error`, a sentence, when it cannot be read.
using RecordingReader =
    std::function<bool(const std::string& attempt_id, record::Recording& out, std::string& error)>;
/// A store that is only looked at, out of a file; nullptr and `error` when it is none.
using FileOpener = std::function<std::unique_ptr<record::Store>(const std::string& file, std::string& error)>;
using FileReader =
    std::function<bool(const std::string& file, const std::string& attempt_id, record::Recording& out, std::string& error)>;
/// Builds its scene; nullptr and problems when a plugin is missing. The recording outlives the player.
using PlayerOpener =
    std::function<std::unique_ptr<Player>(const record::Recording& recording, base::Problems& problems)>;

}  // namespace swage::console
