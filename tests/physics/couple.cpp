// SPDX-License-Identifier: Apache-2.0
//
// A couple beyond Coulomb's limit turns a light needle at once: the quick part of S47 of the stability catalogue (tests/bench/couple.hpp).
#include "couple.hpp"

#include <gtest/gtest.h>

namespace swage::bench {
namespace {

TEST(Couple, BeyondFrictionTurnsALightNeedleAtOnce) {
  for (const double radius : {25e-6, 35e-6, 50e-6})
    for (const double share : {0.25, 0.375, 0.5, 0.625}) {
      WringSetup s;
      s.wire_radius = radius, s.share = share, s.times = 0.9;
      EXPECT_LT(wring(s).turned, 0.02) << radius << " " << share;
      for (const double times : {1.05, 1.5, 3.0}) {
        s.times = times;
        const WringResult slid = wring(s);
        EXPECT_GT(slid.turned, 0.5) << radius << " " << share << " " << times;
        EXPECT_LT(slid.not_converged, 6u) << radius << " " << share << " " << times;
      }
    }
}

}  // namespace
}  // namespace swage::bench
