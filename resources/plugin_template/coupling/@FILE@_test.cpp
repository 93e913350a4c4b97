// SPDX-License-Identifier: Apache-2.0
#include "@FILE@.hpp"

#include <swage/testbed.hpp>

#include <cstdio>

int failures = 0;

void check(bool good, const char* what) {
  if (good) return;
  std::printf("FAILED: %s\n", what);
  ++failures;
}

int main() {
  swage::testbed::CouplingBench<@NAME@> bench;
  bench.set("friction", 0.7);
  check(bench.start(nullptr, nullptr), "it starts");

  bench.contacts.resize(2);
  bench.resolve();
  check(bench.contacts[1].friction == 0.7, "every contact gets the friction");

  bench.contacts[0].n_W = {0, 0, 1};
  bench.contacts[0].f_a_W = {0.1, 0, 0.25};
  bench.finish();
  check(bench.signal[0] == 0.25, "only the normal force counts");
  check(bench.events.size() == 1, "they began to touch");

  bench.contacts.clear();
  bench.finish();
  check(bench.events.size() == 2 && bench.signal[0] == 0, "they ended to touch");
  check(bench.content(), "nothing was reported");
  return failures == 0 ? 0 : 1;
}
