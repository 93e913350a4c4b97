// SPDX-License-Identifier: Apache-2.0
//
// Which values of a unit are so small that they are shown as 0.
#pragma once

#include <cmath>
#include <string_view>

namespace swage::base {

/// The smallest value of this SI unit that means anything here; 0 for a unit of which nothing is known. Larger: a real value reads 0.
/// Smaller: rounding of the arithmetic is read as a measurement (5e-12 m between two points that coincide).
inline double least_meaningful(std::string_view unit) {
  if (unit == "m") return 1e-9;    // a hundredth of what an encoder of a hand tells, 0.1 um
  if (unit == "N") return 1e-6;    // a thousandth of what a thread bears, 1 mN
  if (unit == "rad") return 1e-6;  // 0.00006 deg
  if (unit == "s") return 1e-6;    // a thousandth of a step
  if (unit == "1" || unit == "%") return 1e-9;  // counts and shares: rounding
  return 0;
}

/// `value`, or 0 if it is smaller than least_meaningful(). Never -0.
inline double meaningful(double value, std::string_view unit) {
  return value == 0 || std::abs(value) < least_meaningful(unit) ? 0 : value;
}

}  // namespace swage::base
