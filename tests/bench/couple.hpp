// SPDX-License-Identifier: Apache-2.0
//
// A light curved needle lies flat in a pinch, and a couple about the normal of the faces grows beyond what their friction bears,
// mu N b / 2. In a step of 1 ms what is left of the couple would turn so light a body many times round: the needle slides as soon as
// the limit is passed, and is not held back step by step by a solve that does not converge. SI units.
#pragma once

#include <cstdint>

namespace swage::bench {

struct WringSetup {
  double wire_radius = 50e-6;  // m; the wire is 2.6 mm long
  double share = 0.25;         // of a circle
  double times = 1.5;          // the largest couple, over the limit
  double dt = 1e-3;            // s
  double density = 7900;       // kg/m3
  bool impulse = false;        // the impulse method of the thesis instead: it has no friction
};

struct WringResult {
  double turned = 0;           // rad, at most
  uint64_t steps = 0;          // under a couple
  uint64_t not_converged = 0;  // of them
};

/// How far the couple at the limit would turn the needle about its centre in one step from rest, were it free [rad].
double free_turn(const WringSetup& setup);

/// Settles for 0.1 s; the couple grows for 0.2 s and stays for 0.2 s.
WringResult wring(const WringSetup& setup);

}  // namespace swage::bench
