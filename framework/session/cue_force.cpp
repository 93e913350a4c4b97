// SPDX-License-Identifier: Apache-2.0
#include "session/cue_force.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace swage::session {

CueForce::CueForce(const judge::Script& script, const std::vector<bool>& felt,
                   const std::vector<CuePulse>& pulses, std::size_t objects)
    : of_cue_(script.cues.size()), object_(objects, SWAGE_NONE), mark_(script.marks.size(), SWAGE_NONE) {
  for (std::size_t i = 0; i < of_cue_.size(); ++i) {
    const auto named = [&](const CuePulse& p) { return p.meaning == script.cues[i].id; };
    const auto found = std::find_if(pulses.begin(), pulses.end(), named);
    if (felt[i] && found != pulses.end()) of_cue_[i] = *found;
  }
}

double CueForce::tick(const judge::Verdict& verdict, double dt) noexcept {
  const auto look = [this](const std::vector<uint32_t>& now, std::vector<uint32_t>& last) {
    for (std::size_t i = 0; i < now.size(); ++i) {
      const bool comes_on = now[i] != last[i] && now[i] < of_cue_.size();
      if (comes_on && of_cue_[now[i]].pulses > 0) next_ = &of_cue_[now[i]];
      last[i] = now[i];
    }
  };
  look(verdict.object_cue, object_);
  look(verdict.mark_cue, mark_);

  time_ += dt;
  if (!playing_ || time_ >= length(*playing_)) {
    playing_ = std::exchange(next_, nullptr);
    time_ = 0;
  }
  return playing_ ? pulse_force(*playing_, time_) : 0;
}

double pulse_force(const CuePulse& pulse, double t) noexcept {
  using std::numbers::pi;
  if (t < 0 || t >= length(pulse)) return 0;
  const double s = std::fmod(t, 2 * pulse.length);
  if (s >= pulse.length) return 0;  // the pause between two pulses
  const double window = 0.5 * (1 - std::cos(2 * pi * s / pulse.length));
  return pulse.peak * window * std::sin(2 * pi * pulse.frequency * s);
}

}  // namespace swage::session
