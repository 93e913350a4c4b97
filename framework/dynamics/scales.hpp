// SPDX-License-Identifier: Apache-2.0
//
// Lengths and times of the contact solve, as shares of the scene's characteristic length (scene::World::length): a scene at ten
// times the scale behaves alike.
#pragma once

#include "dynamics/options.hpp"
#include "scene/world.hpp"

namespace swage::dynamics {

struct Scales {
  double converged = 1e-10;   // m, last correction of a solve
  double near = 2e-7;         // m, gap below which a flexible body is asked about a contact from the start
  double soon = 1e-6;         // m, gap below which strands that are wound take part in a solve from the start
  double lost = 1e-4;         // m, displacement in one solve beyond which the solve is repeated with friction limits held
  double retardation = 1e-3;  // s, of surfaces that do not rebound (contact_law.hpp)

  /// For a scene of 1 mm:
  ///   converged  0.1 nm: at 1e6 N/m an error of 0.1 mN
  ///   near       0.2 um: prediction error per step of a needle held by a trembling hand. Smaller: bodies are asked twice more often.
  ///              Larger: they are asked about more points
  ///   soon       1 um: strands of a knot that is drawn at 2 mm/s come nearer by so much in a step. Smaller: more passes, each of which finds
  ///              the next contact. Larger: constraints that bear nothing, and more unknowns
  ///   lost       0.1 mm, a tenth of the scene: nothing that is held or slides goes so far in one step. Smaller: what slides fast
  ///              keeps the friction limits of the step before. Larger: a light body slides out of a wedge without friction
  static Scales of(const scene::World& world, const Options& options) {
    return {options.tolerance * world.length, 2e-4 * world.length, 1e-3 * world.length, 0.1 * world.length, options.retardation};
  }
};

}  // namespace swage::dynamics
