// SPDX-License-Identifier: Apache-2.0
//
// The axes of a contact or tie. Header-only, [rt].
#pragma once

#include <cmath>

#include "toolkit/math.hpp"

namespace swage::dynamics {

/// Two unit vectors across n, without a branch that could flip between builds (Duff et al., JCGT 6 (2017) 1).
inline void axes_across(const toolkit::Vec3& n, toolkit::Vec3& t1, toolkit::Vec3& t2) {
  const double sign = std::copysign(1.0, n.z());
  const double a = -1 / (sign + n.z()), b = n.x() * n.y() * a;
  t1 = toolkit::Vec3(1 + sign * n.x() * n.x() * a, sign * b, -sign * n.x());
  t2 = toolkit::Vec3(b, sign + n.y() * n.y() * a, -n.y());
}

}  // namespace swage::dynamics
