// SPDX-License-Identifier: Apache-2.0
//
// The values of a unit that are so small that they are displayed as 0.
#pragma once

#include <cmath>
#include <string_view>

namespace swage::base {

/// The smallest meaningful value of this SI unit; 0 for an unknown unit. Larger: a real value is displayed as 0.
/// Smaller: rounding errors are displayed as a measurement (5e-12 m between two coincident points).
inline double least_meaningful(std::string_view unit) {
  if (unit == "m") return 1e-9;    // a hundredth of the resolution of a hand's encoder, 0.1 um
  if (unit == "N") return 1e-6;    // a thousandth of a usual thread tension, 1 mN
  if (unit == "rad") return 1e-6;  // 0.00006 deg
  if (unit == "s") return 1e-6;    // a thousandth of a step
  if (unit == "1" || unit == "%") return 1e-9;  // counts and shares: above rounding errors
  return 0;
}

/// `value`, or 0 if it is smaller than least_meaningful(). Never -0.
inline double meaningful(double value, std::string_view unit) {
  return value == 0 || std::abs(value) < least_meaningful(unit) ? 0 : value;
}

}  // namespace swage::base
