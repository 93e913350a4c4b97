// SPDX-License-Identifier: Apache-2.0
//
// What an arm feels in lesson 110, played by its expert: the reaction of grasp and insertion by the law and the scale of the lesson,
// through the force guard. Every law is compared with its own formula, step by step.
#include <algorithm>
#include <cmath>
#include <stdexcept>

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

// Lesson 055: a hand that carries the ring feels its weight and little else while it is clear, and each touch of wire and posts; a spring to
// the tool holds it back where a fixed solid stops that.
TEST(ForceOfTheRing, TouchesAreFeltAndTheSpringIsThere) {
  ArmIn110 arm({}, "055_ring_on_hoop", "clumsy");
  ASSERT_NE(arm.engine, nullptr);
  ASSERT_GT(arm.scale, 0);
  const auto of = [&](const char* name) -> const host::ObjectSlot& {
    for (const host::ObjectSlot& o : arm.rig->objects)
      if (o.instance->name == name) return o;
    throw std::runtime_error(name);
  };
  const auto in = [](const host::ObjectSlot& o, uint32_t body) { return body >= o.body.first && body < o.body.first + o.body.count; };
  const host::ObjectSlot &ring = of("ring"), &tool = of("holder");
  double clear = 0, touched = 0, stiffness = 0;
  int held = 0, touches = 0, since = 0;  // ms; since the last touch
  while (arm.engine->verdict().outcome == judge::Outcome::kRunning && arm.rig->world.time() < 60) {
    arm.engine->step();
    double outside = 0, grip = 0;  // N, on ring and jaws by wire, posts and tray; between the two
    for (const contact::Contact& c : arm.engine->contacts().contact) {
      const bool ours_a = in(ring, c.body_a) || in(tool, c.body_a), ours_b = in(ring, c.body_b) || in(tool, c.body_b);
      (ours_a && ours_b ? grip : outside) += c.f_a_W.norm();
    }
    if (grip < 0.05 || arm.rig->world.time() < 1) continue;
    const double given = toolkit::vec(arm.port->force()).norm();
    ++held, touches += outside > 1e-3;
    since = outside > 1e-3 ? 0 : since + 1;
    if (since == 0) touched = std::max(touched, given);
    if (since > 100) clear = std::max(clear, given);  // a force that was large falls by its slew
    stiffness = std::max(stiffness, ArmIn110::given().stiffness);
  }
  std::printf("held for %d ms, touching for %d ms; the hand is given up to %.3f N while clear, %.3f N while touching\n", held, touches, clear, touched);
  EXPECT_GT(held, 1000);
  EXPECT_GT(touches, 20);
  EXPECT_GT(touched, 2 * clear);
  EXPECT_LE(touched, 3.0 + 1e-12);
  EXPECT_NEAR(stiffness, 200, 1e-9);
}

}  // namespace
}  // namespace swage::session
