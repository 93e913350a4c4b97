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
  swage::testbed::DeviceBench<@NAME@> bench;
  bench.set("radius", 10e-3);
  bench.set("period", 4);
  check(bench.start(), "it starts");

  bench.exchange(1);  // a quarter of a turn
  check(std::abs(bench.sample.pose.p.x) < 1e-15, "it has come round to x = 0");
  check(std::abs(bench.sample.pose.p.y - 10e-3) < 1e-15, "and stands at the top");
  check(std::abs(bench.sample.closure - 0.5) < 1e-15, "half closed");

  const uint64_t before = bench.sample.sequence;
  bench.exchange(1.001);
  check(bench.sample.sequence == before + 1, "each sample is counted");
  check(bench.content(), "nothing was reported");
  return failures == 0 ? 0 : 1;
}
