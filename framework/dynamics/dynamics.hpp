// SPDX-License-Identifier: Apache-2.0
//
// How things move: free motion, then contacts. One step is
//
//     follow (scene/kinematics.hpp)      kinematic bodies at the end of the step, with the twist that led there
//     forces of the objects              into World::F_B_W, particle_f_W, drive
//     dynamics.free_motion(world)        dynamic bodies, hinges and particles at their predicted poses
//     detect (contact room), couple      contacts at the predicted poses
//     dynamics.solve(world, contacts)    contact forces; final poses and twists
//     dynamics.finish(world)             hinge torques, inputs cleared
//
// Equations and symbols: README.md of this room. Units SI, frame W.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "contact/contact_set.hpp"
#include "dynamics/flexible_body.hpp"
#include "dynamics/options.hpp"
#include "dynamics/tie.hpp"
#include "scene/state_image.hpp"
#include "scene/world.hpp"

namespace swage::contact {
class Detector;
}

namespace swage::dynamics {

struct Waypoint;

/// Moves one scene. Built on [main]; afterwards [rt] alone, nothing allocates or throws.
class Dynamics {
 public:
  /// [main] Reserves everything for this world. Throws std::invalid_argument when a hinge's parent is DYNAMIC
  /// or a dynamic body has no mass.
  Dynamics(const scene::World& world, const Options& options);
  ~Dynamics();
  Dynamics(const Dynamics&) = delete;
  Dynamics& operator=(const Dynamics&) = delete;

  /// [rt] Predicts: writes X_WB, V_WB, particles, hinge angles and rates as if nothing touched anything;
  /// bodies that were held in the last step are predicted to keep their twist, so that contacts are
  /// detected where they will be.
  void free_motion(scene::World& world) noexcept;

  /// [rt] Solves the contacts and writes final poses, twists and the results in `contacts` (bristle, force,
  /// slip) and in `ties`. `self`: the flexible bodies, in the order of their objects; may be empty. `detector`: finds the touches of
  /// bodies that fly fast or rebound within the step (rebound.hpp); without one no body does.
  void solve(scene::World& world, contact::ContactSet& contacts, std::span<FlexibleBody* const> self,
             std::span<Tie> ties = {}, contact::Detector* detector = nullptr) noexcept;

  /// [rt] Writes World::hinge_torque and clears F_B_W and particle_f_W for the next step.
  void finish(scene::World& world) noexcept;

  /// [rt] Sets the health counters back to `before`, because the last step will be repeated.
  void take_back(const base::SolverHealth& before) noexcept;

  /// [main] Number of contacts beyond which an island with threads is solved sparse, not in contact space. For tests of both.
  void solve_sparse_beyond(uint32_t contacts) noexcept;

  const Stats& stats() const noexcept;
  /// Poses of flying bodies within the last step, at each impulse and each new prediction.
  std::span<const Waypoint> waypoints() const noexcept;
  const Options& options() const noexcept;

  /// [rt] What the next step needs beyond the world: which bodies are held.
  void save(scene::Writer& out) const noexcept;
  bool restore(scene::Reader& in) noexcept;

 private:
  struct Core;
  std::unique_ptr<Core> core_;
};

}  // namespace swage::dynamics
