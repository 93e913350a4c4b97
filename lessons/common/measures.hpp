// SPDX-License-Identifier: Apache-2.0
//
// Numbers about a hand that several lessons report: rest, spread, quantile, tremor. Each keeps its state in a struct of
// doubles that a lesson puts among its private numbers. Definitions: lessons/grasp/grasp.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "common/low_pass.hpp"
#include "toolkit/math.hpp"

namespace swage::lessons {

using toolkit::Vec3;

/// Points deducted, of 100, for bending the needle; `bending`: greatest moment over the yield moment. None below 0.7, where a wire springs
/// back with a margin, 20 from yield on.
inline double bending_points(double bending) noexcept {
  constexpr double kGood = 0.7, kMost = 20;
  return kMost * std::clamp((bending - kGood) / (1 - kGood), 0.0, 1.0);
}

/// Mean and standard deviation of a value over time, by Welford's recurrence (no cancellation).
struct SpreadState {
  double weight = 0, mean = 0, m2 = 0;
};
inline void spread(SpreadState& state, double x, double dt) noexcept {
  state.weight += dt;
  const double d = x - state.mean;
  state.mean += d * dt / state.weight;
  state.m2 += dt * d * (x - state.mean);
}
inline double deviation(const SpreadState& state) {
  // rounding may make the sum of squares of one sample negative, about -1e-17, whose root is NaN
  return state.weight > 0 ? std::sqrt(std::max(0.0, state.m2) / state.weight) : 0;
}

/// Quantile of a value over time from a histogram: kBins equal bins from 0 to `top`; values above it count in the last.
struct QuantileState {
  static constexpr int kBins = 128;
  double bin[kBins] = {};
  double most = 0;
};
class Quantile {
 public:
  Quantile() = default;
  explicit Quantile(double top) : width_(top / QuantileState::kBins) {}
  void look(QuantileState& state, double x, double dt) const noexcept {
    const int i = std::clamp(static_cast<int>(x / width_), 0, QuantileState::kBins - 1);
    state.bin[i] += dt;
    state.most = std::max(state.most, x);
  }
  /// Value exceeded for the share 1 - q of the time, linear within a bin; at most the greatest value added.
  double at(const QuantileState& state, double q) const noexcept {
    double all = 0, sum = 0;
    for (const double t : state.bin) all += t;
    if (!(all > 0)) return 0;
    for (int i = 0; i < QuantileState::kBins; ++i) {
      const double inside = state.bin[i];
      if (sum + inside >= q * all && i + 1 < QuantileState::kBins) {
        const double share = inside > 0 ? (q * all - sum) / inside : 0;
        return std::min(state.most, (i + share) * width_);
      }
      sum += inside;
    }
    return state.most;
  }

 private:
  double width_ = 0.02;
};

/// Idle time of an instrument: its tips, the opening of its jaws and their force have not changed for more than 0.5 s (M03).
struct IdleState {
  double at[3] = {0, 0, 0}, opening = 0, force = 0;  // m, rad, N: values that have not changed
  double still_s = 0, idle_s = 0, all_s = 0;
};
class IdleWatch {
 public:
  /// `voluntary_W`: position of the tips without tremor, m. `opening` [rad] and `force` [N] of the jaws, which are not idle while they
  /// close or press harder. `counts`: the hand has set off and is in no hold. [rt]
  static void look(IdleState& state, const Vec3& voluntary_W, double opening, double force, double dt, bool counts) noexcept {
    // m: 0.2 mm/s for 0.5 s, more than a tremor of 100 um leaves below 6 Hz; rad, 1 deg; N; s
    constexpr double kPlace = 0.1e-3, kOpening = std::numbers::pi / 180, kForce = 0.05, kFor = 0.5;
    Eigen::Map<Vec3> at(state.at);
    const bool still = counts && (voluntary_W - at).norm() < kPlace && std::abs(opening - state.opening) < kOpening &&
                       std::abs(force - state.force) < kForce;
    if (!still) at = voluntary_W, state.opening = opening, state.force = force, state.still_s = 0;
    if (!counts) return;
    state.all_s += dt;
    const double before = state.still_s;
    state.still_s += dt;
    if (state.still_s > kFor) state.idle_s += before > kFor ? dt : state.still_s;
  }
  static double share(const IdleState& state) { return state.all_s > 0 ? state.idle_s / state.all_s : 0; }
};

/// Band pass of two equal sections H(s) = (s/q) / (s^2 + s/q + 1): gain 1 in the middle of the band, 0.707 at its ends; of slow
/// movement (f / middle / q)^2 remains. Bilinear, warped so that the middle is exact.
struct BandPassState {
  LowPassState first, second;
};
class BandPass {
 public:
  BandPass() = default;
  BandPass(double low, double high, double dt) {
    // each section has the gain 0.707^(1/2) at the ends: q |f/middle - middle/f| = (2^(1/2) - 1)^(1/2)
    const double middle = std::sqrt(low * high), q = std::sqrt(std::sqrt(2.0) - 1) * middle / (high - low);
    const double k = std::tan(std::numbers::pi * middle * dt);
    const double norm = 1 / (1 + k / q + k * k);
    b_ = k / q * norm;
    a1_ = 2 * (k * k - 1) * norm;
    a2_ = (1 - k / q + k * k) * norm;
  }
  /// Filters one value. The filter starts in the steady state of the first value. [rt]
  double next(BandPassState& state, double x) const noexcept {
    return section(state.second, section(state.first, x));
  }

 private:
  double section(LowPassState& state, double x) const noexcept {
    if (state.started == 0) state = {1, -b_ * x, -b_ * x};
    const double y = b_ * x + state.m1;
    state.m1 = -a1_ * y + state.m2;
    state.m2 = -b_ * x - a2_ * y;
    return y;
  }

  double b_ = 0, a1_ = 0, a2_ = 0;
};

/// Tremor: root mean square displacement of a point in the band 8 to 12 Hz during a hold (M30).
struct TremorState {
  BandPassState x, y, z;
  double square_s = 0, time_s = 0;  // m2 s, s
};
class TremorWatch {
 public:
  TremorWatch() = default;
  explicit TremorWatch(double dt) : band_(8, 12, dt), dt_(dt) {}
  void look(TremorState& state, const Vec3& p_W, bool counts) const noexcept {
    const Vec3 d(band_.next(state.x, p_W.x()), band_.next(state.y, p_W.y()), band_.next(state.z, p_W.z()));
    if (!counts) return;
    state.square_s += d.squaredNorm() * dt_;
    state.time_s += dt_;
  }
  static double rms(const TremorState& state) {
    return state.time_s > 0 ? std::sqrt(state.square_s / state.time_s) : 0;
  }

 private:
  BandPass band_;
  double dt_ = 1e-3;
};

}  // namespace swage::lessons
