// SPDX-License-Identifier: Apache-2.0
#include "step/couplings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "fake_scene.hpp"

namespace swage::step {
namespace {

// the tool comes up against the ball at 10 mm/s: after 400 steps they touch
void push_up(FakeScene& s) {
  s.device_.exchange = [](const swage_command* c, swage_sample* out) {
    out->pose = {{0, 0, std::min(4.2e-3, 0.01 * c->time_s)}, {1, 0, 0, 0}};
    out->valid = SWAGE_VALID_POSE;
    return swage_result{SWAGE_OK};
  };
}

constexpr int kTouch = 400;

TEST(Couplings, SeeTheContactFromTheirOwnSide) {
  for (const bool exchanged : {false, true}) {
    FakeScene s;
    push_up(s);
    if (exchanged) std::swap(s.rig.couplings[0].object_a, s.rig.couplings[0].object_b);
    double force = 0, normal = 0;
    s.coupling_.coupling_finish = [&](const swage_coupling_step* step) {
      for (uint32_t i = 0; i < step->n_contact; ++i) {
        force += step->contact[i].f_a_W.z;
        normal = step->contact[i].n_W.z;
        EXPECT_EQ(step->contact[i].body_a, 0u);
        EXPECT_EQ(step->contact[i].body_b, 0u);
      }
      return swage_result{SWAGE_OK};
    };
    s.run(kTouch + 20);
    // the ball is pushed up, the tool is pushed down; n points from b into a
    EXPECT_NEAR(normal, exchanged ? 1 : -1, 1e-9);
    EXPECT_LT(exchanged ? -force : force, 0);
    EXPECT_GT(s.ball().p.z, 5e-3);
  }
}

TEST(Couplings, SeeLastStepsForceWhileTheyResolve) {
  FakeScene s;
  push_up(s);
  double last = 0;
  int compared = 0;
  s.coupling_.resolve = [&](const swage_coupling_step* step) {
    if (step->n_contact == 1 && last != 0) {
      EXPECT_EQ(step->contact[0].f_a_W.z, last);
      ++compared;
    }
    return swage_result{SWAGE_OK};
  };
  s.coupling_.coupling_finish = [&](const swage_coupling_step* step) {
    last = step->n_contact == 1 ? step->contact[0].f_a_W.z : 0;
    return swage_result{SWAGE_OK};
  };
  s.ball_.forces = [](const swage_object_step* step) {
    step->F_B_W[0].f.z = -1e-4;  // keeps it on the tool
    return swage_result{SWAGE_OK};
  };
  s.run(kTouch + 100);
  EXPECT_GT(compared, 10);
}

// the law is the coupling's: a stiffness a hundred times smaller lets the ball sink in a hundred times deeper
TEST(Couplings, ChangeTheLaw) {
  double depth[2] = {0, 0};
  for (int soft = 0; soft < 2; ++soft) {
    FakeScene s;
    push_up(s);
    s.coupling_.resolve = [soft](const swage_coupling_step* step) {
      for (uint32_t i = 0; i < step->n_contact; ++i) step->contact[i].stiffness = soft ? 10 : 1000;
      return swage_result{SWAGE_OK};
    };
    s.ball_.forces = [](const swage_object_step* step) {
      step->F_B_W[0].f.z = -1e-4;
      return swage_result{SWAGE_OK};
    };
    s.run(1500);
    depth[soft] = 1e-3 - (s.ball().p.z - s.tool().p.z);
  }
  EXPECT_NEAR(depth[0], 1e-4 / 1000, 1e-9);
  EXPECT_NEAR(depth[1], 1e-4 / 10, 1e-8);
}

TEST(Couplings, ALawWithoutSenseCostsTheCoupling) {
  for (int fault = 0; fault < 4; ++fault) {
    FakeScene s;
    push_up(s);
    s.coupling_.resolve = [fault](const swage_coupling_step* step) {
      if (step->n_contact == 0) return swage_result{SWAGE_OK};
      swage_contact& c = step->contact[0];
      if (fault == 0) c.friction = -0.1;
      if (fault == 1) c.stiffness = std::numeric_limits<double>::quiet_NaN();
      if (fault == 2) c.stiffness = -1;
      if (fault == 3) c.restitution = 1.5;
      return swage_result{SWAGE_OK};
    };
    s.run(kTouch + 20);
    EXPECT_EQ(s.rig.couplings[0].instance->fault_call.load(), host::Call::kResolve) << fault;
  }
}

// in quarantine a coupling holds nothing: the tool goes through the ball
TEST(Couplings, AreReleasedInQuarantine) {
  for (int who = 0; who < 3; ++who) {
    FakeScene s;
    push_up(s);
    const auto fail = [](const auto*) { return swage_result{SWAGE_ERROR}; };
    if (who == 0) s.coupling_.resolve = fail;
    if (who == 1) s.ball_.forces = fail;
    if (who == 2) s.tool_.finish = fail;
    s.run(kTouch + 50);
    EXPECT_EQ(s.ball().p.z, 5e-3) << who;
    EXPECT_TRUE(s.engine().contacts().contact.empty()) << who;
    EXPECT_EQ(s.engine().quarantined(), 1u);
  }
  FakeScene healthy;
  push_up(healthy);
  healthy.run(kTouch + 50);
  EXPECT_GT(healthy.ball().p.z, 5e-3);
}

// what a coupling has for the eye: in every snapshot, for the left hand mirrored, and nothing of it when a number has no sense
TEST(Couplings, ShowTornPlacesAndWhereTheyLead) {
  static swage_tear torn;
  static swage_wound leads;
  torn = {{1e-3, 0, 0}, {2e-3, 0, 0}, {0, 0, 1}, 5e-5, 3, 0};
  leads = {{2e-3, 0, 0}, {0.6, 0, -0.8}, 4e-4, 1e-7, 3, 1};
  static constexpr swage_tears tears{
      [](swage_instance*, const swage_coupling_step*, uint32_t capacity, swage_tear* out, uint32_t* n) {
        for (*n = 0; *n < std::min(capacity, 1u); ++*n) out[*n] = torn;
        return swage_result{SWAGE_OK};
      }};
  static constexpr swage_wounds wounds{
      [](swage_instance*, const swage_coupling_step*, uint32_t capacity, swage_wound* out, uint32_t* n) {
        for (*n = 0; *n < std::min(capacity, 1u); ++*n) out[*n] = leads;
        return swage_result{SWAGE_OK};
      }};
  FakeScene s;
  s.rig.couplings[0].tears = &tears;
  s.rig.couplings[0].wounds = &wounds;
  const auto shot = std::make_unique<snapshot::Snapshot>();
  for (const bool mirror : {false, true}) {
    s.rig.mirror = mirror;
    s.engine().fill(*shot);
    ASSERT_EQ(shot->n_tear, 1u);
    ASSERT_EQ(shot->n_wound, 1u);
    const snapshot::WoundMark& mark = shot->wound[0];
    EXPECT_EQ(mark.object, s.rig.couplings[0].object_b);
    EXPECT_EQ(mark.wound.wound, shot->tear[0].tear.wound);
    EXPECT_EQ(mark.wound.filled, 1u);
    EXPECT_EQ(mark.wound.p_W.x, mirror ? -2e-3 : 2e-3);
    EXPECT_EQ(mark.wound.inward_W.x, mirror ? -0.6 : 0.6);
    EXPECT_EQ(shot->tear[0].tear.b_W.x, mark.wound.p_W.x);
  }
  leads.depth = std::numeric_limits<double>::quiet_NaN();
  s.engine().fill(*shot);
  EXPECT_EQ(shot->n_wound, 0u);
  EXPECT_EQ(shot->n_tear, 1u);
  torn.normal_W.z = std::numeric_limits<double>::infinity();
  s.engine().fill(*shot);
  EXPECT_EQ(shot->n_tear, 0u);
}

TEST(Couplings, TellEventsOfTheirOwn) {
  FakeScene s;
  s.coupling_.coupling_finish = [](const swage_coupling_step* step) {
    step->event(step, 0, 3.5);
    step->event(step, 1, 9);  // not theirs
    return swage_result{SWAGE_OK};
  };
  s.run(1);
  ASSERT_EQ(s.engine().events().size(), 1u);
  EXPECT_EQ(s.engine().events()[0].event, 0u);
  EXPECT_EQ(s.engine().events()[0].value, 3.5);
}

}  // namespace
}  // namespace swage::step
