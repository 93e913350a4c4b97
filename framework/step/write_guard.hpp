// SPDX-License-Identifier: Apache-2.0
//
// Plugins see arrays of the whole scene. Poses and velocities change only in calls of a solver: after every other
// call they are compared with a copy and restored, and a plugin that wrote is quarantined. About 30 ns a call for twenty bodies.
#pragma once

#include <vector>

#include "host/guard.hpp"
#include "scene/world.hpp"

namespace swage::step {

class WriteGuard {
 public:
  explicit WriteGuard(scene::World& world) : world_(world) { take(); }

  /// Copies poses and velocities, before a phase in which plugins only read them. [rt]
  void take() noexcept;
  /// Compares and restores them after a call of `instance`. [rt]
  void check(host::Instance& instance, host::Call call) noexcept;

 private:
  scene::World& world_;
  std::vector<swage_pose> X_WB_;
  std::vector<swage_twist> V_WB_;
  std::vector<double> particle_p_W_, particle_v_W_, hinge_angle_, hinge_rate_;
};

}  // namespace swage::step
