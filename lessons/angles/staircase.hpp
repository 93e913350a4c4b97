// SPDX-License-Identifier: Apache-2.0
//
// Staircase for the next angle, and estimate of bias and threshold from the answers. Pure arithmetic; doubles only. Sources: angles.md.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

namespace swage::lesson_angles {

/// Two down, one up (Levitt 1971): where it settles, 71 % of the answers are right. Angles in rad, towards the track's own side; a
/// track that goes below 0 shows the other side.
struct TrackState {
  double level = 0, step = 0;  // rad
  double rights = 0;           // right answers in a row
  double way = 0;              // direction of the last step: -1 down, 1 up, 0 none yet
  double reversals = 0, count = 0;
};

class Track {
 public:
  Track() = default;
  /// Begins at `start` [rad]; its step is halved with each reversal down to `least`.
  Track(double start, double least) : start_(start), least_(least) {}

  void begin(TrackState& s) const noexcept {
    s = {};
    s.level = start_;
    s.step = std::max(least_, kFirst * start_);
  }
  /// `agrees`: the answer was the track's own side. [rt]
  void answer(TrackState& s, bool agrees) const noexcept {
    s.count += 1;
    s.rights = agrees ? s.rights + 1 : 0;
    // until the first reversal one right answer is enough for a step down: the start is far above the threshold
    const double way = !agrees ? 1 : s.rights >= 2 || s.reversals == 0 ? -1 : 0;
    if (way == 0) return;
    if (s.way != 0 && way != s.way) {
      s.reversals += 1;
      s.step = std::max(least_, 0.5 * s.step);
    }
    s.way = way;
    s.rights = 0;
    s.level = std::clamp(s.level + way * s.step, -2 * start_, 2 * start_);
  }

 private:
  // First step over first lean: 16, 10, 4, -2 deg. Not a half of it: a lean of 0 has no right answer.
  static constexpr double kFirst = 0.375;

  double start_ = 0.28, least_ = 0.017;
};

/// All answers about one axis, and the cumulative normal curve through them: the share of "to the other side" at a lean x is
/// Phi((x + bias) / spread).
struct AnswersState {
  static constexpr size_t kMost = 64;
  double n = 0;
  double lean[kMost] = {};   // rad, true lean
  double other[kMost] = {};  // 1 or -1
  double bias = 0;           // rad: perceived lean minus true lean
  double spread = 0;         // rad, standard deviation
};

class Answers {
 public:
  /// Just-noticeable difference over spread: the lean with 75 % right answers of an observer without bias.
  static constexpr double kNoticed = 0.674489750196082;

  /// [rt]
  static void add(AnswersState& s, double lean, bool other, double widest) noexcept {
    const auto i = static_cast<size_t>(s.n);
    if (i >= AnswersState::kMost) return;
    s.lean[i] = lean;
    s.other[i] = other ? 1 : -1;
    s.n += 1;
    fit(s, widest);
  }
  static double jnd(const AnswersState& s) { return kNoticed * s.spread; }

 private:
  struct Sums {
    double ga = 0, gb = 0, aa = 0, ab = 0, bb = 0;  // gradient and information of the log likelihood
  };
  // Weight of artificial answers, right and wrong, at the widest angles: they keep the fit finite while all answers are right. A hundredth
  // of an answer each moves a spread of 5 deg by less than its own uncertainty; without them the fit diverges.
  static constexpr double kDoubt = 0.01;
  static constexpr int kIterations = 12;

  static void weigh(Sums& sums, double a, double b, double x, double y, double weight) noexcept {
    const double z = std::clamp(y * (a + b * x), -6.0, 6.0);
    const double below = 0.5 * std::erfc(-z / std::numbers::sqrt2);
    const double ratio = std::exp(-0.5 * z * z) / std::sqrt(2 * std::numbers::pi) / below;
    const double curve = weight * ratio * (ratio + z);
    sums.ga += weight * y * ratio;
    sums.gb += weight * y * ratio * x;
    sums.aa += curve;
    sums.ab += curve * x;
    sums.bb += curve * x * x;
  }
  /// Newton's method on the log likelihood of Phi(a + b x), which is concave; x in units of `widest`.
  static void fit(AnswersState& s, double widest) noexcept {
    double a = 0, b = 1;
    for (int k = 0; k < kIterations; ++k) {
      Sums sums;
      for (size_t i = 0; i < static_cast<size_t>(s.n); ++i)
        weigh(sums, a, b, s.lean[i] / widest, s.other[i], 1);
      for (const double x : {-1.0, 1.0})
        for (const double y : {-1.0, 1.0}) weigh(sums, a, b, x, y, kDoubt);
      const double det = sums.aa * sums.bb - sums.ab * sums.ab;
      if (!(det > 0)) break;
      a += (sums.bb * sums.ga - sums.ab * sums.gb) / det;
      b += (sums.aa * sums.gb - sums.ab * sums.ga) / det;
    }
    // guessing gives a curve without slope: its spread is reported as twice the widest angle
    const double slope = std::max(b, 0.5);
    s.spread = widest / slope;
    s.bias = std::clamp(a / slope, -1.0, 1.0) * widest;
  }
};

}  // namespace swage::lesson_angles
