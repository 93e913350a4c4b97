// SPDX-License-Identifier: Apache-2.0
#include "console/models/insertion.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace swage::console {
namespace {

constexpr double kRadius = 50e-6;  // m, of the needle

// a needle that enters at (1, 2, 0) mm of a plane that rises by `slope` along x, and is then dragged on a circle of 30 um in
// that plane, twice in two passes
record::Recording dragged(double slope) {
  record::Recording r;
  r.info.dt = 1e-3;
  for (const char* id : {"pierce.state", "pierce.entries", "pierce.at_x", "pierce.at_y", "pierce.at_z",
                         "pierce.entry_x", "pierce.entry_y", "pierce.entry_z", "pierce.area",
                         "pierce.area_ratio", "pierce.wound", "pierce.cosine"})
    r.info.script.signals.push_back({"pierce", id, "1", ""});
  const double c = 1 / std::hypot(1, slope);
  for (size_t i = 0; i < 400; ++i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i % 200) / 200;
    const double u = 30e-6 * (1 - std::cos(angle)), v = 30e-6 * std::sin(angle);
    r.step.push_back(i);
    r.hash.push_back(0);
    for (const double value :
         {i < 10 ? 1.0 : 2.0, i < 200 ? 1.0 : 2.0, 1e-3 + c * u, 2e-3 + v, c * slope * u, 1e-3, 2e-3, 0.0,
          2 * std::numbers::pi * kRadius * kRadius, 2.0, 2.2, i < 200 ? 0.25 : 0.75})
      r.signal.push_back(static_cast<float>(value));
  }
  return r;
}

TEST(EntryTrack, IsSeenSquareToTheSurfaceWhateverItsSlope) {
  for (const double slope : {0.0, 0.5, -0.8}) {
    const auto track = entry_track(dragged(slope));
    ASSERT_TRUE(track);
    ASSERT_EQ(track->passes.size(), 2);
    EXPECT_NEAR(track->radius_mm, 0.05, 1e-5);
    EXPECT_NEAR(track->wound, 2.2, 1e-6);
    for (const QPolygonF& pass : track->passes) {
      for (const QPointF& p : pass) EXPECT_NEAR(std::hypot(p.x() - 0.03, p.y()), 0.03, 1e-3) << slope;
    }
    // points before the puncture are not part of it
    EXPECT_NEAR(track->time_s[0].first(), 0.011, 1e-9);
  }
}

TEST(EntryTrack, CosineIsThatOfTheTimeInTheTissue) {
  record::Recording r = dragged(0);
  auto track = entry_track(r);
  ASSERT_TRUE(track);
  ASSERT_EQ(track->cosine.size(), 1);
  ASSERT_EQ(track->cosine[0].size(), 390);
  EXPECT_NEAR(track->cosine[0].first().x(), 0.011, 1e-9);
  EXPECT_NEAR(track->mean_cosine, (190 * 0.25 + 200 * 0.75) / 390, 1e-6);
  // outside for a moment: two stays
  r.signal[300 * r.info.script.signals.size()] = 1;
  track = entry_track(r);
  ASSERT_TRUE(track);
  EXPECT_EQ(track->cosine.size(), 2);
}

TEST(EntryTrack, NothingWithoutItsSignalsOrWithoutAnEntry) {
  EXPECT_FALSE(entry_track({}));
  record::Recording r = dragged(0);
  for (size_t i = 0; i < r.step.size(); ++i) r.signal[i * r.info.script.signals.size()] = 1;
  EXPECT_FALSE(entry_track(r));
}

}  // namespace
}  // namespace swage::console
