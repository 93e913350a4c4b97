// SPDX-License-Identifier: Apache-2.0
//
// Our two queries of needle against both jaws, at a pose and over a motion, as the detector asks them.
#pragma once

#include "contact/sweep.hpp"
#include "solids.hpp"
#include "timing.hpp"
#include "trajectory.hpp"

namespace swage::bench {

struct BothJaws {
  contact::Solid needle, jaws[2];
  contact::Separation memory[2];
  contact::Manifold found;
  contact::Query query;
  double unit;

  explicit BothJaws(const Needle& n = {}, double unit_per_m = 1)
      : needle(contact_solid(n, unit_per_m)),
        jaws{contact_solid(jaw(1), unit_per_m), contact_solid(jaw(-1), unit_per_m)},
        unit(unit_per_m) {
    query.length = 1e-3 * unit;
  }

  /// Contact points with one jaw, in `found`.
  int collide(const TrajectoryPose& p, size_t k) { return collide(p, needle_frame(p), k); }
  /// The same with the needle's frame made once for both jaws.
  contact::Frame needle_frame(const TrajectoryPose& p) const {
    return contact::Frame(unit == 1 ? p.X_WN : scaled(p.X_WN, unit));
  }
  int collide(const TrajectoryPose& p, const contact::Frame& X_WN, size_t k) {
    const contact::Frame X_WJ(unit == 1 ? p.X_WJ[k] : scaled(p.X_WJ[k], unit));
    return contact::collide(needle, X_WN, jaws[k], X_WJ, query, memory[k], found);
  }
  /// When the needle, moving by `way` and `turn` from its pose, first touches one jaw; share of the step.
  double first_touch(const TrajectoryPose& p, const Vec3& way, const Vec3& turn, size_t k) {
    constexpr double kTouch = 1e-6;  // m, the detector's for this scene
    return contact::first_touch(needle, {p.X_WN, way, turn}, jaws[k], {p.X_WJ[k]}, kTouch, memory[k], found)
        .t;
  }
};

}  // namespace swage::bench
