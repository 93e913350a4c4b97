// SPDX-License-Identifier: Apache-2.0
#include "toolkit/math.hpp"

#include <gtest/gtest.h>

namespace swage::toolkit {
namespace {

TEST(Math, TheExponentialTurnsAboutItsAxis) {
  for (const double angle : {1e-9, 1e-5, 0.99e-4, 1.01e-4, 0.5, 3.0}) {
    const Quat q = exp_rotation({0, 0, angle});
    EXPECT_NEAR(q.norm(), 1, 1e-15);
    EXPECT_LT((q * Vec3::UnitX() - Vec3(std::cos(angle), std::sin(angle), 0)).norm(), 1e-15) << angle;
  }
}

TEST(Math, TheLogarithmUndoesIt) {
  for (const double angle : {1e-12, 1e-8, 1e-4, 1.0, 3.14}) {
    const Vec3 a = angle * Vec3(1, -2, 0.5).normalized();
    EXPECT_LT((log_rotation(exp_rotation(a)) - a).norm(), 4e-16 + 1e-15 * angle) << angle;
    // both signs of a quaternion are one rotation
    Quat q = exp_rotation(a);
    q.coeffs() = -q.coeffs();
    EXPECT_LT((log_rotation(q) - a).norm(), 4e-16 + 1e-15 * angle);
  }
  // more than half a turn is less, the other way round
  EXPECT_NEAR(log_rotation(exp_rotation({3.5, 0, 0})).x(), 3.5 - 2 * M_PI, 1e-14);
}

TEST(Math, PosesAndFramesComposeAlike) {
  const Pose X_AB({1, 2, 3}, exp_rotation({0.3, -0.2, 0.9})),
      X_BC({-1, 0.5, 2}, exp_rotation({-1, 0.1, 0.4}));
  const Vec3 p(0.4, -0.7, 0.2);
  EXPECT_LT(((X_AB * X_BC) * p - X_AB * (X_BC * p)).norm(), 1e-15);
  EXPECT_LT((X_AB.inverse() * (X_AB * p) - p).norm(), 1e-15);
  const Frame F_AB(X_AB), F_BC(X_BC);
  EXPECT_LT(((F_AB * F_BC) * p - X_AB * (X_BC * p)).norm(), 1e-15);
  EXPECT_LT((F_AB.inverse_times(F_AB * F_BC) * p - X_BC * p).norm(), 1e-15);
  EXPECT_LT((F_AB.turn_back(F_AB.turn(p)) - p).norm(), 1e-15);
  // and do not commute
  EXPECT_GT(((X_BC * X_AB) * p - X_AB * (X_BC * p)).norm(), 0.1);
}

TEST(Math, TheBoundarysStructsGoThereAndBack) {
  const swage_pose raw_pose{{1, 2, 3}, {0.5, -0.5, 0.5, 0.5}};
  const swage_pose back = Pose(raw_pose).abi();
  EXPECT_EQ(back.p.z, 3);
  EXPECT_EQ(back.q.w, 0.5);
  EXPECT_EQ(back.q.x, -0.5);
  const Vec3 a(1, 2, 3), b(-2, 0.5, 4);
  EXPECT_LT((skew(a) * b - a.cross(b)).norm(), 1e-15);
}

}  // namespace
}  // namespace swage::toolkit
