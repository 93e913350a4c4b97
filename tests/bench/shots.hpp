// SPDX-License-Identifier: Apache-2.0
//
// Needles shot at thin things, from every side, spinning: what gets through, what sticks, what comes back faster. The judge of
// a shot looks at centre lines alone, by small steps along what moved, and shares no code with the rooms under test. SI units.
#pragma once

#include <cstdint>
#include <string>

namespace swage::bench {

/// What is shot at. Rods and the other needle are as thick as the needle.
enum class Target {
  kPlate,      // 8 mm square, at rest
  kRod,        // 20 mm long, at rest
  kMovingRod,  // the rod moves, the needle only spins
  kNeedle,     // another needle, free, at rest
};

struct ShotSetup {
  Target target = Target::kPlate;
  double size = 0.1e-3;    // m, thickness of the plate
  double speed = 1;        // m/s
  double restitution = 0;
  double friction = 0.3;
  double dt = 1e-3;        // s
  bool swept = true;       // false: everything is looked for at the end of the step alone
};

struct ShotCounts {
  int shots = 0, hit = 0;
  int passed = 0;    // a centre line went through the middle of the target
  int stuck = 0;     // still deeper than a quarter of the wire at the end, or the solver did not converge in the last steps
  int gained = 0;    // more energy than before, seen from the target
  double most = 0;   // largest energy over that at the start
  std::string first; // the first shot that failed, by number

  int failed() const { return passed + stuck + gained; }
  ShotCounts& operator+=(const ShotCounts& other);
};

/// Shots `first` to `first + count`: direction, attitude, place that is aimed at, phase of the step and spin (0 to 300 rad/s)
/// follow from the number alone.
ShotCounts shoot(const ShotSetup& setup, int first, int count);

}  // namespace swage::bench
