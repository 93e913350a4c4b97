// SPDX-License-Identifier: Apache-2.0
//
// A step of rigid bodies that did not converge, done again in parts. A couple beyond Coulomb's limit turns a needle of 0.2 mg
// several rad in 1 ms, past all contacts of the step, although a longer line of contact would hold it after 0.1 rad. Within a part
// the rotation is small enough: its contacts are found anew, with the bristles of the part before.
//
// Steps with flexible bodies, particles or ties, or in which something flew (rebound.hpp), are not repeated, only counted.
//
// Threads: built on [main]; the rest [rt], nothing allocates or throws.
#pragma once

#include <cstdint>
#include <vector>

#include "contact/contact_set.hpp"
#include "contact/detector.hpp"
#include "dynamics/contact_solve.hpp"
#include "dynamics/motion.hpp"
#include "dynamics/options.hpp"
#include "scene/world.hpp"

namespace swage::dynamics {

class Refinement {
 public:
  explicit Refinement(const scene::World& world);

  /// Before the contact solve: keeps the state that the solve overwrites and the parts start from. False: no room for it.
  bool keep(const Motion& motion, const contact::ContactSet& contacts, const base::SolverHealth& health) noexcept;
  /// Repeats the step from its start in parts. Contact forces are those of the last part.
  void run(scene::World& world, Motion& motion, contact::ContactSet& contacts, contact::Detector& detector,
           ContactSolve& solve, const Options& options, Stats& stats) noexcept;

 private:
  /// State of a contact from the last step.
  struct Memory {
    Vec3 bristle_W, f_a_W;
  };
  void go_back(scene::World& world, Motion& motion, contact::ContactSet& contacts) const noexcept;
  void follow(scene::World& world, double rest) const noexcept;
  void count(Stats& stats, const base::SolverHealth& whole) const noexcept;

  std::vector<Memory> memory_;
  std::vector<uint64_t> held_body_, held_hinge_;
  base::SolverHealth health_;
  std::vector<swage_pose> X_end_;    // per body: where kinematic ones are at the end of the step
  std::vector<uint8_t> everything_;  // per body, all 1: contacts of every body are detected anew
};

}  // namespace swage::dynamics
