// SPDX-License-Identifier: Apache-2.0
#include "console/link/snapshot_source.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace swage::console {
namespace {

using snapshot::Snapshot;

// a body that moves along x with 1 m/s
void at(double t, Snapshot& s) {
  s.step = static_cast<uint64_t>(std::llround(t * 1000));
  s.time_s = t;
  s.n_body = 1;
  s.X_WB[0] = {{t, 0, 0}, {1, 0, 0, 0}};
}

TEST(Interpolate, TakesTheShortWayRound) {
  auto a = std::make_unique<Snapshot>(), b = std::make_unique<Snapshot>(), out = std::make_unique<Snapshot>();
  at(0, *a);
  at(1, *b);
  const double half = 0.1;
  b->X_WB[0].q = {-std::cos(half), 0, 0, -std::sin(half)};  // the same rotation as {cos, 0, 0, sin}
  interpolate(*a, *b, 0.5, *out);
  EXPECT_NEAR(out->X_WB[0].p.x, 0.5, 1e-12);
  EXPECT_NEAR(out->X_WB[0].q.w, std::cos(0.5 * half), 1e-6);
  EXPECT_NEAR(out->X_WB[0].q.z, std::sin(0.5 * half), 1e-6);
}

TEST(SnapshotSource, NothingBeforeTheFirst) {
  SnapshotSource source;
  EXPECT_EQ(source.sample(1), nullptr);
}

TEST(SnapshotSource, At1kHzThePictureIsTwoStepsOld) {
  SnapshotSource source;
  auto s = std::make_unique<Snapshot>();
  for (int i = 0; i < 120; ++i) {
    const double wall = i / 60.0;
    at(std::floor(wall * 1000) / 1000, *s);
    source.push(*s, wall);
    const Snapshot* shown = source.sample(wall);
    ASSERT_NE(shown, nullptr);
    if (i > 2) {
      EXPECT_NEAR(shown->X_WB[0].p.x, wall, 0.0032);
    }
  }
}

TEST(SnapshotSource, ASlowSessionIsShownEvenly) {
  SnapshotSource source;
  auto s = std::make_unique<Snapshot>();
  double last = -1;
  for (int i = 0; i < 180; ++i) {
    const double wall = i / 60.0;
    at(std::floor(wall * 15 + 1e-9) / 15, *s);  // a new snapshot every fourth picture
    source.push(*s, wall);
    const double x = source.sample(wall)->X_WB[0].p.x;
    if (i > 60) {
      EXPECT_NEAR(x - last, 1 / 60.0, 0.006) << i;  // without interpolation: 0, 0, 0, 0.067
    }
    last = x;
  }
}

TEST(SnapshotSource, APauseRestsAtTheNewest) {
  SnapshotSource source;
  auto s = std::make_unique<Snapshot>();
  for (int i = 0; i < 10; ++i) {
    at(0.016 * i, *s);
    source.push(*s, 0.016 * i);
  }
  source.push(*s, 5);
  EXPECT_NEAR(source.sample(5)->X_WB[0].p.x, 0.144, 1e-12);
}

}  // namespace
}  // namespace swage::console
