// SPDX-License-Identifier: Apache-2.0
//
// What lessons say about the force of the jaws: its mean and peak while held, and the sign that it is too much.
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
  double hard = 0, until_s = 0;    // 0 or 1; s, how long the sign stays at least
};

class GripWatch {
 public:
  GripWatch() = default;
  /// limit [N]: above it the sign is shown.
  GripWatch(double limit, double dt)
      : limit_(limit), filter_(kBand, dt, LowPass::kCritical), quantile_(kTop * limit) {}

  /// force [N] of the jaws in this step of dt [s]. [rt]
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
  /// Force that was exceeded for one two-hundredth of the held time, N (M16).
  double peak(const GripState& state) const { return quantile_.at(state.quantile, 0.995); }

 private:
  // Forces are judged without what the hand cannot control: above this is noise of contact, Hz.
  static constexpr double kBand = 20;
  // The sign stays at least this long, s, and goes when the force falls below this share of the limit.
  static constexpr double kSignTime = 0.3, kSignLeaves = 0.9;
  // The histogram of the force ends at so many limits.
  static constexpr double kTop = 4;

  double limit_ = 1;
  LowPass filter_;
  Quantile quantile_;
};

}  // namespace swage::lessons
