// SPDX-License-Identifier: Apache-2.0
//
// Smoothness of movements: spectral arc length (SPARC) and log dimensionless jerk (LDLJ) of a speed profile, as Balasubramanian,
// Melendez-Calderon, Roby-Brami and Burdet define them (J. NeuroEng. Rehabil. 12:112, 2015; defaults of their program). M27 and M28.
//
//   SPARC = - sum over f of sqrt((df / (f1 - f0))^2 + (dM)^2)        M(f) = |V(f)| / max |V|,  V: Fourier transform of the speed v
//           f0, f1: first and last frequency up to 10 Hz with M >= 0.05
//   LDLJ  = - ln(T^3 / v_peak^2 * integral of (d2v/dt2)^2 dt)
//
// V is summed sample by sample on a fixed grid of frequencies, and no movement is stored: V(f) -> V(f) e^(i w h) + v has the magnitude
// of the transform. Pure arithmetic on doubles. Threads: built on [main], the rest [rt]; nothing allocates.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "toolkit/math.hpp"

namespace swage::lessons {

using toolkit::Vec3;

/// The spectrum of one speed profile.
struct SpectrumState {
  // 0 to 10 Hz by 0.025 Hz, the resolution of the authors' zero padding for a movement of 2.5 s; a movement of 5 s loses 0.7 % of its arc
  // length, one of 10 s 4 %.
  static constexpr size_t kFrequencies = 401;
  double re[kFrequencies] = {}, im[kFrequencies] = {};
};

class Spectrum {
 public:
  static constexpr double kTop = 10;          // Hz
  static constexpr double kThreshold = 0.05;  // of the greatest magnitude

  Spectrum() = default;
  /// h [s]: sampling interval of the speeds, at most 0.05.
  explicit Spectrum(double h) {
    for (size_t k = 0; k < SpectrumState::kFrequencies; ++k) {
      const double turn = 2 * std::numbers::pi * kTop * static_cast<double>(k) / (SpectrumState::kFrequencies - 1) * h;
      cos_[k] = std::cos(turn), sin_[k] = std::sin(turn);
    }
  }
  /// Adds a speed, in any unit. [rt]
  void add(SpectrumState& s, double v) const noexcept {
    for (size_t k = 0; k < SpectrumState::kFrequencies; ++k) {
      const double re = s.re[k], im = s.im[k];
      s.re[k] = re * cos_[k] - im * sin_[k] + v;
      s.im[k] = re * sin_[k] + im * cos_[k];
    }
  }
  /// SPARC; 0 without movement. [rt]
  static double arc_length(const SpectrumState& s) noexcept {
    double most = 0;
    for (size_t k = 0; k < SpectrumState::kFrequencies; ++k) most = std::max(most, magnitude(s, k));
    if (!(most > 0)) return 0;
    size_t first = 0, last = SpectrumState::kFrequencies - 1;
    while (magnitude(s, first) < kThreshold * most) ++first;
    while (last > first && magnitude(s, last) < kThreshold * most) --last;
    if (last == first) return 0;
    const double step = 1.0 / static_cast<double>(last - first);
    double sum = 0;
    for (size_t k = first; k < last; ++k) sum += std::hypot(step, (magnitude(s, k + 1) - magnitude(s, k)) / most);
    return -sum;
  }

 private:
  static double magnitude(const SpectrumState& s, size_t k) noexcept { return std::hypot(s.re[k], s.im[k]); }

