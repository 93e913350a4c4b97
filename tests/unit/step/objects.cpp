// SPDX-License-Identifier: Apache-2.0
#include "step/objects.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "fake_scene.hpp"
#include "scene/room.hpp"

namespace swage::step {
namespace {

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

const host::Instance& instance(FakeScene& s, int object) {
  return *s.rig.objects[static_cast<std::size_t>(object)].instance;
}

// 1 mg under 1 uN for 10 ms: v = F t / m = 0.01 m/s
TEST(Objects, ForcesMoveBodies) {
  FakeScene s;
  s.ball_.forces = [](const swage_object_step* step) {
    step->F_B_W[0].f.x += 1e-6;
    return swage_result{SWAGE_OK};
  };
  s.run(10);
  EXPECT_NEAR(s.rig.world.V_WB[1].v.x, 0.01, 1e-12);
}

TEST(Objects, SeeStepTimeAndTheirOwnSlices) {
  FakeScene s;
  s.ball_.forces = [](const swage_object_step* step) {
    EXPECT_EQ(step->n_body, 1u);
    EXPECT_EQ(step->n_state, 2u);
    EXPECT_EQ(step->n_signal, 1u);
    EXPECT_DOUBLE_EQ(step->time_s, static_cast<double>(step->step) * 1e-3);
    step->state[1] = static_cast<double>(step->step);
    return swage_result{SWAGE_OK};
  };
  s.run(4);
  EXPECT_EQ(s.rig.world.plugin_state[1], 3);
}

TEST(Objects, DiscardDropsTheForcesOfThisStepOnly) {
  FakeScene s;
  s.ball_.forces = [](const swage_object_step* step) {
    step->F_B_W[0].f.x = 1e-6;
    return swage_result{step->step == 1 ? SWAGE_DISCARD : SWAGE_OK};
  };
  s.run(3);
  EXPECT_NEAR(s.rig.world.V_WB[1].v.x, 2e-3, 1e-12);
  EXPECT_EQ(instance(s, 1).quarantined.load(), 0u);
}

// whatever an object writes that is no number, or beyond all reason, costs it its freedom and nobody else's
TEST(Objects, NonsenseIsQuarantinedAndStandsStill) {
  const auto give = [](double f) {
    return [f](const swage_object_step* step) {
      if (step->step == 5) step->F_B_W[0].f.y = f;
      step->F_B_W[0].f.x = 1e-6;
      return swage_result{SWAGE_OK};
    };
  };
  for (const double nonsense : {kNaN, 1e30, -std::numeric_limits<double>::infinity()}) {
    FakeScene s;
    s.ball_.forces = give(nonsense);
    s.run(5);
    const double x = s.ball().p.x;
    EXPECT_GT(x, 0);
    s.run(5);
    EXPECT_EQ(s.ball().p.x, x);
    EXPECT_EQ(s.rig.world.V_WB[1].v.x, 0);
    EXPECT_EQ(instance(s, 1).fault_call.load(), host::Call::kForces);
    EXPECT_EQ(instance(s, 1).quarantine_step.load(), 5u);
    EXPECT_EQ(instance(s, 0).quarantined.load(), 0u);
    EXPECT_EQ(s.engine().quarantined(), 1u);
  }
}

// a thing dropped beside the table fell for 14 s, a kilometre, and then its plugin was blamed
TEST(Objects, WhatLeavesTheRoomStandsThereUntilItIsPutBack) {
  FakeScene s;
  const double room = scene::room(s.rig.world);
  s.ball_.forces = [](const swage_object_step* step) {
    step->F_B_W[0].f.x = 1e-4;  // on 1 mg: 100 m/s2
    return swage_result{SWAGE_OK};
  };
  s.run(1000);  // 50 m, if nothing held it
  const double x = s.ball().p.x;
  EXPECT_GT(x, room);
  EXPECT_LT(x, 1.1 * room);
  EXPECT_EQ(s.rig.world.V_WB[1].v.x, 0);
  EXPECT_EQ(s.engine().quarantined(), 0u) << "nobody is to blame";
  s.run(10);
  EXPECT_EQ(s.ball().p.x, x);

  Command back;
  back.kind = CommandKind::kResetObject;
  back.object = 1;
  s.engine().push(back);
  s.run(10);
  EXPECT_LT(s.ball().p.x, 0.1 * room);
  EXPECT_GT(s.rig.world.V_WB[1].v.x, 0) << "and moves again";
}

TEST(Objects, AThrowIsStoppedAndCounted) {
  FakeScene s;
  s.ball_.finish = [](const swage_object_step*) -> swage_result { throw 7; };
  s.run(3);
  EXPECT_EQ(instance(s, 1).fault.load(), host::FaultKind::kFault);
  EXPECT_EQ(instance(s, 1).quarantine_step.load(), 0u);
}

TEST(Objects, SignalsMustBeNumbers) {
  FakeScene s;
  s.ball_.finish = [](const swage_object_step* step) {
    step->signal[0] = kNaN;
    return swage_result{SWAGE_OK};
  };
  s.run(1);
  EXPECT_EQ(instance(s, 1).fault_call.load(), host::Call::kFinish);
  EXPECT_EQ(s.rig.world.signal[1], 0);
}

// an object with mechanics of its own writes poses; what is not a pose is put back
TEST(Objects, OwnMechanicsAreLookedAt) {
  FakeScene s;
  s.rig.world.body[1].motion = SWAGE_MOTION_FLEXIBLE;
  s.rig.objects[1].solver = &s.ball_.solver;
  s.ball_.advance = [](const swage_object_step* step) {
    step->X_WB[0].p.x += 1e-6;
    if (step->step == 3) step->X_WB[0].p.y = kNaN;
    return swage_result{SWAGE_OK};
  };
  s.run(3);
  EXPECT_NEAR(s.ball().p.x, 3e-6, 1e-18);
  s.run(3);
  EXPECT_NEAR(s.ball().p.x, 3e-6, 1e-18);
  EXPECT_EQ(s.ball().p.y, 0);
  EXPECT_EQ(instance(s, 1).fault_call.load(), host::Call::kAdvance);
}

TEST(Objects, ResetPutsOneBack) {
  FakeScene s;
  int resets = 0;
  s.ball_.forces = [](const swage_object_step* step) {
    step->F_B_W[0].f.x = 1e-6;
    step->state[0] += 1;
    return swage_result{SWAGE_OK};
  };
  s.ball_.reset = [&](const swage_object_step* step) {
    EXPECT_EQ(step->state[0], 0);
    step->state[1] = 42;
    ++resets;
  };
  s.run(10);
  EXPECT_EQ(resets, 1);  // at the start
  Command reset;
  reset.kind = CommandKind::kResetObject;
  reset.object = 1;
  s.engine().push(reset);
  s.run(1);
  EXPECT_EQ(resets, 2);
  EXPECT_LT(s.ball().p.x, 2e-6);  // one step under its force; ten made 5e-5
  EXPECT_EQ(s.rig.world.plugin_state[0], 1);
  EXPECT_EQ(s.rig.world.plugin_state[1], 42);
  const judge::Event& told = s.engine().events()[0];
  EXPECT_EQ(s.rig.script.events[told.event].id, "host.reset");
  EXPECT_EQ(told.value, 1);
  reset.object = 99;
  s.engine().push(reset);
  s.run(1);
  EXPECT_TRUE(s.engine().events().empty());
}

}  // namespace
}  // namespace swage::step
