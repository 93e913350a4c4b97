// SPDX-License-Identifier: Apache-2.0
//
// What is measured of a knot and of the hands that tie it: the air below the knot, grasps taken anew, hands that rest.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "lessons/knot/judge.hpp"
#include "lessons/knot/work.hpp"

namespace swage::lesson_knot {
namespace {

/// A stitch as a polyline: tail down to the left hole, half a circle of 1 mm through the tissue, out of the right hole; its legs rise to a
/// throw `high` [m] above the surface, beside the middle by `aside`.
struct LaidStitch {
  double high = 0.5e-3, aside = 0;
  std::vector<Vec3> p;
  std::vector<double> s{0};
  Loop loop;

  LaidStitch(double high_m, double aside_m) : high(high_m), aside(aside_m) {
    constexpr double kHole = 1e-3, kPi = 3.14159265358979323846;
    constexpr int kArc = 400;
    const Vec3 knot(aside, 0, high);
    p = {knot + Vec3(-4e-3, 0, 1e-3), knot, Vec3(kHole, 0, 0)};  // the long end crosses to the left
    for (int i = 1; i <= kArc; ++i) p.push_back(kHole * Vec3(std::cos(kPi * i / kArc), 0, -std::sin(kPi * i / kArc)));
    p.push_back(knot);
    p.push_back(knot + Vec3(4e-3, 0, 1e-3));
    for (size_t i = 1; i < p.size(); ++i) s.push_back(s.back() + (p[i] - p[i - 1]).norm());
    loop = {s[2], s[2 + kArc], s[3 + kArc] - s[1], 44.5e-6, Vec3::UnitZ()};
  }
  Vec3 place(double at) const {
    size_t i = 1;
    while (i + 1 < s.size() && s[i] < at) ++i;
    return p[i - 1] + (at - s[i - 1]) / (s[i] - s[i - 1]) * (p[i] - p[i - 1]);
  }
  double gap() const {
    return air_gap(loop, [this](double at) { return place(at); });
  }
};

TEST(AirGap, IsTheHeightOfAKnotThatIsLaid) {
  constexpr double kThread = 44.5e-6;
  for (const double high : {0.1e-3, 0.3e-3, 1e-3, 2e-3})
    EXPECT_NEAR(LaidStitch(high, 0).gap(), high - kThread, 0.02 * high) << high;
  // off the middle one leg is longer; a place is found to a thirty-second of both
  for (const double aside : {-0.5e-3, 0.3e-3}) EXPECT_NEAR(LaidStitch(1e-3, aside).gap(), 1e-3 - kThread, 0.05e-3) << aside;
}

TEST(AirGap, OfAKnotThatLiesOnIsNone) {
  EXPECT_EQ(LaidStitch(0, 0).gap(), 0);
  EXPECT_EQ(LaidStitch(40e-6, 0).gap(), 0) << "its middle is above the surface by less than a diameter";
  LaidStitch taut(0.5e-3, 0);
  taut.loop.length = taut.loop.entry - taut.loop.exit;  // no thread outside of the tissue
  EXPECT_EQ(taut.gap(), 0);
}

TEST(Work, CountsGraspsAfterTheFirstAndHandsThatRest) {
  WorkState s;
  const auto step = [&](bool has, const Vec3& tip, int n, bool counts = true) {
    for (int i = 0; i < n; ++i)
      for (int hand = 0; hand < 2; ++hand)
        WorkWatch::look(s, hand, has, hand == 0 ? tip : Vec3(tip + 1e-3 * s.idle[1].all_s * Vec3::UnitX()), 0.1, 0.3, 1e-3, counts);
  };
  step(false, Vec3::Zero(), 100);
  step(true, Vec3::Zero(), 1900);
  EXPECT_EQ(WorkWatch::regrasps(s), 0);
  EXPECT_NEAR(WorkWatch::idle(s), 0.5, 0.01) << "one hand rests, the other goes at 1 mm/s";
  step(false, Vec3::Zero(), 1, false);
  step(true, Vec3::Zero(), 1000, false);
  EXPECT_EQ(WorkWatch::regrasps(s), 2);
  EXPECT_NEAR(WorkWatch::idle(s), 0.5, 0.01) << "what does not count changes nothing";
}

}  // namespace
}  // namespace swage::lesson_knot
