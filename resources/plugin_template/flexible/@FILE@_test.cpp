// SPDX-License-Identifier: Apache-2.0
#include "@FILE@.hpp"

#include <swage/testbed.hpp>

#include <cmath>
#include <cstdio>

int failures = 0;

void check(bool good, const char* what) {
  if (good) return;
  std::printf("FAILED: %s\n", what);
  ++failures;
}

using Bench = swage::testbed::ObjectBench<@NAME@>;

// Puts the chain straight along x, as the host does; n: vertices.
bool start(Bench& bench, size_t n, double length) {
  if (!bench.start(1e-3)) return false;
  for (size_t i = 0; i < n; ++i) bench.state[3 * i] = length * static_cast<double>(i) / static_cast<double>(n - 1);
  return true;
}

void run(Bench& bench, int steps) {
  const auto* solver = bench.get<swage_solver_2>(SWAGE_EXT_SOLVER_2);
  for (int i = 0; i < steps; ++i) check(solver->advance(bench.raw, bench.fill()) == SWAGE_OK, "it advances");
}

int main() {
  // free and undamped, it falls with g
  Bench falls;
  falls.set("fixed", 0);
  falls.set("damping", 0);
  check(start(falls, 31, 30e-3), "it starts");
  falls.step.gravity = {0, 0, -9.81};
  run(falls, 100);
  check(std::abs(falls.state[3 * 31 + 2] + 0.981) < 1e-9, "9.81 m/s2 for 0.1 s");

  // hanging, it is longer by the share rho g l / 2 E; a soft material makes that measurable
  Bench hangs;
  hangs.set("modulus", 1e5);
  check(start(hangs, 31, 30e-3), "it starts");
  hangs.step.gravity = {9.81, 0, 0};
  run(hangs, 3000);
  hangs.finish();
  const double exact = 1100 * 9.81 * 30e-3 / (2 * 1e5);
  check(std::abs(hangs.signal[0] - exact) < 0.002 * exact, "its own weight stretches it");
  check(hangs.state[0] == 0, "the fixed end stays");

  // the extension is offered; `swage validate` tests that mobility() and linearise() agree
  check(hangs.get<swage_band>(SWAGE_EXT_BAND) != nullptr, "it is a band");
  check(hangs.content() && falls.content(), "nothing was reported");
  return failures == 0 ? 0 : 1;
}
