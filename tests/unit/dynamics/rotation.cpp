// SPDX-License-Identifier: Apache-2.0
#include "dynamics/rotation.hpp"

#include <gtest/gtest.h>

namespace swage::dynamics {
namespace rotation_test {

TEST(Rotation, CircleIsSineAndCosine) {
  for (const double a : {0.0, 1e-9, 1e-3, 0.2, 0.25, 0.2501, 1.0, 3.0, 30.0, 1000.0}) {
    double c, s;
    circle(a * a, c, s);
    const double rounding = 1e-15 * (1 + a);
    EXPECT_NEAR(c, std::cos(a), rounding) << a;
    EXPECT_NEAR(s * a, std::sin(a), rounding) << a;
  }
  double c, s;
  circle(INFINITY, c, s);  // non-finite input terminates, too
}

TEST(Rotation, LogUndoesExp) {
  const Vec3 axis = Vec3(1, -2, 0.5).normalized();
  for (const double angle : {0.0, 1e-10, 1e-4, 0.05, 0.0999, 0.1001, 1.0, 3.0}) {
    const Vec3 a = angle * axis;
    EXPECT_LT((rotation_vector(turn(a)) - a).norm(), 2e-15 * (1 + angle)) << angle;
    EXPECT_LT((turn(a).coeffs() - toolkit::exp_rotation(a).coeffs()).norm(), 1e-15);
  }
}

TEST(Rotation, CarriedKeepsItsLength) {
  const Vec3 v(1e-7, 2e-7, -3e-7);
  const Vec3 a(0.01, -0.02, 0.005);
  EXPECT_NEAR(carried(v, a).norm(), v.norm(), 1e-22);
  EXPECT_LT((carried(v, a) - turn(a) * v).norm(), a.squaredNorm() * a.norm() * v.norm());
  EXPECT_EQ(carried(Vec3::Zero(), a).norm(), 0);
}

}  // namespace rotation_test
}  // namespace swage::dynamics
