// SPDX-License-Identifier: Apache-2.0
//
// Results of the free motion that the contact solve needs. Reserved on [main], rewritten every step on [rt]; only `held_*` and
// `stiffer` last from step to step.
#pragma once

#include <cstdint>
#include <vector>

#include "dynamics/free_motion.hpp"
#include "dynamics/hinge_drive.hpp"
#include "scene/world.hpp"
#include "toolkit/math.hpp"

namespace swage::dynamics {

using toolkit::Pose;

struct Motion {
  // bodies; X_free and V_free of DYNAMIC ones only
  std::vector<RigidMass> mass;
  std::vector<Pose> X0;      // at the start of the step
  std::vector<Pose> X_free;  // at its end, if nothing touched
  std::vector<Vec3> v_free, w_free;
  std::vector<Vec3> v0, w0;  // m/s, rad/s at the start
  // hinges
  std::vector<double> q0, q_free;  // rad
  std::vector<double> rate0;       // rad/s
  std::vector<HingeDrive> drive;
  // particles
  std::vector<Vec3> p0, p_free, v_free_p;

  // which bodies, hinges, particles had a contact force in the last step: they are predicted to keep their velocity
  std::vector<uint64_t> held_body, held_hinge, held_particle;

  // of each chain: how stiff its matrix had to be made in the last step (banded_body.hpp)
  std::vector<uint64_t> stiffer;

  // which bodies had an impulse within this step before the contact solve (rebound.hpp): X0 is then not their pose at its start
  std::vector<uint8_t> flown;

  explicit Motion(const scene::World& world);
  /// Predicts all of the above and writes the predicted poses to the world. [rt]
  void predict(scene::World& world, FreeMotion method) noexcept;
  /// For a step without contacts: bodies predicted as held get their free motion. [rt]
  void go_free(scene::World& world) noexcept;

 private:
  void predict_body(scene::World& world, uint32_t body, FreeMotion method) noexcept;
  void predict_hinge(scene::World& world, uint32_t hinge) noexcept;
  void predict_particle(scene::World& world, uint32_t particle) noexcept;
};

/// Sets the angle of a hinge, its rate over the step, and pose and twist of its child. [rt]
void place_hinge(scene::World& world, const Motion& motion, uint32_t hinge, double angle) noexcept;

}  // namespace swage::dynamics
