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

int main() {
  swage::testbed::ObjectBench<@NAME@> bench;
  check(bench.start(), "it starts");

  bench.forces();
  check(bench.wrench[0].f.x == 0, "no pull at rest");

  bench.pose[0].p.x += 1e-3;
  bench.forces();
  check(bench.wrench[0].f.x < 0 && bench.wrench[0].f.y == 0, "it pulls back");

  bench.finish();
  check(std::abs(bench.signal[0] - 1e-3) < 1e-15, "the stretch is told");

  bench.draw();
  check(bench.drawn.size() == 1 && bench.drawn[0].b.x == bench.pose[0].p.x, "the spring is drawn to the ball");
  check(bench.content(), "nothing was reported");

  // the stiffest spring on the lightest ball: one step brings it closer and not past the middle
  swage::testbed::ObjectBench<@NAME@> stiff;
  stiff.set("stiffness", 1e3);
  stiff.set("mass", 1e-9);
  check(stiff.start(1e-3), "it starts");
  stiff.pose[0].p.x += 1e-3;
  stiff.forces();
  const double x = 1e-3 + 1e-3 * (1e-3 * stiff.wrench[0].f.x / 1e-9);
  check(x >= 0 && x < 1e-3, "no overshoot");
  return failures == 0 ? 0 : 1;
}
