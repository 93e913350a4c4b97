// SPDX-License-Identifier: Apache-2.0
//
// Lengths and times of a scene that the contact solve goes by, as shares of its characteristic length (scene::World::length): a
// scene at ten times the scale behaves alike.
#pragma once

#include "scene/world.hpp"

namespace swage::dynamics {

/// Retardation time of surfaces that do not rebound [s]. At 1e6 N/m it damps a jaw of 0.25 kg critically, the heaviest of a trainer.
/// Shorter: a heavy jaw throws the needle that it closes on. Longer: a jaw that opens lets go late.
inline constexpr double kRetardation = 1e-3;

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
  ///   retardation  a time: it stays what it is where lengths are scaled and times are not (catalogue S01)
  static Scales of(const scene::World& world, double tolerance) {
    return {tolerance * world.length, 2e-4 * world.length, 0.1 * world.length, kRetardation};
  }
};

}  // namespace swage::dynamics
