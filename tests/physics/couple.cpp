// SPDX-License-Identifier: Apache-2.0
//
// A couple beyond Coulomb's limit turns a light needle until its longer line of contact holds it, no less and no farther: the quick part
// of S47 of the stability catalogue (tests/bench/couple.hpp). Steps of 0.03 ms say how far; they all converge.
#include "couple.hpp"

#include <gtest/gtest.h>

namespace swage::bench {
namespace {

TEST(Couple, BeyondFrictionTurnsALightNeedleAsFarAsSmallStepsSay) {
  for (const double share : {0.25, 0.375, 0.5, 0.625})
    for (const double times : {1.05, 1.5, 3.0}) {
      WringSetup s;
      s.share = share, s.times = times, s.dt = 3e-5;
      const WringResult fine = wring(s);
      EXPECT_EQ(fine.not_converged, 0u) << share << " " << times;
      EXPECT_GT(fine.turned, 0.2) << share << " " << times;
      s.dt = 1e-3;
      for (const double radius : {25e-6, 35e-6, 50e-6}) {
        s.wire_radius = radius;
        const WringResult slid = wring(s);
        EXPECT_NEAR(slid.turned, fine.turned, 0.02) << radius << " " << share << " " << times;
        EXPECT_EQ(slid.not_converged, 0u) << radius << " " << share << " " << times;
      }
    }
}

TEST(Couple, BelowFrictionDoesNot) {
  for (const double radius : {25e-6, 35e-6, 50e-6})
    for (const double share : {0.25, 0.375, 0.5, 0.625}) {
      WringSetup s;
      s.wire_radius = radius, s.share = share, s.times = 0.95;
      EXPECT_LT(wring(s).turned, 0.02) << radius << " " << share;
    }
}

}  // namespace
}  // namespace swage::bench
