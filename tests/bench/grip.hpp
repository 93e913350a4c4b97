// SPDX-License-Identifier: Apache-2.0
//
// What the scenarios share: jaws set to an overlap, and how far the needle has come from where it was gripped.
#pragma once

#include "reference.hpp"
#include "scenario.hpp"

namespace swage::bench {

inline constexpr double kLostAt = 0.3e-3;  // m: three wires away from the grip

inline bool finite(const Pose& X) { return X.p.allFinite() && X.q.coeffs().allFinite() && X.p.norm() < 1; }

/// Of the gripped place in the tool's frame, against X_TN_ref.
inline Slip slip_between(const Engine& e, const Pose& X_WT, const Pose& X_TN_ref) {
  const Pose X_TN = X_WT.inverse() * e.needle();
  const Vec3 held = e.setup.needle.point(e.setup.needle.held_at);
  const Vec3 d = X_TN * held - X_TN_ref * held;
  return {d.y(), d.x(), d.z(), toolkit::log_rotation(X_TN_ref.q.conjugate() * X_TN.q).norm()};
}

/// Opening angles of the two jaws for an overlap.
struct Openings {
  double upper, lower;
  Openings(const Method& m, const Needle& n, double overlap)
      : upper(closing_angle(n, 1, overlap, m.exact_arc)), lower(closing_angle(n, -1, overlap, m.exact_arc)) {}
  void apply(Engine& e, const Pose& X_WT, bool jump) const {
    const Vec3 grip{Jaw::kGrip, 0, 0};
    const Quat turn = toolkit::exp_rotation({0, 0, e.setup.misaligned});
    e.set_jaws(jaw_pose(X_WT, upper) * Pose{grip - turn * grip, turn}, jaw_pose(X_WT, -lower), jump);
  }
};

}  // namespace swage::bench
