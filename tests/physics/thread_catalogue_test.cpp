// SPDX-License-Identifier: Apache-2.0
//
// A thread that touches something, in the host's own detector and solver: S24 of the catalogue (tests/stability/README.md).
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>

#include "bench/held_thread.hpp"

namespace swage::bench {
namespace {

using toolkit::Vec3;

/// How far the place of a thread between two jaws creeps under the weight of the thread along itself [m].
double creep(double friction, int steps) {
  HeldThread s(Held::kJaws, 0, 100, friction);
  for (int i = 0; i < 300; ++i) s.step();
  const uint32_t middle = 50;
  const auto place = [&] { return s.rod.state().node(static_cast<int>(middle)); };
  s.world.gravity = {9.80665, 0, 0};
  for (int i = 0; i < 200; ++i) s.step();
  const Vec3 begun = place();
  double most = 0;
  for (int i = 0; i < steps; ++i) {
    s.step();
    most = std::max(most, (place() - begun).norm());
  }
  EXPECT_EQ(s.solve->stats().health.total(), 0u) << friction;
  return most;
}

// S24: 10-0 nylon between two jaws that overlap it by 0.1 um each, its weight along it: as S05, 10 nm. A minute is the soak.
TEST(ThreadCatalogue, S24CaughtBetweenJawsItStays) {
  const int steps = std::getenv("SWAGE_SOAK_THREAD") ? 60000 : 5000;
  const double c = creep(0.2, steps);
  EXPECT_LT(c, 10e-9);
  EXPECT_GT(creep(0, 300), 1e-6) << "without friction it slides out";
}

}  // namespace
}  // namespace swage::bench
