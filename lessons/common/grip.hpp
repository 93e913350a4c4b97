// SPDX-License-Identifier: Apache-2.0
//
// Force of the jaws, for several lessons: its mean and peak while held, and the cue of too much force.
#pragma once

#include "common/low_pass.hpp"
#include "common/measures.hpp"

namespace swage::lessons {

/// Doubles only; part of a lesson's private numbers.
struct GripState {
  LowPassState filter;
  QuantileState quantile;          // of the force while held
  double now = 0;                  // N, below kBand
  double held_s = 0, force_s = 0;  // s, N s
  double hard = 0, until_s = 0;    // 0 or 1: the cue is shown; s, earliest time of its end
};

class GripWatch {
 public:
  GripWatch() = default;
  /// limit [N]: above it the cue is shown.
  GripWatch(double limit, double dt)
      : limit_(limit), filter_(kBand, dt, LowPass::kCritical), quantile_(kTop * limit) {}

  /// Adds the force [N] of the jaws in this step of dt [s]. [rt]
  void look(GripState& state, double force, bool held, double time_s, double dt) const noexcept {
    state.now = filter_.next(state.filter, force);
    if (held) {
      quantile_.look(state.quantile, state.now, dt);
      state.held_s += dt;
      state.force_s += state.now * dt;
    }
    if (force > limit_) {
      if (state.hard == 0) state.until_s = time_s + kSignTime;
      state.hard = 1;
    } else if (force < kSignLeaves * limit_ && time_s >= state.until_s) {
      state.hard = 0;
    }
  }

  static bool too_hard(const GripState& state) { return state.hard != 0; }
  /// Mean force while held, N; 0 before anything was held (M15).
  static double mean(const GripState& state) { return state.held_s > 0 ? state.force_s / state.held_s : 0; }
  /// Peak force, N: exceeded for 0.5 % of the held time (M16).
  double peak(const GripState& state) const { return quantile_.at(state.quantile, 0.995); }

 private:
  // Cut-off of the low pass, Hz: a hand controls its force below it; above it is noise of the contact.
  static constexpr double kBand = 20;
  // The cue is shown at least this long, s, and until the force falls below this share of the limit.
  static constexpr double kSignTime = 0.3, kSignLeaves = 0.9;
  // Upper end of the histogram of the force, in limits.
  static constexpr double kTop = 4;

  double limit_ = 1;
  LowPass filter_;
  Quantile quantile_;
};

}  // namespace swage::lessons
