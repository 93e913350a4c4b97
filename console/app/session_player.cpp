// SPDX-License-Identifier: LGPL-3.0-or-later
#include "console/app/session_player.hpp"

#include <QStringList>
#include <utility>

#include "console/models/qt_text.hpp"
#include "console/models/said.hpp"
#include "session/knot_pull.hpp"
#include "session/playback.hpp"
#include "session/rehearsal.hpp"

namespace swage::console {
namespace {

/// "3 islands not converged, 1 contacts dropped ...", in the language of the window.
QString health_text(const std::string& health) {
  QStringList parts = qt(health).split(QStringLiteral(", "), Qt::SkipEmptyParts);
  for (QString& part : parts) part = part.section(QLatin1Char(' '), 0, 0) + QLatin1Char(' ') + said(part.section(QLatin1Char(' '), 1));
  return parts.join(QStringLiteral(", "));
}

class SessionPuller final : public KnotPuller {
 public:
  SessionPuller(session::KnotCopy copy, double friction, std::unique_ptr<session::Rehearsal> pull)
      : copy_(std::move(copy)), friction_(friction > 0 ? friction : copy_.friction), pull_(std::move(pull)) {}
  const snapshot::SceneCard& card() const override { return pull_->card(); }
  PulledKnot knot() const override { return {qt(copy_.word), copy_.loop, friction_}; }
  bool step(uint64_t most) override {
    for (uint64_t n = 0; n < most; ++n)
      if (!pull_->step()) return false;
    return true;
  }
  PullState state() const override {
    const session::Pulled now = session::pulled(*pull_);
    return {now.over, now.holds, now.reason == "failed.broke", now.bears, now.slip, health_text(now.health)};
  }
  void fill(snapshot::Snapshot& out) const override { pull_->fill(out); }

 private:
  const session::KnotCopy copy_;
  const double friction_;
  std::unique_ptr<session::Rehearsal> pull_;
};

class SessionPlayer final : public Player {
 public:
  SessionPlayer(std::unique_ptr<session::Playback> playback, std::vector<std::string> plugin_dirs, std::string pull_lesson)
      : playback_(std::move(playback)), plugin_dirs_(std::move(plugin_dirs)), pull_lesson_(std::move(pull_lesson)) {}
  const snapshot::SceneCard& card() const override { return playback_->card(); }
  uint64_t at() const override { return playback_->at(); }
  uint64_t count() const override { return playback_->count(); }
  bool toward(uint64_t target, uint64_t most) override { return playback_->toward(target, most); }
  void fill(snapshot::Snapshot& out) const override { playback_->fill(out); }
  uint64_t first_difference() const override { return playback_->first_difference(); }
  std::unique_ptr<KnotPuller> pull_knot(const PullWish& wish, base::Problems& problems) override {
    session::KnotCopy copy;
    if (!session::copy_knot(playback_->rig(), playback_->engine().world(), copy, problems)) return nullptr;
    auto pull = session::open_pull(copy, {pull_lesson_, plugin_dirs_, wish.load_N, wish.friction}, problems);
    return pull ? std::make_unique<SessionPuller>(std::move(copy), wish.friction, std::move(pull)) : nullptr;
  }

 private:
  std::unique_ptr<session::Playback> playback_;
  const std::vector<std::string> plugin_dirs_;
  const std::string pull_lesson_;
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

std::unique_ptr<Player> open_session_player(const record::Recording& recording, const std::vector<std::string>& plugin_dirs,
                                            const std::string& pull_lesson, base::Problems& problems) {
  auto playback = session::Playback::open(recording, plugin_dirs, problems);
  return playback ? std::make_unique<SessionPlayer>(std::move(playback), plugin_dirs, pull_lesson) : nullptr;
}

}  // namespace swage::console
