// SPDX-License-Identifier: Apache-2.0
//
// The same scene of one material at s times the size: lengths, times and stiffness grow with s, masses with its cube, speeds and strains stay. Without gravity the motion is the same, to rounding, a heavy ball that lands included: what
// surfaces take from it is no property of the clock.
#include <algorithm>
#include <cmath>

#include "scene.hpp"

namespace swage::physics {
namespace {

/// Heights of a ball over its radius that meets the plate at 20 mm/s and does not rebound, step by step.
std::vector<double> landing(double size) {
  const double radius = 5e-3 * size;
  BallOverPlate s(radius, {0, 1e6 * size, 0});
  s.world.length = 1e-3 * size, s.world.dt = 0.2e-3 * size;
  s.world.gravity = {0, 0, 0};
  s.world.X_WB[0].p.z = radius * (1 + 1e-3);
  s.world.V_WB[0].v = {0, 0, -0.02};
  std::vector<double> out;
  for (int i = 0; i < 200; ++i) {
    s.step();
    out.push_back(s.height() / radius);
  }
  return out;
}

TEST(Scale, AHeavyBallLandsAlikeAtEverySize) {
  const std::vector<double> once = landing(1);
  const double deepest = *std::min_element(once.begin(), once.end());
  EXPECT_LT(deepest, -1e-5) << "it was pressed in";
  for (const double size : {0.1, 10.0}) {
    const std::vector<double> scaled = landing(size);
    for (size_t i = 0; i < once.size(); ++i) EXPECT_NEAR(scaled[i], once[i], 1e-8) << size << " step " << i;
  }
}

}  // namespace
}  // namespace swage::physics
