// SPDX-License-Identifier: Apache-2.0
//
// In which unit a value is read, and which values are so small that they are shown as 0.
#pragma once

#include <cmath>
#include <string_view>

namespace swage::base {

/// The smallest meaningful value of this SI unit; 0 for an unknown unit. Larger: a real value is displayed as 0.
/// Smaller: rounding errors are displayed as a measurement (5e-12 m between two coincident points).
inline double least_meaningful(std::string_view unit) {
  if (unit == "m") return 1e-9;    // a hundredth of the resolution of a hand's encoder, 0.1 um
  if (unit == "m2") return 1e-14;  // a square of 0.1 um; the section of a wire of 0.1 mm is 7.9e-9 m2
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

/// What a value in SI is multiplied with, and the unit that it has then: "mm", "um2", "deg"; "" for a number. A unit of which nothing is
/// known is that of the argument, which must live as long.
struct Shown {
  double factor = 1;
  std::string_view unit;
};

/// Of an axis or a column, whatever the size of its values.
inline Shown usual_unit(std::string_view unit) {
  constexpr double kDegPerRad = 57.29577951308232;
  if (unit == "m") return {1e3, "mm"};
  if (unit == "m2") return {1e6, "mm2"};
  if (unit == "m/s") return {1e3, "mm/s"};
  if (unit == "kg") return {1e3, "g"};
  if (unit == "N*s") return {1e3, "mN*s"};
  if (unit == "rad") return {kDegPerRad, "deg"};
  if (unit == "%") return {1e2, "%"};
  if (unit == "1") return {1, ""};
  return {1, unit};
}

/// Of one value: small ones are told in a smaller unit, so that their first digits are not zeros.
inline Shown shown_unit(double value, std::string_view unit) {
  const double size = std::abs(value);
  if (size == 0) return usual_unit(unit);
  if (unit == "m" && size < 1e-4) return {1e6, "um"};     // a wire's width and less
  if (unit == "m2" && size < 1e-8) return {1e12, "um2"};  // its square
  if (unit == "N" && size < 0.1) return {1e3, "mN"};      // what a thread and its knot bear
  return usual_unit(unit);
}

}  // namespace swage::base
