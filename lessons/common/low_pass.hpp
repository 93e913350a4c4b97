// SPDX-License-Identifier: Apache-2.0
//
// Causal low-pass filters for metrics without tremor and noise. Their state lies in the lesson's private numbers, so
// that it is saved and restored with them.
#pragma once

#include <cmath>
#include <numbers>

namespace swage::lessons {

/// State of one section: doubles only.
struct LowPassState {
  double started = 0;  // 0 or 1
  double m1 = 0, m2 = 0;
};

/// One section of order two: H(s) = 1 / (s^2 + s/q + 1) at s = i f / cut_off.
class LowPass {
 public:
  /// q without overshoot, for values that are compared with a limit. Half the amplitude is left at the cut-off.
  static constexpr double kCritical = 0.5;

  LowPass() = default;
  /// cut_off [Hz] below half the rate 1/dt; bilinear transform, warped so that the cut-off is exact.
  LowPass(double cut_off, double dt, double q) {
    const double k = std::tan(std::numbers::pi * cut_off * dt);
    const double norm = 1 / (1 + k / q + k * k);
    b_ = k * k * norm;
    a1_ = 2 * (k * k - 1) * norm;
    a2_ = (1 - k / q + k * k) * norm;
  }

  /// Filters one value. The filter starts in the steady state of the first value. [rt]
  double next(LowPassState& state, double x) const noexcept {
    if (state.started == 0) state = {1, (1 - b_) * x, (b_ - a2_) * x};
    // transposed direct form II
    const double y = b_ * x + state.m1;
    state.m1 = 2 * b_ * x - a1_ * y + state.m2;
    state.m2 = b_ * x - a2_ * y;
    return y;
  }

 private:
  double b_ = 1, a1_ = 0, a2_ = 0;
};

/// Butterworth of order four, as motion analysis uses it: flat below the cut-off, (f / cut_off)^-4 above.
struct LowPass4State {
  LowPassState first, second;
};
class LowPass4 {
 public:
  LowPass4() = default;
  LowPass4(double cut_off, double dt)
      : first_(cut_off, dt, 0.5 / std::cos(std::numbers::pi / 8)),
        second_(cut_off, dt, 0.5 / std::cos(3 * std::numbers::pi / 8)) {}
  double next(LowPass4State& state, double x) const noexcept {
    return second_.next(state.second, first_.next(state.first, x));
  }

 private:
  LowPass first_, second_;
};

}  // namespace swage::lessons