  std::array<double, SpectrumState::kFrequencies> cos_{}, sin_{};
};

/// The jerk of one speed profile.
struct JerkState {
  double samples = 0, peak = 0, length = 0;  // 1, m/s, m
  double before[2] = {};                     // m/s, the last two speeds
  double square = 0;                         // (m/s3)^2, sum of the squared second derivatives
};
/// Adds a speed [m/s], h [s] after the one before. [rt]
inline void add_jerk(JerkState& s, double v, double h) noexcept {
  if (s.samples >= 2) {
    const double second = (v - 2 * s.before[0] + s.before[1]) / (h * h);
    s.square += second * second;
  }
  s.before[1] = s.before[0], s.before[0] = v;
  s.samples += 1;
  s.peak = std::max(s.peak, v);
  s.length += v * h;
}
/// LDLJ; 0 without movement. [rt]
inline double log_jerk(const JerkState& s, double h) noexcept {
  const double T = s.samples * h;
  const double jerk = s.peak > 0 ? T * T * T / (s.peak * s.peak) * s.square * h : 0;
  return jerk > 0 ? -std::log(jerk) : 0;
}

/// Values for a median; the first kMost of them count.
struct MedianState {
  static constexpr size_t kMost = 128;
  double n = 0, value[kMost] = {};  // sorted
};
inline void add_value(MedianState& s, double x) noexcept {
  const auto n = static_cast<size_t>(s.n);
  if (n >= MedianState::kMost) return;
  double* at = std::upper_bound(s.value, s.value + n, x);
  std::copy_backward(at, s.value + n, s.value + n + 1);
  *at = x;
  s.n += 1;
}
inline double median(const MedianState& s) noexcept {
  const auto n = static_cast<size_t>(s.n);
  return n == 0 ? 0 : 0.5 * (s.value[(n - 1) / 2] + s.value[n / 2]);
}

/// The movements of one point.
struct MovesState {
  static constexpr size_t kAround = 20;  // samples before and after a movement, 0.2 s
  SpectrumState spectrum;
  JerkState jerk;
  double steps = 0, seen = 0;                 // steps since the last sample; 0 or 1, there was a sample
  double last[3] = {0, 0, 0};                 // m
  double moving = 0;                          // 0 or 1
  double around[kAround] = {}, n_around = 0;  // m/s: slow samples, part of the movement if it continues
  MedianState sparc, ldlj;                    // of all movements
};
/// Segments the voluntary motion of a point into movements: speed above 0.5 mm/s, with 0.2 s before and after; shorter pauses are included.
class MovesWatch {
 public:
  MovesWatch() = default;
  explicit MovesWatch(double dt) : every_(std::max(1.0, std::round(kPeriod / dt))), h_(every_ * dt), spectrum_(h_) {}

  /// Adds the position of the point without tremor. [rt]
  void look(MovesState& s, const Vec3& now) const noexcept {
    s.steps += 1;
    if (s.seen != 0 && s.steps < every_) return;
    Eigen::Map<Vec3> last(s.last);
    const double v = s.seen != 0 ? (now - last).norm() / h_ : 0;
    last = now;
    s.steps = 0;
    s.seen = 1;
    sample(s, v);
  }

 private:
  // Sampling interval of the speed, s; a hand's voluntary motion is below 6 Hz, so there is no aliasing.
  static constexpr double kPeriod = 0.01;
  static constexpr double kSlow = 0.5e-3;    // m/s: a tremor of 40 um leaves 0.4 mm/s below 6 Hz; a larger value shortens slow reaches
  static constexpr double kQuick = 2e-3;     // m/s, least peak of a movement (M01)
  static constexpr double kShortest = 0.15;  // s, least duration of a movement (M24)
  static constexpr double kLong = 20e-3;     // m: LDLJ of a shorter movement measures its length, not its smoothness (catalogue, 10.1)

  // the slow samples before and after a movement enter its spectrum, but not its jerk
  void sample(MovesState& s, double v) const noexcept {
    if (v > kSlow) {
      for (size_t i = 0; i < static_cast<size_t>(s.n_around); ++i) {
        spectrum_.add(s.spectrum, s.around[i]);
        if (s.moving != 0) add_jerk(s.jerk, s.around[i], h_);
      }
      spectrum_.add(s.spectrum, v);
      add_jerk(s.jerk, v, h_);
      s.n_around = 0, s.moving = 1;
      return;
    }
    if (s.n_around >= MovesState::kAround) {
      if (s.moving != 0) end(s);
      std::copy(s.around + 1, s.around + MovesState::kAround, s.around);
      s.n_around -= 1;
    }
    s.around[static_cast<size_t>(s.n_around)] = v;
    s.n_around += 1;
  }
  void end(MovesState& s) const noexcept {
    for (const double v : s.around) spectrum_.add(s.spectrum, v);
    if (s.jerk.samples * h_ >= kShortest && s.jerk.peak > kQuick) {
      add_value(s.sparc, Spectrum::arc_length(s.spectrum));
      if (s.jerk.length > kLong) add_value(s.ldlj, log_jerk(s.jerk, h_));
    }
    s.spectrum = {}, s.jerk = {};
    s.moving = 0;
  }

  double every_ = 10, h_ = kPeriod;
  Spectrum spectrum_;
};

}  // namespace swage::lessons
