// SPDX-License-Identifier: Apache-2.0
//
// Haptic cues: when a cue comes on, the hand gets a few short pulses in addition to the scene's force. Like every force they
// reach the device through its guard.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "judge/verdict.hpp"

namespace swage::session {

/// Pulses of one meaning. Usual: one to four pulses of some 60 to 160 Hz, 0.1 to 0.3 N, 0.02 to 0.08 s. Below 30 Hz it feels
/// like a push and moves the hand, above 300 Hz steps of 1 ms cannot render it; above 0.5 N the tool moves.
struct CuePulse {
  std::string meaning;   // of a cue: "grasp.good"
  uint32_t pulses = 0;   // 0: no pulse
  double frequency = 0;  // Hz
  double peak = 0;       // N
  double length = 0;     // s, of one pulse; the pause between two is as long
};

class CueForce {
 public:
  /// `felt`: the cues of the script that may be felt at all. [main]
  CueForce(const judge::Script& script, const std::vector<bool>& felt, const std::vector<CuePulse>& pulses,
           std::size_t objects);

  /// After a step of `dt` seconds: force to add on the hand, N along the device's y (up). A cue is played completely when it
  /// comes on, so that a flickering cue does not rattle; of the cues that come on meanwhile the newest is played next. [rt]
  double tick(const judge::Verdict& verdict, double dt) noexcept;

 private:
  std::vector<CuePulse> of_cue_;         // by cue index; 0 pulses: not felt
  std::vector<uint32_t> object_, mark_;  // cues of the last step
  const CuePulse *playing_ = nullptr, *next_ = nullptr;
  double time_ = 0;  // s since the first pulse of playing_ began
};

/// Force of a train of pulses `t` seconds after its start, N: a sine with a Hann window, so that value and slope are zero at both ends.
double pulse_force(const CuePulse& pulse, double t) noexcept;
/// s, of the whole train with the pause after it
inline double length(const CuePulse& pulse) noexcept { return 2 * pulse.length * pulse.pulses; }

}  // namespace swage::session
