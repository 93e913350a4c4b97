// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace swage::toolkit {

/// Curvature at which a section bears a moment, by halving; the moment grows with the curvature.
template <class Moment>
double curvature_at(double m, const Moment& moment) {
  double low = 0, high = 100;
  for (int k = 0; k < 100; ++k) {
    const double middle = 0.5 * (low + high);
    (moment(middle) < m ? low : high) = middle;
  }
  return high;
}

}  // namespace swage::toolkit
