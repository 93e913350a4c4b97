// SPDX-License-Identifier: Apache-2.0
//
// Rod: bending beyond yield. Part of rod.hpp. The moment m of a section bent to the curvature k is that of two springs side by side,
//
//   m / EI = c (k - k0) + (1 - c) (k - kp),     |k - kp| <= y
//
// c the hardening, y the yield curvature, k0 the memory that the rod was made with. Where k leaves the range of the second spring its rest kp
// follows. Both together are one elastic joint about K = c k0 + (1 - c) kp, the natural curvature: bent to k and let go, it stays bent by
// (1 - c) (k - y). The corner at y stands for the curve from first yield to a section that yields throughout, 0.59 y to about 2 y.
//
// K is kept times the length of the joint, as 2 tan(K l / 2), in two parts: along the director and along tangent x director of its edges.
// It flows between steps, and stands still in one: forces of a step are elastic, and energy only falls.
#pragma once

#include "toolkit/rod.hpp"

namespace swage::toolkit {

inline void Rod::start_set(double* set) const {
  for (int i = 0; i < n_; ++i) set[2 * i] = remembered_[at(i)], set[2 * i + 1] = 0;
}

/// Natural curvature of a joint [1/m].
inline double Rod::remembered(int i) const {
  return set_ == nullptr ? std::abs(memory_) : std::sqrt(set_[2 * i] * set_[2 * i] + set_[2 * i + 1] * set_[2 * i + 1]) / joint_length(i);
}

inline void Rod::flow(const RodState& s, const RodYield& yield, double* set) const {
  if (!(yield.curvature > 0)) return;
  now_.find(s.x);
  for (int i = 0; i < n_; ++i) {
    if (!has_joint(i)) continue;
    const Edge e = i == 0 ? Edge{clamp_[0].tangent, 0} : found(i - 1), f = i == n_ - 1 ? Edge{clamp_[1].tangent, 0} : found(i);
    const Vec3 de = i == 0 ? clamp_[0].director : s.material(i - 1), df = i == n_ - 1 ? clamp_[1].director : s.material(i);
    const Vec3 k = (2 / (1 + e.t.dot(f.t))) * e.t.cross(f.t);
    const double now[2] = {0.5 * k.dot(de + df), 0.5 * k.dot(e.t.cross(de) + f.t.cross(df))};
    const double most = 2 * std::tan(0.5 * std::min(yield.curvature * joint_length(i), 3.0));
    const double from[2] = {yield.hardening * remembered_[at(i)], 0};
    double away[2];  // k - kp
    for (int r = 0; r < 2; ++r) away[r] = now[r] - (set[2 * i + r] - from[r]) / (1 - yield.hardening);
    const double size = std::sqrt(away[0] * away[0] + away[1] * away[1]);
    if (!(size > most)) continue;
    for (int r = 0; r < 2; ++r) set[2 * i + r] += (1 - yield.hardening) * (1 - most / size) * away[r];
  }
}

}  // namespace swage::toolkit
