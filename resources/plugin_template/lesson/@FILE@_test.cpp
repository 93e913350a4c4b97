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
  swage::testbed::LessonBench<@NAME@> bench;
  bench.objects = {"table", "ball"};
  bench.set("target", 0, 0, 2e-3);
  bench.set("hold_time", 0.01);
  check(bench.start(), "it starts");

  bench.observe();
  check(!bench.finished && bench.cue[1] == 1, "away from the target");
  check(std::abs(bench.metric[1] - 2e-3) < 1e-15, "2 mm away");

  bench.pose[1] = swage::at(0, 0, 2e-3);
  bench.observe();
  check(!bench.finished && bench.cue[1] == 0, "there, not yet for long enough");
  for (int i = 0; i < 10; ++i) bench.observe();
  check(bench.finished && bench.passed, "passed");

  swage::testbed::LessonBench<@NAME@> late;
  late.objects = {"ball"};
  late.set("target", 1, 0, 0);
  check(late.start(), "it starts");
  late.time_s = 100;
  late.observe();
  check(late.finished && !late.passed && late.reason == 0, "out of time");

  swage::testbed::LessonBench<@NAME@> lost;
  check(!lost.start() && lost.errors.size() == 1, "a scene without the object is refused");
  check(bench.content() && late.content(), "nothing was reported");
  return failures == 0 ? 0 : 1;
}
