// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/session_player.hpp"

#include <utility>

#include "session/playback.hpp"
#include "session/rehearsal.hpp"

namespace swage::console {
namespace {

class SessionPlayer final : public Player {
 public:
  explicit SessionPlayer(std::unique_ptr<session::Playback> playback) : playback_(std::move(playback)) {}
  const snapshot::SceneCard& card() const override { return playback_->card(); }
  uint64_t at() const override { return playback_->at(); }
  uint64_t count() const override { return playback_->count(); }
  bool toward(uint64_t target, uint64_t most) override { return playback_->toward(target, most); }
  void fill(snapshot::Snapshot& out) const override { playback_->fill(out); }
  uint64_t first_difference() const override { return playback_->first_difference(); }

 private:
  std::unique_ptr<session::Playback> playback_;
};

class SessionExpert final : public Player {
 public:
  explicit SessionExpert(std::unique_ptr<session::Rehearsal> rehearsal) : rehearsal_(std::move(rehearsal)) {}
  const snapshot::SceneCard& card() const override { return rehearsal_->card(); }
  uint64_t at() const override { return rehearsal_->at(); }
  uint64_t count() const override { return rehearsal_->over() ? rehearsal_->at() : ~uint64_t{0}; }
  bool toward(uint64_t target, uint64_t most) override {
    for (uint64_t n = 0; n < most && rehearsal_->at() < target && rehearsal_->step(); ++n) continue;
    return rehearsal_->at() == target && !rehearsal_->over();
  }
  void fill(snapshot::Snapshot& out) const override { rehearsal_->fill(out); }
  uint64_t first_difference() const override { return count(); }

 private:
  std::unique_ptr<session::Rehearsal> rehearsal_;
};

}  // namespace

std::unique_ptr<Player> open_session_expert(const session::Options& options, base::Problems& problems) {
  auto rehearsal = session::Rehearsal::open(options, "expert", problems);
  return rehearsal ? std::make_unique<SessionExpert>(std::move(rehearsal)) : nullptr;
}

std::unique_ptr<Player> open_session_player(const record::Recording& recording,
                                            const std::vector<std::string>& plugin_dirs,
                                            base::Problems& problems) {
  auto playback = session::Playback::open(recording, plugin_dirs, problems);
  return playback ? std::make_unique<SessionPlayer>(std::move(playback)) : nullptr;
}

}  // namespace swage::console
