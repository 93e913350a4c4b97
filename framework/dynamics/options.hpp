// SPDX-License-Identifier: Apache-2.0
//
// Choices of a scene for motion and contact, and what the solver reports about itself.
#pragma once

#include <cstdint>

#include "base/solver_health.hpp"

namespace swage::dynamics {

/// How a body moves while nothing touches it. Figures and reasons: README.md.
enum class FreeMotion : uint8_t {
  kThesis,           // explicit Euler of thesis 4.1: attitude by one tangent step, angular momentum kept in W
  kSymplecticEuler,  // momentum first, then attitude by the exponential: order 1
  kRungeKutta4,      // classical order 4 on Euler's equations and the quaternion
  kSplitting2,  // symmetric splitting into exact rotations: order 2, |L| exact, energy bounded for all times
  kSplitting4,  // its composition of order 4
  kTaylor,      // Taylor series of Euler's equations (order 8) and Magnus series of the attitude (order 5)
  kElliptic,  // Jacobi's closed form: energy and angular momentum exact for any step, angle about it to order 6
};

/// What happens where bodies touch.
enum class Response : uint8_t {
  kCompliant,  // compliant contacts with Coulomb friction, implicit at the end of the step
  kImpulse,    // impulse response of thesis 4.3, frictionless, contact by contact; for comparison
};

/// Budget of a step in multiply-adds, about 25 ms of one core: ten times what the stock scenes need at most. Less: hard steps end early.
/// More: a scene that is too large delays the loop longer before it is reported.
inline constexpr uint64_t kBudget = 100'000'000;

/// Retardation time of surfaces that do not rebound [s]: T = 2 sqrt(m / k) damps critically (the body leaves at exp(-2) of its speed),
/// and 1 ms does so for a jaw of 0.25 kg at 1e6 N/m, the heaviest of a trainer at its usual stiffness. Shorter: a heavy jaw throws the
/// needle that it closes on. Longer: a jaw that opens lets go late. A property of the surfaces: unchanged where lengths are scaled and
/// times are not (catalogue S01), proportional to the length where a material is scaled with its times (physics.rigid Scale).
inline constexpr double kRetardation = 1e-3;

struct Options {
  FreeMotion free_motion = FreeMotion::kElliptic;
  Response response = Response::kCompliant;
  uint64_t budget = kBudget;  // work of the contact solve per step, in multiply-adds
  double retardation = kRetardation;  // s, of surfaces that do not rebound, 0 to 10 ms
  double tolerance = 1e-7;            // converged when the last correction is below tolerance * World::length: 0.1 nm
};

/// What the solver did since it was made. A step that did not converge shows here.
struct Stats {
  uint64_t steps = 0;
  uint64_t islands = 0;      // solved
  uint64_t newton = 0;       // Newton steps, all islands
  uint64_t refreshed = 0;    // times the geometry was evaluated anew at trial poses
  uint64_t fallbacks = 0;    // islands where Newton stalled and the convex path took over
  uint64_t rounds = 0;       // convex problems solved there
  uint64_t asked_again = 0;  // steps in which flexible bodies were asked about all their contacts after all
  uint64_t work = 0;         // multiply-adds of all steps, and of the step that took most
  uint64_t most_work = 0;
  double strayed = 0;         // radii, of the last step: largest prediction error of a chain at its contacts (contact_results.cpp)
  base::SolverHealth health;  // shortfalls of the solver
};

}  // namespace swage::dynamics
