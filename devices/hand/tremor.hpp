// SPDX-License-Identifier: Apache-2.0
//
// Physiological tremor of a hand: a band of sinusoids with random frequencies and phases. Deterministic once
// drawn.
#pragma once

#include <array>
#include <cmath>
#include <numbers>

#include "toolkit/math.hpp"

namespace swage::hand {

/// The band is cut into kLines equal slots per axis, with one random frequency in each, all of one amplitude, so
/// that the power is flat over the band and zero outside it. Hands of eye surgeons: 8-12 Hz, 38 um RMS at the
/// tool (Riviere); 50-200 um for others.
class Tremor {
 public:
  static constexpr int kLines = 12;  // per axis; with fewer lines the beats are noticeable, more cost time

  /// `rms`: root mean square of the displacement vector over a long time [m]; low, high [Hz]; `uniform` gives
  /// [0, 1).
  template <class Uniform>
  void draw(double rms, double low, double high, Uniform&& uniform) {
    // each line has the mean square A^2 / 2; three axes with kLines each add up to rms^2
    amplitude_ = rms / std::sqrt(1.5 * kLines);
    const double slot = (high - low) / kLines;
    for (auto& axis : lines_) {
      for (int i = 0; i < kLines; ++i) {
        axis[static_cast<size_t>(i)] = {2 * std::numbers::pi * (low + slot * (i + uniform())),
                                        2 * std::numbers::pi * uniform()};
      }
    }
  }

  /// Displacement [m] and its velocity [m/s] at time t [s]. [rt]
  void at(double t, toolkit::Vec3& p, toolkit::Vec3& v) const noexcept {
    p.setZero();
    v.setZero();
    if (amplitude_ == 0) return;
    for (int k = 0; k < 3; ++k) {
      for (const Line& line : lines_[static_cast<size_t>(k)]) {
        p[k] += amplitude_ * std::sin(line.rate * t + line.phase);
        v[k] += amplitude_ * line.rate * std::cos(line.rate * t + line.phase);
      }
    }
  }

 private:
  struct Line {
    double rate = 0, phase = 0;  // rad/s, rad
  };
  std::array<std::array<Line, kLines>, 3> lines_{};
  double amplitude_ = 0;  // m
};

}  // namespace swage::hand
