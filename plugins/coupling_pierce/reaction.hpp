// SPDX-License-Identifier: Apache-2.0
//
// The reaction law: additional force that a point must bear at an angle theta to the inward normal (thesis figure 5.2-5). Data,
// chosen by the lesson. Header-only, pure, [rt].
#pragma once

#include <array>
#include <cmath>
#include <numbers>

namespace swage::coupling_pierce {

enum class Law : int { kNullZone, kThreshold, kQuadratic, kTable };

struct Reaction {
  Law law = Law::kNullZone;
  double null_angle = 0;                   // rad, up to which the reaction is zero
  double at_right_angle = 0;               // N, at 90 deg
  std::array<double, 4> angle{}, force{};  // rad rising, N: kTable

  /// Reaction force [N] at theta [rad, 0..pi/2].
  double operator()(double theta) const noexcept {
    if (law == Law::kTable) return table(theta);
    if (theta <= null_angle) return 0;
    const double share = (theta - null_angle) / (0.5 * std::numbers::pi - null_angle);
    if (law == Law::kThreshold) return at_right_angle;
    return at_right_angle * (law == Law::kQuadratic ? share * share : share);
  }

 private:
  double table(double theta) const noexcept {
    if (theta <= angle[0]) return force[0];
    for (size_t i = 1; i < angle.size(); ++i)
      if (theta <= angle[i]) {
        const double step = angle[i] - angle[i - 1];
        return step > 0 ? force[i - 1] + (theta - angle[i - 1]) / step * (force[i] - force[i - 1]) : force[i];
      }
    return force.back();
  }
};

}  // namespace swage::coupling_pierce
