// SPDX-License-Identifier: Apache-2.0
//
// Lengths and times of a scene that the contact solve goes by, as shares of its characteristic length (scene::World::length): a
// scene at ten times the scale behaves alike.
#pragma once

#include "scene/world.hpp"

namespace swage::dynamics {

/// Length of a scene over the retardation time of its surfaces [m/s].
inline constexpr double kRetardation = 1;

struct Scales {
  double converged = 1e-10;   // m, last correction of a solve
  double near = 2e-7;         // m, gap below which a flexible body is asked about a contact from the start
  double lost = 1e-4;         // m, displacement of one solve beyond which its friction has let go altogether
  double retardation = 1e-3;  // s, of surfaces that do not rebound (contact_law.hpp)

  /// `tolerance`: share of the length, Options::tolerance. For a scene of 1 mm:
  ///   converged  0.1 nm: at 1e6 N/m an error of 0.1 mN
  ///   near       0.2 um: what a held needle strays in a step in a trembling hand. Smaller: bodies are asked twice more often.
  ///              Larger: they are asked about more points
  ///   lost       0.1 mm, a tenth of the scene: nothing that is held or slides goes so far in one step. Smaller: what slides fast
  ///              keeps the friction limits of the step before. Larger: a light body slides out of a wedge without friction
  /// A mass m on surfaces of stiffness k is critically damped where its retardation time is 2 sqrt(m / k). Of one material
  /// k goes with the length L and m with its cube, so that time goes with L:
  ///   retardation  1 ms: a jaw of 0.25 kg, the heaviest that closes in such a scene, on 1e6 N/m. Shorter: a heavy jaw throws the
  ///                needle that it closes on. Longer: a jaw that opens lets go late
  static Scales of(const scene::World& world, double tolerance) {
    return {tolerance * world.length, 2e-4 * world.length, 0.1 * world.length, world.length / kRetardation};
  }
};

}  // namespace swage::dynamics
