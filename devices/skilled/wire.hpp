// SPDX-License-Identifier: Apache-2.0
//
// A needle as a hand observes it: a circular arc, from two places on its centre line. Pure geometry, [rt].
#pragma once

#include <algorithm>
#include <cmath>

#include "toolkit/math.hpp"

namespace swage::skilled {

using toolkit::Pose;
using toolkit::Quat;
using toolkit::Vec3;

/// One place on a centre line, as the trait graspable gives it.
struct Place {
  double s = 0;       // 0 point .. 1 swage
  double length = 0;  // m, of the whole centre line, s from 0 to 1
  Vec3 p_W = Vec3::Zero(), tangent_W = Vec3::UnitX(), normal_W = Vec3::UnitZ();
};

/// The arc through two places near each other. Rotation by +angle about `axis_W` through `centre_W` leads towards the swage.
struct Wire {
  Place at;              // the observed place
  double curvature = 0;  // 1/m, about axis_W; positive
  Vec3 centre_W = Vec3::Zero(), axis_W = Vec3::UnitZ();

  static Wire through(const Place& a, const Place& b) {
    Wire w;
    w.at = a;
    const double way = (b.s - a.s) * a.length;
    const Vec3& n = a.normal_W;
    const double turn = std::atan2(n.dot(a.tangent_W.cross(b.tangent_W)), a.tangent_W.dot(b.tangent_W));
    // a radius above a metre counts as straight: nothing here is longer than a few centimetres
    w.curvature = way != 0 && std::abs(turn / way) > 1 ? turn / way : 1.0;
    w.axis_W = w.curvature < 0 ? Vec3(-n) : n;
    w.curvature = std::abs(w.curvature);
    w.centre_W = a.p_W + w.axis_W.cross(a.tangent_W) / w.curvature;
    return w;
  }

  double radius() const { return 1 / curvature; }
  /// Place at s, with unit vectors in W.
  Place place(double s) const {
    const Quat q = toolkit::exp_rotation((s - at.s) * at.length * curvature * axis_W);
    Place out = at;
    out.s = s;
    out.p_W = centre_W + q * (at.p_W - centre_W);
    out.tangent_W = q * at.tangent_W;
    return out;
  }
};

/// A pose rotated about a line through `about_W` by the rotation vector `turn_W` [rad].
inline Pose turned(const Pose& X, const Vec3& about_W, const Vec3& turn_W) {
  const Quat q = toolkit::exp_rotation(turn_W);
  return {about_W + q * (X.p - about_W), (q * X.q).normalized()};
}

}  // namespace swage::skilled
