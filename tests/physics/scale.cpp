// SPDX-License-Identifier: Apache-2.0
//
// The same scene of one material at s times the size: lengths, times and stiffness grow with s, masses with its cube, speeds and
// strains stay. Without gravity the motion is the same to rounding, a heavy ball that lands included, when the surfaces' retardation
// time grows with s as every other time does.
#include <algorithm>
#include <cmath>

#include "scene.hpp"

namespace swage::physics {
namespace scale_test {

constexpr double kStiffness = 1e4;  // N/m: the ball of 4 g swings on it for 4 ms, twenty steps

/// Heights of a ball over its radius that meets the plate at 20 mm/s and does not rebound, step by step.
std::vector<double> landing(double size, double retardation_s, double dt = 0.2e-3, int steps = 200) {
  const double radius = 5e-3 * size;
  dynamics::Options options;
  options.retardation = retardation_s;
  BallOverPlate s(radius, {0, kStiffness * size, 0}, 0, options);
  s.world.length = 1e-3 * size, s.world.dt = dt * size;
  s.world.gravity = {0, 0, 0};
  s.world.X_WB[0].p.z = radius * (1 + 1e-3);
  s.world.V_WB[0].v = {0, 0, -0.02};
  std::vector<double> out;
  for (int i = 0; i < steps; ++i) {
    s.step();
    out.push_back(s.height() / radius);
  }
  return out;
}

double furthest_apart(const std::vector<double>& a, const std::vector<double>& b) {
  double most = 0;
  for (size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
  return most;
}

TEST(Scale, AHeavyBallLandsAlikeAtEverySizeOfOneMaterial) {
  const std::vector<double> once = landing(1, dynamics::kRetardation);
  EXPECT_LT(*std::min_element(once.begin(), once.end()), -5e-4) << "it was pressed in";
  for (const double size : {0.1, 10.0}) {
    EXPECT_LT(furthest_apart(once, landing(size, size * dynamics::kRetardation)), 1e-6) << size;
    EXPECT_GT(furthest_apart(once, landing(size, dynamics::kRetardation)), 1e-4) << size << ": another material";
  }
}

// A mass m that meets a surface k (d + T d') which only pushes leaves at e times its speed, with zeta = T / (2 sqrt(m / k)):
// e = exp(-2 zeta / w atan(w / zeta)), w = sqrt(1 - zeta^2); exp(-2) where it is damped critically. Schwager, Poeschel: Coefficient of
// restitution and linear-dashpot model revisited, Granular Matter 9 (2007).
TEST(Scale, TheRetardationTimeSaysHowFastAHeavyBallLeaves) {
  const BallOverPlate probe(5e-3, {0, kStiffness, 0});
  const double critical = 2 * std::sqrt(probe.world.body[0].mass / kStiffness);
  for (const double zeta : {0.25, 0.5, 0.999999}) {
    const double w = std::sqrt(1 - zeta * zeta), e = std::exp(-2 * zeta / w * std::atan(w / zeta));
    const std::vector<double> heights = landing(1, zeta * critical, 2e-6, 10000);
    const double left = (heights.back() - heights[heights.size() - 2]) * 5e-3 / 2e-6;
    EXPECT_NEAR(left / 0.02, e, 0.02 * e) << zeta;
  }
}

}  // namespace scale_test
}  // namespace swage::physics
