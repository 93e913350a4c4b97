// SPDX-License-Identifier: Apache-2.0
#include "dynamics/hinge_drive.hpp"

#include <gtest/gtest.h>

namespace swage::dynamics {
namespace hinge_drive_test {

scene::HingeInfo jaw() {
  scene::HingeInfo info;
  info.inertia = 3.2e-7;
  info.min = -0.1, info.max = 0.2;
  return info;
}
constexpr double kStep = 1e-3;

TEST(HingeDrive, FreeMotionBalancesInertiaAndTorque) {
  // inside the limit, on either side of it, and without a drive
  for (const swage_drive& d : {swage_drive{0.1, 1e-3, 1e-6, 1.0}, swage_drive{0.1, 1.0, 1e-4, 1e-3},
                               swage_drive{-0.05, 1.0, 1e-4, 1e-3}, swage_drive{}}) {
    const HingeDrive drive(jaw(), d, 0.01, 0.5, 1e-5, kStep);
    const double x = drive.free();
    EXPECT_NEAR(drive.inertia_hh * (x - drive.x_hat), drive.torque(x), 1e-15);
    EXPECT_LE(std::abs(drive.torque(x)), d.max_torque);
  }
}

TEST(HingeDrive, FreeMotionEndsAtTheStops) {
  const HingeDrive drive(jaw(), {1.0, 10, 0, 1.0}, 0.19, 0, 0, kStep);
  EXPECT_DOUBLE_EQ(0.19 + drive.free(), 0.2);
  const HingeDrive back(jaw(), {-1.0, 10, 0, 1.0}, -0.09, 0, 0, kStep);
  EXPECT_DOUBLE_EQ(-0.09 + back.free(), -0.1);
}

}  // namespace hinge_drive_test
}  // namespace swage::dynamics
