// SPDX-License-Identifier: Apache-2.0
//
// What an arm feels in lesson 110, played by its expert: the reaction of grasp and insertion by the law and the scale of the lesson,
// through the force guard. Every law is compared with its own formula, step by step.
#include <algorithm>
#include <cmath>

#include "arm_in_110.hpp"

namespace swage::session {
namespace {

class ForceLaw : public testing::TestWithParam<host::Reaction> {};

TEST_P(ForceLaw, HoldsInTheInsertionToTwoPercent) {
  ArmIn110 arm(GetParam());
  ASSERT_NE(arm.engine, nullptr);
  ASSERT_GT(arm.scale, 0) << "the lesson gives forces to a hand that takes them";
  Vec3 before = Vec3::Zero();
  double peak = 0, most = 0, jump = 0;
  std::vector<double> error;
  Vec3 given_before = Vec3::Zero();
  while (arm.engine->verdict().outcome == judge::Outcome::kRunning && arm.rig->world.time() < 30) {
    arm.engine->step();
    // what was sent after the last step is given in this one
    const Vec3 given = toolkit::vec(arm.port->force());
    const double f = before.norm();
    const Vec3 wanted = f > 0 ? Vec3(arm.scale * formula(GetParam(), f) / f * before) : Vec3(Vec3::Zero());
    before = arm.scene();
    most = std::max(most, given.norm());
    jump = std::max(jump, (given - given_before).norm() / arm.rig->world.dt);
    given_before = given;
    if (arm.rig->world.time() < 1 || wanted.norm() > 1.7) continue;  // fades in; what the motors do not bear is cut
    peak = std::max(peak, wanted.norm());
    error.push_back((given - wanted).norm());
  }
  EXPECT_EQ(arm.engine->verdict().outcome, judge::Outcome::kPassed);
  EXPECT_LE(most, 3.0 + 1e-12);
  EXPECT_LE(jump, 300 * 1.001);
  EXPECT_EQ(arm.port->fault(), ForceFault::kNone);
  std::sort(error.begin(), error.end());
  const double all_but_a_hundredth = error[error.size() - error.size() / 100 - 1];
  std::printf("scale %g, peak %.3f N, error: median %.4f N, 99 %% %.4f N, greatest %.4f N\n", arm.scale, peak, error[error.size() / 2],
              all_but_a_hundredth, error.back());
  EXPECT_GT(peak, 0.1) << "there is something to feel";
  EXPECT_LT(all_but_a_hundredth, 0.02 * peak) << "a hundredth is left to the slew and to passivity control";
}

INSTANTIATE_TEST_SUITE_P(Laws, ForceLaw,
                         testing::Values(host::Reaction{}, host::Reaction{host::Law::kNullZone, 5e-3, {}},
                                         host::Reaction{host::Law::kThreshold, 5e-3, {}}, host::Reaction{host::Law::kQuadratic, 50e-3, {}},
                                         host::Reaction{host::Law::kTable, 0, {{0, 0}, {0.02, 0.01}, {0.03, 0.03}}}));

}  // namespace
}  // namespace swage::session
